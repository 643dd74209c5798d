/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_RANDOM_H
#define CSG_COMMON_RANDOM_H

/* Random numbers that are the same everywhere: SplitMix64 (Steele, Lea and Flood 2014). */

#include <stdint.h>

/* state: any number at first. */
static inline uint64_t csg_random(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

/* From lo to below hi. */
static inline double csg_random_between(uint64_t *state, double lo, double hi)
{
    return lo + (hi - lo) * (double)(csg_random(state) >> 11) * 0x1p-53;
}

#endif
