/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_FLAT_H
#define CSG_TILE_FLAT_H

/*
 * What matters of one intersection of leaves in the parts that a tile is cut into, in all of them
 * at once: a plate with holes, and what most tiles of other objects come to.
 */

#include "csg/tree.h"
#include "tile/range.h"

/* By part; 0: no. */
struct csg_flat {
    double opaque[CSG_TILE_LANES]; /* all rays have met the object somewhere */
    double empty[CSG_TILE_LANES];  /* nothing of it is left */
};

/* Narrows the ranges, by node of the tree, to the keys at which leaves matter; those that do not
 * matter in a part are nowhere there. has_front: what is behind a front does not. */
void csg_flat_judge(const struct csg_tree *tree, struct csg_leaf_ranges *ranges, double far,
                    bool has_front, struct csg_flat *flat);

#endif
