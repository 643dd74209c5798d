/* SPDX-License-Identifier: MIT */
#ifndef IDEAL_TEXT_H
#define IDEAL_TEXT_H

/* A growing text, and seeded random numbers. */

#include <stddef.h>
#include <stdint.h>

struct text {
    char *data; /* zero-terminated once something was put */
    size_t num, capacity;
};

#ifdef __GNUC__
__attribute__((format(printf, 2, 3)))
#endif
void text_put(struct text *text, const char *format, ...);
void text_free(struct text *text);

/* Lengths in the format that a set of scenes uses: 17 digits, or OpenSCAD's six. */
enum text_digits { TEXT_EXACT, TEXT_SIX };
void text_number(struct text *text, double value, enum text_digits digits);
void text_vector(struct text *text, double x, double y, double z, enum text_digits digits);

struct dice {
    uint64_t state;
};

double dice_between(struct dice *dice, double lo, double hi);
int dice_pick(struct dice *dice, int num); /* 0 to num - 1 */

#endif
