/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_BOX_TREE_H
#define CSG_CARRIER_BOX_TREE_H

/*
 * Boxes, found by place. They are sorted along a curve that stays in one neighbourhood for long
 * (Morton 1966), and each box of a level above holds so many that follow each other.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/linear.h"

/* Zero-initialise it. */
struct csg_box_tree {
    struct csg_box *boxes; /* all levels, the lowest first */
    uint32_t *items;       /* of the lowest level's boxes: their numbers */
    size_t begins[24];     /* where levels begin; the last one is one box */
    int num_levels;
};

/* Of boxes[item] for the given items; empty ones are left out. false: out of memory. */
bool csg_box_tree_init(struct csg_box_tree *tree, const struct csg_box *boxes, size_t num);
void csg_box_tree_finish(struct csg_box_tree *tree);

struct csg_box_tree_list {
    uint32_t *data;
    size_t num, capacity;
};

/* Whether what is looked for meets the box: where it meets one, it meets those around it. */
typedef bool csg_box_test_fn(const struct csg_box *box, const void *what);

/* Appends the boxes that it meets. false: out of memory. */
bool csg_box_tree_visit(const struct csg_box_tree *tree, csg_box_test_fn *meets, const void *what,
                        struct csg_box_tree_list *items);

/* The same for those that have a point in common with around. */
bool csg_box_tree_find(const struct csg_box_tree *tree, const struct csg_box *around,
                       struct csg_box_tree_list *items);

#endif
