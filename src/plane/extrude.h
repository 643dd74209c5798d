/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_EXTRUDE_H
#define CSG_PLANE_EXTRUDE_H

/* linear_extrude: it distributes over the Booleans of the drawing, so discs become true cylinders
 * and cones, and a hole stays one solid that is taken away. */

#include "csg/part.h"
#include "plane/prism.h"

/* Polygons become unions of convex pieces, or, with surfaces, those of very many pieces one surface
 * (docs/surfaces.md). false: out of memory, or, with too_large set, a figure that is too large to
 * be cut. */
bool csg_extrude(struct csg_part *part, const struct csg_drawing *drawing,
                 const struct csg_lift *lift, bool surfaces, bool *too_large);

#endif
