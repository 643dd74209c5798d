/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_DRAWINGS_H
#define CSG_NODES_DRAWINGS_H

/* From the nodes below an extrusion to a drawing. */

#include "nodes/walk.h"
#include "plane/drawing.h"

/*
 * The union of what is below node, in the space of node. What is three-dimensional is left out with
 * a warning. in_boolean: see struct csg_space. false, with a message, when memory is out.
 */
bool csg_drawing_read(struct csg_walk *walk, uint32_t node, bool in_boolean,
                      struct csg_drawing *drawing);

/* Likewise of the node itself. */
bool csg_drawing_read_node(struct csg_walk *walk, uint32_t node, bool in_boolean,
                           struct csg_drawing *drawing);

/* Moves the figures from draw on, the last of the drawing, to where their node is; a space without
 * an inverse leaves nothing. false, with a message, when memory is out. */
bool csg_drawing_place(struct csg_walk *walk, struct csg_drawing *drawing, uint32_t draw,
                       const struct csg_space *space);

#endif
