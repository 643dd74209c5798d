/* SPDX-License-Identifier: MIT */
#ifndef CSG_REFERENCE_BOUNDS_H
#define CSG_REFERENCE_BOUNDS_H

/*
 * What a line need not ask: subtrees whose leaves' boxes it misses. Along such a line a subtree is
 * what it is where no leaf is.
 */

#include "carrier/box_tree.h"
#include "csg/scene.h"

struct csg_node_bounds {
    struct csg_box box; /* of the leaves below, grown by what a shared carrier may be off */
    bool inside;        /* what the node is outside of all of them */
    uint32_t crowd;     /* of a node with many children: crowds[crowd - 1]; 0: none */
};

/* Those children of a node that do not matter to it where a line misses them, found by place; and
 * the others. */
struct csg_child_crowd {
    struct csg_box_tree tree; /* items: places in children */
    uint32_t *children;
    size_t num; /* in the tree; the others are behind them */
    size_t num_others;
};

struct csg_tree_bounds {
    struct csg_node_bounds *nodes[CSG_NUM_LAYERS]; /* as those of the scene's trees */
    CSG_ARRAY(struct csg_child_crowd) crowds;
};

/* false: out of memory. */
bool csg_tree_bounds_init(struct csg_tree_bounds *bounds, const struct csgcast_scene *scene);
void csg_tree_bounds_finish(struct csg_tree_bounds *bounds);

#endif
