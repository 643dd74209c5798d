/* SPDX-License-Identifier: MIT */
#ifndef CSG_POLYHEDRA_HULL_H
#define CSG_POLYHEDRA_HULL_H

/* Convex hulls by Qhull (Barber, Dobkin, Huhdanpaa 1996), where it was there to build with. */

#include "common/array.h"
#include "polyhedra/cell.h"
#include "solids/shape.h"

/* Shapes of up to so many planes are cut out of a box, which takes the square of their number. */
#define CSG_HULL_MAX_CUT_PLANES 64

struct csg_points {
    CSG_ARRAY(struct csg_vec3) points;
};

enum csg_hull_result {
    CSG_HULL_DONE,
    CSG_HULL_FLAT,    /* the points lie in a plane: no volume */
    CSG_HULL_MISSING, /* built without Qhull */
    CSG_HULL_NO_MEMORY,
};

/* Adds the hull's planes to shape, which is zeroed, and sets its bounds. */
enum csg_hull_result csg_hull_fill(struct csg_shape *shape, const struct csg_points *points);

/* Gets the corners of a face of a hull, in no order: num indices of its points. false: memory is
 * out. */
typedef bool csg_hull_face_fn(void *user, const size_t *corners, size_t num);

/* Visits the faces of the points' hull; those on one plane are one. */
enum csg_hull_result csg_hull_visit(const struct csg_points *points, csg_hull_face_fn *fn,
                                    void *user);

/* Puts corners in the order of x. */
void csg_corners_sort(struct csg_vec3 *corners, size_t num);

/* Whether one of the corners, which are in that order, is as near as that to p, behind them all. */
bool csg_corners_have(const struct csg_vec3 *corners, size_t num, struct csg_vec3 p, double near);

/*
 * Adds the corners of a convex shape without a quadric, or the points of a surface. A shape of many
 * planes needs Qhull and is refused without it.
 */
enum csg_hull_result csg_shape_corners(const struct csg_shape *shape, struct csg_points *points);

/* The cell, which is zeroed, of such a shape, as csg_cell_from_shape makes it. */
enum csg_hull_result csg_shape_cell(const struct csg_shape *shape, struct csg_cell *cell);

#endif
