/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_OUTLINE_H
#define CSG_PLANE_OUTLINE_H

#include "plane/sweep.h"

/* Replaces the subtree at node, the last of the drawing, by one figure of OpenSCAD's facets: its
 * contours do not cross and have the inside to their left. */
enum csg_sweep_result csg_drawing_evaluate(struct csg_drawing *drawing, uint32_t node);

#endif
