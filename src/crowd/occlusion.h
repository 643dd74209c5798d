/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_OCCLUSION_H
#define CSG_CROWD_OCCLUSION_H

/*
 * A picture of the members of a crowd, by the CPU: per pixel a key behind which nothing can
 * show. It is conservative: what the shader finds is nearer by more than both sides' rounding and
 * the depth buffer's steps together.
 */

#include "crowd/cull.h"

/* A key that is surely nearer than all of a member whose nearest point has depth t. */
float csg_occlusion_near(const struct csg_screen *screen, double t);

/* Fills cull->keys from the candidates; leaves it NULL where there is nothing to gain. false: out
 * of memory. */
bool csg_occlusion_draw(struct csg_cull *cull);

/* Whether a candidate may show at some pixel; narrows its rectangle to those. */
bool csg_occlusion_shows(struct csg_cull *cull, struct csg_candidate *candidate);

#endif
