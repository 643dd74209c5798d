/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_TRIANGULATE_H
#define CSG_PLANE_TRIANGULATE_H

/*
 * Triangles of a figure whose contours do not cross and have the inside to their left, by cutting
 * off ears (Meisters 1975) after each hole was joined to what is around it. The triangles have the
 * figure's corners and no others and meet edge to edge, so the figure can be the cap of a closed
 * mesh.
 */

#include "plane/drawing.h"

struct csg_triangles {
    CSG_ARRAY(uint32_t) corners; /* three a triangle, counter-clockwise: points of the drawing */
};

/* The time grows with the square of the corners where triangles are long (a spiral of 200,000 takes
 * 10 s, a wave of 10^6 one): figures with more should be refused. */
#define CSG_TRIANGULATE_MAX_CORNERS 2000000

/* Appends the figure's triangles. false: out of memory. */
bool csg_figure_triangulate(const struct csg_drawing *drawing, const struct csg_figure *figure,
                            struct csg_triangles *triangles);

#endif
