/* SPDX-License-Identifier: MIT */
#ifndef CSG_REFERENCE_CROSSINGS_H
#define CSG_REFERENCE_CROSSINGS_H

#include "carrier/carrier.h"
#include "mesh/surface.h"
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

struct csg_leaf_crossings csg_cross_leaf(const struct csgcast_scene *scene, uint32_t leaf,
                                         const struct csg_ray *ray);

/* A crossing of a surface with the face it is on; turns as in struct csg_meeting. */
struct csg_surface_crossing {
    double t;
    uint32_t face;
    int turns;
};

/* A line's crossings of one surface, t ascending. Zero-initialise it; reusable. */
struct csg_surface_crossings {
    struct csg_surface_crossing *data;
    size_t num, capacity;
    struct csg_meetings meetings;
};

/* Replaces the crossings by those of the leaf, which is bounded by a surface. false: out of memory.
 */
bool csg_cross_surface(const struct csgcast_scene *scene, uint32_t leaf, const struct csg_ray *ray,
                       struct csg_surface_crossings *crossings);

/* The normal, out of the solid, at the crossing at t that the line enters or leaves by. */
struct csg_vec3 csg_surface_normal(const struct csgcast_scene *scene, uint32_t leaf,
                                   const struct csg_ray *ray, double t, bool enters,
                                   struct csg_surface_crossings *crossings);

/* The outward unit normal of the leaf's face that the line crosses at t, entering or leaving. */
struct csg_vec3 csg_leaf_normal(const struct csgcast_scene *scene, uint32_t leaf,
                                const struct csg_ray *ray, double t, bool enters);

#endif
