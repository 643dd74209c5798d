/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_FLATTEN_H
#define CSG_NODES_FLATTEN_H

/* Nodes that make a new drawing of the one in them; each is the flatten of a csg_node_ops. */

#include "nodes/walk.h"
#include "plane/drawing.h"

bool csg_flatten_hull(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                      struct csg_drawing *drawing, uint32_t draw);
bool csg_flatten_offset(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                        struct csg_drawing *drawing, uint32_t draw);

bool csg_flatten_minkowski(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                           struct csg_drawing *drawing, uint32_t draw);
bool csg_flatten_resize(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                        struct csg_drawing *drawing, uint32_t draw);
bool csg_flatten_fill(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                      struct csg_drawing *drawing, uint32_t draw);

#endif
