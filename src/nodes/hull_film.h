/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_HULL_FILM_H
#define CSG_NODES_HULL_FILM_H

#include "csg/part.h"
#include "nodes/sets.h"

/*
 * The hull of points that lie in a plane but for their rounding: OpenSCAD's kernel, which is exact,
 * makes a solid of them, all but without volume, and here it is a face that shows from both sides.
 * Points that lie in a plane exactly have no hull, there as here. false: out of memory.
 */
bool csg_hull_film(const struct csg_sets *sets, const struct csg_points *points,
                   struct csg_part *part);

#endif
