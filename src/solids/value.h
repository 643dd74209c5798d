/* SPDX-License-Identifier: MIT */
#ifndef CSG_SOLIDS_VALUE_H
#define CSG_SOLIDS_VALUE_H

/* The arguments of a node: values as OpenSCAD writes them, and typed access with defaults. */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/log.h"

enum csg_value_type {
    CSG_VALUE_UNDEF,
    CSG_VALUE_BOOL,
    CSG_VALUE_NUMBER, /* may be nan or infinite */
    CSG_VALUE_STRING,
    CSG_VALUE_VECTOR,
};

struct csg_value {
    uint8_t type; /* enum csg_value_type */
    bool boolean; /* BOOL */
    /* NUMBER: half a unit of the sixth digit where the number was written with five or six
     * significant digits and so may be rounded; 0 where it stands as meant. */
    float rounding;
    uint32_t line, column; /* where it stands in the text, from 1 */
    union {
        double number;
        const char *string;            /* zero-terminated */
        const struct csg_value *items; /* VECTOR: num of them */
    };
    size_t num; /* VECTOR: items; STRING: bytes */
};

struct csg_arg {
    const char *name; /* NULL: positional */
    struct csg_value value;
};

struct csg_args {
    const struct csg_arg *args;
    size_t num;
    const char *parameters; /* the positional order, see csg_solid_ops */
    enum csgcast_facets facets;
    const struct csg_log *log;
    const char *file;      /* for messages */
    uint32_t line, column; /* of the node */
    const char *node;      /* its name */
};

/* The argument of that name, or at its position; NULL when absent or undef. */
const struct csg_value *csg_args_find(const struct csg_args *args, const char *name);

/* The number of that name; fallback when absent or not a number. rounding, if not NULL, gets the
 * value's rounding added. */
double csg_args_number(const struct csg_args *args, const char *name, double fallback,
                       double *rounding);

/* Whether the argument of that name is true, or a number that is not 0. */
bool csg_args_bool(const struct csg_args *args, const char *name);

/* Reads num numbers of a vector; false when value is NULL, not a vector of exactly num numbers. */
bool csg_value_numbers(const struct csg_value *value, size_t num, double *numbers,
                       double *rounding);

/* "file:line:column: node: text" as an error; returns CSG_READ_ERROR's value for brevity. */
int csg_args_error(const struct csg_args *args, const char *format, ...) CSG_PRINTF(2, 3);

#endif
