/* SPDX-License-Identifier: MIT */
#ifndef CSG_SOLIDS_SAMPLE_H
#define CSG_SOLIDS_SAMPLE_H

#include <stddef.h>

#include "solids/shape.h"

/*
 * Up to max points on the quadric surface of shape, in the space of the shape, spread over the part
 * that bounds the solid: within its planes and, where they are finite, its bounds; else within a
 * few canonical units of the centre or vertex. Always the same points for the same shape.
 * Returns their number: 0 without a quadric, less than max where little of the surface is there.
 */
size_t csg_shape_sample(const struct csg_shape *shape, struct csg_vec3 *points, size_t max);

#endif
