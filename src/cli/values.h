/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_VALUES_H
#define CSG_CLI_VALUES_H

/* Reading the values of options. Nothing here prints. */

#include <stdbool.h>
#include <stddef.h>

/* A whole number and nothing else. */
bool csg_value_int(const char *text, int *value);

/* A number of frames. What was expected instead; NULL when all is well. */
const char *csg_value_frames(const char *text, int *num);

/* A finite number and nothing else. */
bool csg_value_double(const char *text, double *value);

/* Numbers separated by commas, at most max. Their count, 0 when malformed or too many. */
size_t csg_value_list(const char *text, double *values, size_t max);

struct csg_value_name {
    const char *name;
    int value;
};

/* Looks text up in a table that ends with a NULL name. */
bool csg_value_enum(const char *text, const struct csg_value_name *names, int *value);

#endif
