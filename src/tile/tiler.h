/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_TILER_H
#define CSG_TILE_TILER_H

/* Cutting an object into tiles: what is at hand, and what of its tree matters in a tile. */

#include "csg/tree.h"
#include "tile/bands.h"
#include "tile/range.h"
#include "tile/scan.h"

/* A rectangle that is still to be drawn or cut, with the tree that matters in it. */
struct csg_tile_task {
    int lo[2], hi[2]; /* pixels [lo, hi) */
    struct csg_tree tree;
    struct csg_band_list bands; /* of stacks, that rays may meet */
    size_t before[2];           /* leaves that mattered in twice and in four times the area */
    bool flat;                  /* the tree is: see csg_tiler_is_flat */
};

struct csg_tiler {
    struct csg_terms *terms;
    const struct csg_draw *draw;
    CSG_ARRAY(struct csg_tile_task) tasks;
    CSG_ARRAY(struct csg_tree) spare; /* memory of tasks that are done */
    struct csg_tree_room room;
    CSG_ARRAY(struct csg_leaf_range) ranges; /* by leaf of the terms, of the tile at hand */
    CSG_ARRAY(struct csg_range) nodes;       /* keys that a node's set is within */
    CSG_ARRAY(struct csg_range) contexts;    /* keys at which a node matters */
    CSG_ARRAY(uint32_t) members;             /* for csg_dominate */
    CSG_ARRAY(struct csg_leaf_range) stacks;
    CSG_ARRAY(bool) planes;
    CSG_ARRAY(double) keys; /* by node, for csg_front_find */
    struct csg_scan scan;
    size_t max_texels; /* of the frame, from which on tiles are not cut further */
    bool fine;         /* of the area */
    bool opaque;       /* the tile at hand: the object has certainly begun somewhere in all of it */
};

/* Of a leaf of the tree at hand. */
static inline struct csg_leaf_range *csg_tiler_range(const struct csg_tiler *tiler, uint32_t leaf)
{
    return &tiler->ranges.data[tiler->terms->index[leaf]];
}

struct csg_tile_box csg_tiler_box(const struct csg_tiler *tiler, const struct csg_tile_task *task);

/* Whether the tree is one intersection of leaves, none of them spare: a plate with holes, and what
 * most tiles of other objects come to. */
bool csg_tiler_is_flat(const struct csg_tree *tree);

/* Leaves of the task's tree what matters in its tile; no nodes: nothing does. Finds the ranges of
 * the leaves that stay, and whether the tile is opaque. false: out of memory. */
bool csg_tiler_fold(struct csg_tiler *tiler, struct csg_tile_task *task);

#endif
