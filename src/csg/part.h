/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_PART_H
#define CSG_CSG_PART_H

/*
 * What a node becomes that is no single shape: a Boolean tree over shapes, all of them in the
 * node's own space. A part is built from the root down: open, add, close.
 */

#include "csg/tree.h"
#include "solids/shape.h"

/* One node may not become more shapes than this. */
#define CSG_PART_MAX_SHAPES 20000

/* Zero-initialise it. */
struct csg_part {
    CSG_ARRAY(struct csg_shape) shapes; /* owned */
    struct csg_tree tree;               /* leaf: index into shapes */
    CSG_ARRAY(uint32_t) open;           /* nodes that wait for their close */
    bool is_too_large;                  /* shapes beyond the limit were left out */
    bool has_flat;                      /* shapes that a singular matrix left no volume of were */
};

void csg_part_finish(struct csg_part *part);

/* Opens a union or, if is_and, an intersection. false: out of memory. */
bool csg_part_open(struct csg_part *part, bool is_and);
void csg_part_close(struct csg_part *part);

/* Adds a shape, or its complement. The part takes the shape over, also when memory is out, which
 * is what false means. */
bool csg_part_add(struct csg_part *part, struct csg_shape *shape, bool negated);
/* Adds all of other, or its complement; other is empty afterwards. */
bool csg_part_append(struct csg_part *part, struct csg_part *other, bool negated);

/* Around all shapes, whatever becomes of them. */
struct csg_box csg_part_box(const struct csg_part *part);

/* Whether it is a union of shapes. */
bool csg_part_is_union(const struct csg_part *part);

/* The next leaf, from the node i on, that no difference or intersection cuts; the number of nodes
 * where there is none. */
size_t csg_part_next_uncut(const struct csg_part *part, size_t i);

#endif
