/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_RESIZE_H
#define CSG_PLANE_RESIZE_H

#include "plane/sweep.h"

/*
 * The factors by which resize(newsize, auto) of OpenSCAD 2021.01 scales what has that size along
 * num axes: a newsize of 0 keeps the size, or, with auto, the proportions to the largest newsize.
 */
void csg_resize_factors(const double *newsize, const bool *automatic, const double *size, int num,
                        double *factors);

/* What it does to a Boolean of solids: a negative newsize mirrors. */
void csg_resize_factors_signed(const double *newsize, const bool *automatic, const double *size,
                               int num, double *factors);

/* Scales the subtree at node, the last of the drawing. Its size is that of OpenSCAD's facets. */
enum csg_sweep_result csg_drawing_resize(struct csg_drawing *drawing, uint32_t node,
                                         const double newsize[2], const bool automatic[2]);

/* Replaces the subtree at node by its outline without holes. */
enum csg_sweep_result csg_drawing_fill(struct csg_drawing *drawing, uint32_t node);

#endif
