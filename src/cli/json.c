/* SPDX-License-Identifier: MIT */
#include "json.h"

#include <math.h>

/*
 * Quotes, backslashes and control characters are escaped. Other bytes pass as they are: file names
 * in UTF-8 stay UTF-8.
 */
static void print_string(FILE *file, const char *text)
{
    fputc('"', file);
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\')
            fprintf(file, "\\%c", c);
        else if (c < 0x20 || c == 0x7f)
            fprintf(file, "\\u%04x", (unsigned)c);
        else
            fputc(c, file);
    }
    fputc('"', file);
}

static void begin_member(struct csg_json *json, const char *key)
{
    if (json->depth > 0)
        fprintf(json->file, "%s\n%*s", json->first ? "" : ",", 2 * json->depth, "");
    json->first = false;
    if (key) {
        print_string(json->file, key);
        fputs(": ", json->file);
    }
}

static void open_with(struct csg_json *json, const char *key, char bracket)
{
    begin_member(json, key);
    fputc(bracket, json->file);
    json->depth++;
    json->first = true;
}

static void close_with(struct csg_json *json, char bracket)
{
    json->depth--;
    if (!json->first)
        fprintf(json->file, "\n%*s", 2 * json->depth, "");
    fprintf(json->file, "%c%s", bracket, json->depth ? "" : "\n");
    json->first = false;
}

void csg_json_open(struct csg_json *json, const char *key)
{
    open_with(json, key, '{');
}

void csg_json_close(struct csg_json *json)
{
    close_with(json, '}');
}

void csg_json_list_open(struct csg_json *json, const char *key)
{
    open_with(json, key, '[');
}

void csg_json_list_close(struct csg_json *json)
{
    close_with(json, ']');
}

void csg_json_string(struct csg_json *json, const char *key, const char *value)
{
    begin_member(json, key);
    print_string(json->file, value);
}

void csg_json_size(struct csg_json *json, const char *key, size_t value)
{
    begin_member(json, key);
    fprintf(json->file, "%zu", value);
}

void csg_json_bool(struct csg_json *json, const char *key, bool value)
{
    begin_member(json, key);
    fputs(value ? "true" : "false", json->file);
}

static void print_number(FILE *file, double value)
{
    if (isfinite(value))
        fprintf(file, "%.17g", value);
    else
        fputs("null", file);
}

void csg_json_number(struct csg_json *json, const char *key, double value)
{
    begin_member(json, key);
    print_number(json->file, value);
}

void csg_json_vector(struct csg_json *json, const char *key, const double value[3])
{
    begin_member(json, key);
    for (int i = 0; i < 3; i++) {
        fputs(i ? ", " : "[", json->file);
        print_number(json->file, value[i]);
    }
    fputc(']', json->file);
}
