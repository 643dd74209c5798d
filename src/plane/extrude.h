/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_EXTRUDE_H
#define CSG_PLANE_EXTRUDE_H

/* linear_extrude: it distributes over the Booleans of the drawing, so discs become true cylinders
 * and cones, and a hole stays one solid that is taken away. */

#include "csg/part.h"
#include "plane/prism.h"

/* From more convex pieces on a surface of triangles is faster to draw (docs/surfaces.md): of what
 * objects are cut from, of what stands by itself, each piece of which is an object, and of what is
 * blended, all of whose pieces are one object with two sides. */
#define CSG_EXTRUDE_PIECES 100
#define CSG_EXTRUDE_ALONE_PIECES 20
#define CSG_EXTRUDE_BLENDED_PIECES 3

/* Of so many extrusions each is small on the screen: what they are cut from, or cut, is a surface
 * as soon as what stands by itself. */
#define CSG_EXTRUDE_CROWD 32

/* So are the polygons of one drawing, as a page of text, that are more pieces than this together,
 * those of up to CSG_EXTRUDE_ALONE_PIECES not counted. */
#define CSG_EXTRUDE_CROWD_PIECES 4000

/* Polygons become unions of convex pieces, those of more than max_pieces one surface. part is empty.
 * false: out of memory, or, with too_large set, a figure that is too large to be cut. */
bool csg_extrude(struct csg_part *part, const struct csg_drawing *drawing,
                 const struct csg_lift *lift, size_t max_pieces, bool *too_large);

#endif
