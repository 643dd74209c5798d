/* SPDX-License-Identifier: MIT */
#ifndef CSG_SOLIDS_HALFSPACE_HALFSPACE_H
#define CSG_SOLIDS_HALFSPACE_HALFSPACE_H

#include "solids/shape.h"

/* Makes shape the points with dot(normal, x) <= offset; normal need not be a unit vector but must
 * not be zero. false: out of memory. */
bool csg_halfspace_fill(struct csg_shape *shape, struct csg_vec3 normal, double offset);

#endif
