/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_DOMINATE_H
#define CSG_TILE_DOMINATE_H

/*
 * Solids inside of solids. Ranges tell two slanted faces apart only where they are further from
 * each other than the tile is deep; here faces are compared pixel by pixel, as the affine terms
 * they are. Of a union, what is inside another operand everywhere in the tile does not matter; of
 * an intersection, what holds another one.
 */

#include "csg/tree.h"
#include "tile/range.h"

/*
 * Marks leaves of tree in terms->known that others of the same node make superfluous; returns
 * whether there are any. ranges: of the terms' leaves, in the tile. room: for twice as many as tree
 * has nodes.
 */
bool csg_dominate(const struct csg_terms *terms, const struct csg_tree *tree,
                  const struct csg_leaf_range *ranges, const struct csg_tile_box *tile,
                  uint32_t *room);

#endif
