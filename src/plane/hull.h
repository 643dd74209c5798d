/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_HULL_H
#define CSG_PLANE_HULL_H

#include "plane/sweep.h"

/* Replaces the subtree at node, the last of the drawing, by its convex hull: a polygon, united with
 * the discs that reach to its edge. */
enum csg_sweep_result csg_drawing_hull(struct csg_drawing *drawing, uint32_t node);

#endif
