/* SPDX-License-Identifier: MIT */
#ifndef TWIN_RANDOM_SCENE_H
#define TWIN_RANDOM_SCENE_H

/* Seeded random scenes as .csg text: trees of all kinds of solid under random maps. */

#include <stddef.h>
#include <stdint.h>

struct random_state {
    uint64_t state;
};

/* Uniform in [lo, hi). */
double random_between(struct random_state *random, double lo, double hi);

struct random_params {
    int depth;   /* of the Boolean tree, at most */
    int leaves;  /* at most */
    int grid;    /* sizes and places are multiples of 1 / grid, so that faces coincide; 0: not */
    int bounded; /* leave unbounded solids out */
};

/* malloc'ed, zero-terminated. */
char *random_scene(struct random_state *random, const struct random_params *params);

#endif
