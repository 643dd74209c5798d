/* SPDX-License-Identifier: MIT */
#ifndef CSG_SHARPNESS_ROUNDS_H
#define CSG_SHARPNESS_ROUNDS_H

/* The quadrics of an object, in an order in which those that are alike are neighbours. */

#include "common/keys.h"
#include "sharpness/sharpness.h"

struct csg_round {
    uint32_t carrier, leaf;
    bool turned;  /* what is taken away or flipped: the solid is on the carrier's other side */
    double place; /* where to look for those like it: a side of its box */
};

/* Zero-initialise it. */
struct csg_rounds {
    CSG_ARRAY(struct csg_round) all; /* in the order of the file */
    struct csg_keys keys;            /* by place */
};

/* Puts them into their order; where all are on one side of their solids there is nothing to note,
 * and none. false: out of memory. */
bool csg_rounds_sort(struct csg_rounds *rounds);

/* Notes gaps between those from begin to end of the order, in an object of that radius, and others
 * behind them that nearly coincide, with solids on different sides. marks: by leaf,
 * sharpness/wall.h. */
void csg_rounds_note(const struct csg_rounds *rounds, const struct csgcast_scene *scene,
                     size_t begin, size_t end, const uint8_t *marks, double radius,
                     struct csg_sharpness *sharp);

void csg_rounds_finish(struct csg_rounds *rounds);

#endif
