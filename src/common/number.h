/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_NUMBER_H
#define CSG_COMMON_NUMBER_H

#include <stdbool.h>
#include <stddef.h>

/* The longest number read, in characters: any double can be written exactly with fewer. */
#define CSG_NUMBER_LENGTH_MAX 1100

struct csg_number {
    double value;
    float rounding; /* see struct csg_value */
};

/*
 * Reads digits [. digits] [e [+-] digits], whatever the locale says. false when the length bytes
 * of text are anything else.
 */
bool csg_number_read(const char *text, size_t length, struct csg_number *number);

/* Likewise with a sign in front, or none. What is beyond a double is no number. */
bool csg_number_read_signed(const char *text, size_t length, double *value);

#endif
