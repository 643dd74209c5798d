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

void csg_json_open(struct csg_json *json, const char *key)
{
    begin_member(json, key);
    fputc('{', json->file);
    json->depth++;
    json->first = true;
}

void csg_json_close(struct csg_json *json)
{
    json->depth--;
    if (!json->first)
        fprintf(json->file, "\n%*s", 2 * json->depth, "");
    fputs(json->depth ? "}" : "}\n", json->file);
    json->first = false;
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

void csg_json_vector(struct csg_json *json, const char *key, const double value[3])
{
    begin_member(json, key);
    for (int i = 0; i < 3; i++) {
        fputs(i ? ", " : "[", json->file);
        if (isfinite(value[i]))
            fprintf(json->file, "%.17g", value[i]);
        else
            fputs("null", json->file);
    }
    fputc(']', json->file);
}

void csg_json_number(struct csg_json *json, const char *key, double value)
{
    begin_member(json, key);
    if (isfinite(value))
        fprintf(json->file, "%.17g", value);
    else
        fputs("null", json->file);
}
