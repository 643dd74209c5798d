/* SPDX-License-Identifier: MIT */
#ifndef CSG_EXPORT_TEXT_H
#define CSG_EXPORT_TEXT_H

/* Text with nested braces, written line by line. Errors show in ferror(text->file). */

#include <stdio.h>

#include "common/linear.h"
#include "common/log.h"

struct csg_text {
    FILE *file;
    int depth; /* of braces */
};

/* A line, indented; %s %d %zu only: numbers go through csg_text_number. */
void csg_text_line(struct csg_text *text, const char *format, ...) CSG_PRINTF(2, 3);

/* "HEAD {" and deeper; the other way round. */
void csg_text_open(struct csg_text *text, const char *head);
void csg_text_close(struct csg_text *text);

#define CSG_TEXT_NUMBER 32

/* With 15 digits and a point, whatever the locale says. Returns to. */
const char *csg_text_number(char to[CSG_TEXT_NUMBER], double value);

#define CSG_TEXT_VECTOR (3 * CSG_TEXT_NUMBER + 8)

/* "<x, y, z>". Returns to. */
const char *csg_text_vector(char to[CSG_TEXT_VECTOR], struct csg_vec3 v);

#endif
