/* SPDX-License-Identifier: MIT */
#ifndef CSG_REFERENCE_CROSSINGS_H
#define CSG_REFERENCE_CROSSINGS_H

#include "csg/carrier.h"
#include "reference/reference.h"

/* A point where a line enters or leaves a set. */
struct csg_crossing {
    double t;
    uint32_t leaf;
    bool cut; /* a subtracted leaf's surface */
};

/* Where a line is inside a set: its state at t = -inf and where that changes, t ascending. */
#define CSG_LEAF_MAX_CROSSINGS 4

struct csg_leaf_crossings {
    bool inside; /* at -inf */
    int num;
    double t[CSG_LEAF_MAX_CROSSINGS];
};

/* A carrier's crossing; *along is dot(normal, dir), 0 when the line runs along the plane. */
double csg_cross_plane(const struct csg_plane *plane, const struct csg_ray *ray, double *along);

/* A quadric's crossings in order, 0 to 2; *before: f < 0 (or, without crossings, everywhere). */
int csg_cross_quadric(const struct csg_quadric *quadric, const struct csg_ray *ray, double t[2],
                      bool *before);

struct csg_leaf_crossings csg_cross_leaf(const struct csgcast_scene *scene, uint32_t leaf,
                                         const struct csg_ray *ray);

/* The outward unit normal of the leaf's face that the line crosses at t, entering or leaving. */
struct csg_vec3 csg_leaf_normal(const struct csgcast_scene *scene, uint32_t leaf,
                                const struct csg_ray *ray, double t, bool enters);

#endif
