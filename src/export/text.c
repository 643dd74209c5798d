/* SPDX-License-Identifier: MIT */
#include "export/text.h"

#include <stdarg.h>
#include <string.h>

/* Deeper levels are not indented further: a tree of depth 1000 would be mostly blanks. */
#define MAX_INDENT 20

static void indent(struct csg_text *text)
{
    fprintf(text->file, "%*s", 2 * (text->depth < MAX_INDENT ? text->depth : MAX_INDENT), "");
}

void csg_text_line(struct csg_text *text, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    indent(text);
    vfprintf(text->file, format, args);
    fputc('\n', text->file);
    va_end(args);
}

void csg_text_open(struct csg_text *text, const char *head)
{
    csg_text_line(text, "%s {", head);
    text->depth++;
}

void csg_text_close(struct csg_text *text)
{
    text->depth--;
    csg_text_line(text, "}");
}

const char *csg_text_number(char to[CSG_TEXT_NUMBER], double value)
{
    snprintf(to, CSG_TEXT_NUMBER, "%.15g", value == 0 ? 0 : value);
    char *separator = strpbrk(to, ",");
    if (separator)
        *separator = '.';
    return to;
}

const char *csg_text_vector(char to[CSG_TEXT_VECTOR], struct csg_vec3 v)
{
    char x[CSG_TEXT_NUMBER], y[CSG_TEXT_NUMBER], z[CSG_TEXT_NUMBER];
    snprintf(to, CSG_TEXT_VECTOR, "<%s, %s, %s>", csg_text_number(x, v.x), csg_text_number(y, v.y),
             csg_text_number(z, v.z));
    return to;
}
