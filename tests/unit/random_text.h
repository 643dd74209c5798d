/* SPDX-License-Identifier: MIT */
#ifndef TESTS_UNIT_RANDOM_TEXT_H
#define TESTS_UNIT_RANDOM_TEXT_H

/* Random numbers of a seed, and scenes that are made with them. */

#include <stddef.h>

static inline unsigned random_below(unsigned long long *state, unsigned n)
{
    *state = *state * 6364136223846793005ull + 1442695040888963407ull;
    return (unsigned)(*state >> 33) % n;
}

struct text {
    char *data;
    size_t num;
};

#endif
