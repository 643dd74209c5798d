/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_REMOTE_H
#define CSG_CARRIER_REMOTE_H

/*
 * Remote: faces of a surface that no other solid's box comes near, or, where that is a surface too,
 * none of the boxes of its triangles, or else none of its planes that is parallel to them. Nowhere
 * on a ray does another solid's face coincide with a remote one, so nobody needs to look for what
 * that coincides with, but for faces of its own surface (own_faces.h).
 */

#include "csg/scene.h"

struct csg_before;

struct csg_remote {
    uint8_t **near; /* by leaf, by plane: another solid comes near, or comes near a face of the same
                     * surface that lies on this one's plane; NULL: all faces are remote. */
    size_t num_leaves;
    double rounding; /* that they were found with */
};

/* That of all leaves to look for faces with, where their largest is that: so much more that few
 * edits make it another one. */
double csg_remote_rounding(double largest);

/* Of the surfaces among the leaves that wanted marks. false: out of memory. */
bool csg_remote_find(struct csg_remote *remote, const struct csgcast_scene *scene,
                     const bool *wanted, double rounding);
void csg_remote_finish(struct csg_remote *remote);

/* The same for one surface: near, which may be NULL. */
bool csg_remote_find_one(const struct csgcast_scene *scene, const bool *wanted, double rounding,
                         uint32_t leaf, uint8_t **near);

/* An edit of leaves beside a surface; by leaf: what is wanted now, and was. */
struct csg_remote_edit {
    const struct csg_before *before;
    const bool *wanted, *wanted_before;
};

/* The same where only other leaves have changed; old: what was near, or NULL. */
bool csg_remote_follow_one(const struct csgcast_scene *scene, const struct csg_remote_edit *edit,
                           double rounding, uint32_t leaf, const uint8_t *old, uint8_t **near);

#endif
