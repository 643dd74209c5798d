/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_NEARNESS_H
#define CSG_CARRIER_NEARNESS_H

/* Which faces of a surface of triangles another leaf comes near, see remote.h. */

#include "csg/scene.h"

/* A surface in its place. */
struct csg_nearness {
    const struct csg_surface *surface;
    const struct csg_map *frame;
    struct csg_map inverse;
    double stretch;        /* of the frame */
    double reach;          /* how far from its faces others may be that coincide with them */
    double rounding;       /* that they may have */
    struct csg_box around; /* leaves whose boxes do not come to that make no difference to it */
    const uint8_t *only;   /* by node of its tree: it counts; NULL: all do */
};

/* Another leaf, as it is or as it was. */
struct csg_neighbour {
    const struct csg_shape *shape;
    struct csg_box box;
};

struct csg_nearness csg_nearness_to(const struct csgcast_scene *scene, uint32_t leaf,
                                    double rounding);
/* Its box around. */
struct csg_box csg_nearness_around(const struct csgcast_scene *scene, uint32_t leaf,
                                   double rounding);

struct csg_neighbour csg_neighbour_of(const struct csgcast_scene *scene, uint32_t leaf);

/* Marks the planes that the neighbour comes near, and of faces on the same plane one. Whether there
 * are any. */
bool csg_nearness_mark(const struct csg_nearness *own, const struct csg_neighbour *neighbour,
                       uint8_t *near);

/* Faces on one plane of the surface are near where the marked one of them is. */
void csg_nearness_spread(const struct csg_surface *surface, uint8_t *near);

#endif
