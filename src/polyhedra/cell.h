/* SPDX-License-Identifier: MIT */
#ifndef CSG_POLYHEDRA_CELL_H
#define CSG_POLYHEDRA_CELL_H

/* Convex cells: polytopes by their faces, each a convex polygon on a plane, and cutting them. */

#include <stdint.h>

#include "common/array.h"
#include "solids/shape.h"

struct csg_polygon {
    CSG_ARRAY(struct csg_vec3) points;
    struct csg_plane plane;
};

/* Zero-initialise it. */
struct csg_cell {
    CSG_ARRAY(struct csg_polygon) faces;
};

void csg_polygon_finish(struct csg_polygon *polygon);

/* Splits polygon into what is below and above the plane; what is nearer than near counts as on it.
 * A side without area stays empty. false: out of memory. */
bool csg_polygon_split(const struct csg_polygon *polygon, const struct csg_plane *plane,
                       double near, struct csg_polygon *below, struct csg_polygon *above);

/* The least and largest distance of its points from the plane. */
void csg_polygon_range(const struct csg_polygon *polygon, const struct csg_plane *plane, double *lo,
                       double *hi);

bool csg_cell_from_box(struct csg_cell *cell, const struct csg_box *box);
void csg_cell_finish(struct csg_cell *cell);
void csg_cell_range(const struct csg_cell *cell, const struct csg_plane *plane, double *lo,
                    double *hi);

/* Splits a cell that the plane really cuts. below and above are zeroed. false: out of memory. */
bool csg_cell_split(const struct csg_cell *cell, const struct csg_plane *plane, double near,
                    struct csg_cell *below, struct csg_cell *above);

/* Keeps what is below the plane; an empty cell has no faces. false: out of memory. */
bool csg_cell_clip(struct csg_cell *cell, const struct csg_plane *plane, double near);

/* Adds the face on the plane that has these corners, in any order and perhaps several times; none
 * where they are fewer than three. false: out of memory. */
bool csg_cell_add_face(struct csg_cell *cell, const struct csg_plane *plane,
                       const struct csg_vec3 *points, size_t num, double near);

/* Joins two cells that have the faces i and j in common and are convex together: b goes over to a.
 * false: out of memory. */
bool csg_cell_join(struct csg_cell *a, size_t i, struct csg_cell *b, size_t j, double near);

/* The cell of a bounded shape without a quadric. false: out of memory. */
bool csg_cell_from_shape(struct csg_cell *cell, const struct csg_shape *shape);

/* A point inside. */
struct csg_vec3 csg_cell_center(const struct csg_cell *cell);

struct csg_box csg_cell_box(const struct csg_cell *cell);

#endif
