/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_WRAP_H
#define CSG_PLANE_WRAP_H

#include "plane/drawing.h"

/* Zero-initialise it. */
struct csg_flat_points {
    CSG_ARRAY(struct csg_vec2) list;
};

/* Keeps the corners of the convex hull, counter-clockwise. false: out of memory. */
bool csg_flat_points_wrap(struct csg_flat_points *points);

/* Appends a figure with the points for its one contour. false: out of memory. */
bool csg_flat_points_draw(struct csg_drawing *drawing, const struct csg_flat_points *points,
                          double rounding);

#endif
