/* SPDX-License-Identifier: MIT */
#include "csg/remote.h"

#include "csg/object.h"
#include "mesh/surface.h"

/* Surfaces of fewer faces are through before their neighbours are found. */
enum { MIN_FACES = 64 };

struct csg_remote csg_remote_start(const struct csgcast_scene *scene, const bool *wanted,
                                   uint32_t leaf)
{
    const struct csg_surface *surface = scene->leaves[leaf].shape.surface;
    const struct csg_box own = csg_leaf_box(&scene->leaves[leaf]);
    struct csg_remote remote = {.none = !surface->is_simple || surface->planes.num < MIN_FACES ||
                                        !csg_box_is_finite(&own)};
    /* Tolerances are far smaller than the surface. */
    const struct csg_box near = csg_box_grown(&own, csg_length(csg_sub(own.hi, own.lo)));
    for (uint32_t i = 0; i < scene->num_leaves && !remote.none; i++) {
        const struct csg_box box = csg_leaf_box(&scene->leaves[i]);
        const struct csg_box both = csg_box_intersection(&box, &near);
        if (i == leaf || !wanted[i] || csg_box_is_empty(&both))
            continue;
        if (remote.num == CSG_REMOTE_MAX_BOXES)
            remote.none = true;
        else
            remote.boxes[remote.num++] = box;
    }
    return remote;
}

static double beside(double x, double lo, double hi)
{
    return x < lo ? lo - x : x > hi ? x - hi : 0;
}

bool csg_remote_is(const struct csg_remote *remote, struct csg_vec3 center, double radius)
{
    bool is_apart = !remote->none;
    for (size_t i = 0; i < remote->num && is_apart; i++) {
        const struct csg_box *box = &remote->boxes[i];
        const struct csg_vec3 d = {beside(center.x, box->lo.x, box->hi.x),
                                   beside(center.y, box->lo.y, box->hi.y),
                                   beside(center.z, box->lo.z, box->hi.z)};
        is_apart = csg_dot(d, d) > radius * radius;
    }
    return is_apart;
}
