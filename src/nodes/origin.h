/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_ORIGIN_H
#define CSG_NODES_ORIGIN_H

/*
 * Where the leaves come from: what an edit starts from. A scene only keeps its text; the first edit
 * reads it again and keeps what the first reading threw away.
 */

#include "csg/scene.h"
#include "nodes/nodes.h"

struct csg_origin {
    struct csg_shape shape; /* in the node's own space; owned */
    struct csg_space space; /* around the node */
    uint32_t first, num;    /* the leaves of the node */
    uint32_t node;          /* in the document */
    bool is_nothing;        /* parameters leave nothing: shape means nothing */
    bool is_compound;       /* the node becomes a part */
    bool is_inside;         /* the node is in another one that becomes a part, and marked there */
};

/* Where the part of a node stands in a tree as the text has it. */
struct csg_part_place {
    uint32_t node, at;
    uint8_t layer;
    bool negated; /* complemented */
};

struct csg_origins {
    struct csg_origin *data; /* by leaf */
    size_t num, capacity;
    CSG_ARRAY(struct csg_part_place) places; /* by layer, in the order of the trees */
    bool are_placed;                         /* some shape depends on what is around its node */
};

/* OpenSCAD knows a colour of which components are unset; here it is set or not. */
void csg_leaf_set_color(struct csg_leaf *leaf, const float color[4]);

void csg_origins_finish(struct csg_origins *origins);

/* shape is copied. false: out of memory. */
bool csg_origins_add(struct csg_origins *origins, const struct csg_shape *shape,
                     const struct csg_space *space);

#endif
