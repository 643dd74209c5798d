/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_CONVEX_H
#define CSG_PLANE_CONVEX_H

#include "plane/drawing.h"

/*
 * Replaces the subtree at node, the last of the drawing, by one convex polygon if it is an
 * intersection of several, and none of them is a disc. Swept, n half-planes would be n^2 levels of
 * n edges each. false: out of memory.
 */
bool csg_drawing_intersect(struct csg_drawing *drawing, uint32_t node);

#endif
