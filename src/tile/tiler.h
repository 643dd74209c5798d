/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_TILER_H
#define CSG_TILE_TILER_H

/* Cutting an object into tiles: what is at hand, and what of its tree matters in a tile. */

#include "csg/tree.h"
#include "tile/bands.h"
#include "tile/flat.h"
#include "tile/range.h"
#include "tile/scan.h"
#include "tile/tile.h"

/* A rectangle that is still to be drawn or cut, with the tree that matters in it. */
struct csg_tile_task {
    int lo[2], hi[2]; /* pixels [lo, hi) */
    struct csg_tree tree;
    struct csg_band_list bands; /* of stacks, that rays may meet */
    size_t before[2];           /* leaves that mattered in twice and in four times the area */
    bool flat;                  /* the tree is: see csg_tiler_is_flat */
};

/* The rectangles that a task's one is cut into, and what their rays meet of its tree, by node. */
struct csg_tile_parts {
    int num, at; /* at: the one at hand */
    struct csg_rect rects[CSG_TILE_LANES];
    struct csg_tile_box tiles[CSG_TILE_LANES];
    struct csg_tile_boxes boxes; /* the same, for csg_ranges_of_leaf */
    CSG_ARRAY(struct csg_leaf_ranges) ranges;
    struct csg_flat flat;
};

/* Keys that a node's set is within, and its complement. */
struct csg_node_range {
    struct csg_range set, rest;
};

/* Zeroed before the first area; its arrays are for the next one, too. */
struct csg_tiler {
    struct csg_terms *terms;
    const struct csg_draw *draw;
    struct csg_tile_budget *budget; /* of the area */
    CSG_ARRAY(struct csg_tile_task) tasks;
    CSG_ARRAY(struct csg_tree) spare; /* memory of tasks that are done */
    struct csg_tree_room room;
    struct csg_tile_parts parts;
    CSG_ARRAY(struct csg_leaf_range) ranges; /* by leaf of the terms, of the tile at hand */
    CSG_ARRAY(uint32_t) origins;             /* ... made from this node's of the parts */
    CSG_ARRAY(struct csg_node_range) nodes;
    CSG_ARRAY(struct csg_range) contexts; /* keys at which a node matters */
    CSG_ARRAY(uint32_t) members;          /* for csg_dominate */
    CSG_ARRAY(struct csg_leaf_range) stacks;
    CSG_ARRAY(bool) planes;
    CSG_ARRAY(double) keys;   /* by node, for csg_front_find */
    CSG_ARRAY(uint8_t) known; /* of terms that share theirs with other threads' */
    struct csg_scan scan;
    size_t max_texels;   /* of the frame, from which on tiles are not cut further */
    bool fine;           /* of the area */
    int num_corner_cuts; /* likewise, see tile.c */
    bool opaque; /* the tile at hand: the object has certainly begun somewhere in all of it */
};

/* Of a leaf of the tree at hand. */
static inline struct csg_leaf_range *csg_tiler_range(const struct csg_tiler *tiler, uint32_t leaf)
{
    return &tiler->ranges.data[tiler->terms->index[leaf]];
}

static inline struct csg_rect csg_tile_rect(const struct csg_tile_task *task)
{
    return (struct csg_rect){{task->lo[0], task->lo[1]}, {task->hi[0], task->hi[1]}};
}

/* What the range of a leaf of planes and quadrics was made from. */
static inline const struct csg_leaf_ranges *csg_tiler_ranges(const struct csg_tiler *tiler,
                                                             uint32_t leaf)
{
    return &tiler->parts.ranges.data[tiler->origins.data[tiler->terms->index[leaf]]];
}

/* The part at hand. */
static inline const struct csg_tile_box *csg_tiler_box(const struct csg_tiler *tiler)
{
    return &tiler->parts.tiles[tiler->parts.at];
}

void csg_tiler_finish(struct csg_tiler *tiler);

/* ---- task.c ---- */

/* The side of the smallest tiles, in pixels. */
static inline int csg_tile_size(const struct csg_tiler *tiler)
{
    const int size = tiler->terms->params->tile_size;
    return size ? size : CSG_TILE_SIZE;
}

/* Gives the task, of which the rectangle is set, all that is seen of the object. false: out of memory. */
bool csg_task_start(struct csg_tiler *tiler, struct csg_tile_task *task);

/* Cuts into two or four, across the axes that have an edge of the larger step; returns how many.
 * Trees and bands are the task's. */
int csg_task_cut(const struct csg_tiler *tiler, const struct csg_tile_task *task,
                 struct csg_tile_task parts[CSG_TILE_LANES]);

/* Gives the part copies of its own; it is dropped where memory is out. */
bool csg_task_copy(struct csg_tiler *tiler, const struct csg_tile_task *whole,
                   struct csg_tile_task *part);

/* The memory of a tree that is not needed any more is for the next one. */
void csg_task_drop(struct csg_tiler *tiler, struct csg_tile_task *task);

/* ---- look.c ---- */

/* Whether the task's tile misses the leaf by its rectangle on the screen. */
bool csg_tiler_misses(const struct csg_tiler *tiler, const struct csg_tile_task *task,
                      uint32_t leaf);

/* Finds what the parts' rays meet of a task's tree. false: out of memory. */
bool csg_tiler_look(struct csg_tiler *tiler, const struct csg_tile_task *task);

/* Whether that tells what matters in the parts, too. */
static inline bool csg_task_is_judged(const struct csg_tiler *tiler,
                                      const struct csg_tile_task *task)
{
    return task->flat && tiler->terms->stacks.list.num == 0;
}

/* Finds the range of the leaf at node i of the tree that was looked at, in the part at hand. */
void csg_tiler_note_leaf(struct csg_tiler *tiler, uint32_t leaf, uint32_t i);

/* ---- fold.c ---- */

/* Whether the tree is one intersection of leaves, none of them spare: a plate with holes, and what
 * most tiles of other objects come to. */
bool csg_tiler_is_flat(const struct csg_tree *tree);

/* Leaves out of the task's tree what its tile misses by rectangles. false: out of memory. */
bool csg_tiler_sift(struct csg_tiler *tiler, struct csg_tile_task *task);

/* Leaves of the task's tree, which is the one that was looked at, what matters in the part at
 * hand, its tile; no nodes: nothing does. Finds the ranges of the leaves that stay, and whether
 * the tile is opaque. false: out of memory. */
bool csg_tiler_fold(struct csg_tiler *tiler, struct csg_tile_task *task);

#endif
