/* SPDX-License-Identifier: MIT */
#ifndef CSG_SOLIDS_RINGS_H
#define CSG_SOLIDS_RINGS_H

/*
 * OpenSCAD's circles, cylinders and spheres as it tessellates them: regular polygons with the same
 * number of corners and no turn between them, stacked along z. Corner i of a ring lies at
 * (radius cos(360 i / n), radius sin(360 i / n), z).
 */

#include "solids/shape.h"
#include "solids/value.h"

struct csg_ring {
    double radius, z;
};

/* As-written solids with more planes than this are refused: they would take gigabytes. */
#define CSG_RINGS_MAX_PLANES (1 << 20)

/*
 * A radius as OpenSCAD reads it: the number named d, halved, or else the number named r, or else
 * fallback. rounding is replaced by that of the number, if there is one.
 */
double csg_args_radius(const struct csg_args *args, const char *r, const char *d, double fallback,
                       double *rounding);

/* Box of the corners of one ring with n corners: what OpenSCAD frames. */
struct csg_box csg_ring_box(struct csg_ring ring, int n);

/* The ring of that index, counted from below. Only the lowest and highest may be points. */
typedef struct csg_ring csg_ring_fn(const void *user, int index);

/*
 * Makes shape the convex polyhedron of num rings with n corners each: the facets between
 * neighbouring rings, and caps on the first and last unless they are points. Sets facetted and
 * convex, not the bounds. false, with a message, when there are too many facets or memory is out.
 */
bool csg_rings_fill(struct csg_shape *shape, const struct csg_args *args, csg_ring_fn *ring,
                    const void *user, int num, int n);

#endif
