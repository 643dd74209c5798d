/* SPDX-License-Identifier: MIT */
#ifndef EXTREME_MEASURE_H
#define EXTREME_MEASURE_H

/* Errors of a picture against what the scene is by construction. */

#include <stddef.h>

#include "ideal/judge.h"

struct errors {
    double *data;
    size_t num, capacity;
    bool sorted;
};

struct measure {
    size_t rays;
    size_t misses;    /* a hit where there is nothing, or nothing where there is one; not where the
                       * ray goes exactly through a silhouette */
    double displaced; /* pixels that silhouettes must be off for these, at most */
    size_t outside;   /* of these, those not within a pixel of a silhouette */
    size_t other;     /* another surface, not within a pixel of a silhouette or crease */
    size_t nan;       /* pixels with a nan or infinite number where there must be none */
    struct errors depth;  /* relative to the distance; orthographic: or to the scene */
    struct errors normal; /* degrees */
    int x, y;             /* the last pixel of outside, other or nan */
};

/* extent: of the scene, which orthographic depths are related to at least: their zero may be
 * anywhere. */
void measure_add(struct measure *measure, const struct picture *picture,
                 const struct ideal_view *view, double extent);
void measure_free(struct measure *measure);

/* 0 to 1; 1 is the maximum. 0 without errors. */
double errors_quantile(struct errors *errors, double quantile);

#endif
