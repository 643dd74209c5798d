/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_SECTION_H
#define CSG_PLANE_SECTION_H

#include "plane/drawing.h"

struct csg_surface;

/* Corners nearer to z = 0 than this share of the largest coordinate lie on it. */
#define CSG_SECTION_ON_PLANE 1e-12

/* Adds to the drawing what map, which leaves z alone, makes of the section of a closed surface with
 * z = 0; what of the boundary lies there is in it. false: out of memory. */
bool csg_surface_section(const struct csg_surface *surface, const struct csg_map *map,
                         double rounding, struct csg_drawing *drawing);

#endif
