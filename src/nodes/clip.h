/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_CLIP_H
#define CSG_NODES_CLIP_H

#include "nodes/walk.h"
#include "plane/offset.h"

/*
 * Booleans and offsets of drawings with OpenSCAD's vertices, where those are wanted
 * (--facets=as-written): evaluated node by node with Clipper, on its grid.
 */

/* Whether they are wanted, and csgcast-clip.so is there. */
bool csg_clip_is_wanted(struct csg_walk *walk);

/* Whether csgcast-clip.so is there, wanted or not. */
bool csg_clip_is_there(struct csg_walk *walk);

/* Replaces the subtree at node, the last of the drawing, by one figure, an outline. Each of its
 * children is an operand. false, with a message, when memory is out. */
bool csg_clip_evaluate(struct csg_walk *walk, struct csg_drawing *drawing, uint32_t node);

/* Replaces the subtree at node, the last of the drawing, by what it becomes when its outline moves.
 * taken: it did; coordinates may be too large for it. false, with a message, when memory is out. */
bool csg_clip_offset(struct csg_walk *walk, struct csg_drawing *drawing, uint32_t node,
                     const struct csg_offset *offset, bool *taken);

#endif
