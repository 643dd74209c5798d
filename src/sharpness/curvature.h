/* SPDX-License-Identifier: MIT */
#ifndef CSG_SHARPNESS_CURVATURE_H
#define CSG_SHARPNESS_CURVATURE_H

#include "solids/shape.h"

/* The least radius of curvature of a quadric of which a box with a diagonal of that size can be
 * seen; infinite where it is flat. */
double csg_curvature(const struct csg_quadric *quadric, double size);

#endif
