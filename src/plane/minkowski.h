/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_MINKOWSKI_H
#define CSG_PLANE_MINKOWSKI_H

#include "plane/sweep.h"

/*
 * Replaces the subtree at node, a union and the last of the drawing, by the Minkowski sum of its
 * children. As in OpenSCAD 2021.01 nothing is the sum when the first child is empty or all others
 * are. A sum with one disc stays exact; else it is that of OpenSCAD's facets.
 */
enum csg_sweep_result csg_drawing_minkowski(struct csg_drawing *drawing, uint32_t node);

#endif
