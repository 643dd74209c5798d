/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_FRONT_H
#define CSG_TILE_FRONT_H

/*
 * Where an object has certainly begun for all rays of a tile: nothing behind that shows. It is
 * found as shaders find the first visible point (docs/pipeline.md), with what is certain of each
 * leaf.
 */

#include "csg/tree.h"
#include "tile/range.h"

/* Just behind a key. */
static inline double csg_behind(double key)
{
    return key + 1e-9 * (1 + fabs(key));
}

/* Keys tried: of objects with more in front of each other than that, what is behind stays. */
#define CSG_FRONT_JUMPS 32

/* Lowers *key to the first one at which every ray of the tile is inside; false: there is none
 * before it, or it was not found. ranges: of the terms' leaves, in the tile. room: for as many as
 * tree has nodes. */
bool csg_front_find(const struct csg_terms *terms, const struct csg_tree *tree,
                    const struct csg_leaf_range *ranges, double *room, double *key);

#endif
