/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_MEMBER_H
#define CSG_CROWD_MEMBER_H

/* One member of a crowd in this view: the numbers that its program gets. */

#include "crowd/crowd.h"
#include "pack/frame.h"

/* Where the members are looked up. */
struct csg_crowd_view {
    const struct csgcast_scene *scene;
    const struct csg_crowd *crowd;
    const struct csg_frame *frame; /* its screen and reference pixel are set */
    bool square;                   /* csg_screen_is_square */
};

/* Floats of a member's terms: three texels of a quadric, one a plane (crowd/run.h). */
static inline size_t csg_member_num_terms(const struct csg_crowd_class *class)
{
    return (class->has_quadric ? 12u : 0u) + 4 * (size_t) class->num_planes;
}

/* A run of members of the class. */
struct csg_crowd_run csg_member_run(const struct csg_crowd_view *view,
                                    const struct csg_crowd_class *class);

/* The terms of any leaf with planes and quadrics, as a class of its own has them. false: the
 * quadric is stiff in this view. */
bool csg_leaf_cast_terms(const struct csg_frame *frame, const struct csgcast_scene *scene,
                         uint32_t leaf, float *out);

/* false: the quadric is stiff in this view. */
bool csg_member_terms(const struct csg_crowd_view *view, const struct csg_crowd_class *class,
                      uint32_t member, float *out);

/* The normals' texels of its attribute block, which mark names. */
void csg_member_normals(const struct csg_crowd_view *view, const struct csg_crowd_class *class,
                        uint32_t member, float mark, float (*normals)[4]);

#endif
