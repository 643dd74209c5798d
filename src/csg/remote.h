/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_REMOTE_H
#define CSG_CSG_REMOTE_H

/*
 * Remote: faces of a surface that no other solid's box comes near. Where the surface's own faces do
 * not lie upon each other either (is_simple), no ray meets another face where it meets a remote
 * one, so nobody needs to look for what it coincides with.
 */

#include "csg/scene.h"

/* Boxes beyond which a face is compared with all of what is near the surface, at once. */
#define CSG_REMOTE_MAX_BOXES 32

struct csg_remote {
    struct csg_box boxes[CSG_REMOTE_MAX_BOXES]; /* of the other solids */
    size_t num;
    bool none; /* no face is known to be remote */
};

/* Of leaf, a surface, among the leaves that wanted marks. */
struct csg_remote csg_remote_start(const struct csgcast_scene *scene, const bool *wanted,
                                   uint32_t leaf);

/* Whether the ball is apart from the boxes. */
bool csg_remote_is(const struct csg_remote *remote, struct csg_vec3 center, double radius);

#endif
