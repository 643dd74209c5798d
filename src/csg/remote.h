/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_REMOTE_H
#define CSG_CSG_REMOTE_H

/*
 * Remote: faces of a surface that no other solid's box comes near, or, where that is a surface too,
 * none of the boxes of its triangles. No ray meets another solid's face where it meets a remote
 * one, so nobody needs to look for what it coincides with, but for faces of its own surface
 * (own_faces.h).
 */

#include "csg/scene.h"

struct csg_remote {
    uint8_t **near; /* by leaf, by plane: another solid comes near, or comes near a face of the same
                     * surface that lies on this one's plane; NULL: all faces are remote. */
    size_t num_leaves;
};

/* Of the surfaces among the leaves that wanted marks; rounding: the largest of these. false: out of
 * memory. */
bool csg_remote_find(struct csg_remote *remote, const struct csgcast_scene *scene,
                     const bool *wanted, double rounding);
void csg_remote_finish(struct csg_remote *remote);

#endif
