/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_OCCLUSION_H
#define CSG_CROWD_OCCLUSION_H

/* Which members of a crowd hide which, by reliefs (crowd/relief.h) that they are drawn in. */

#include "crowd/cull.h"

/* How far apart two keys of this size must be for the nearer one to win in the depth buffer. */
double csg_occlusion_noise(const struct csg_screen *screen, double key);

/* A key that is surely nearer than all of a member whose nearest point has depth t. */
float csg_occlusion_near(const struct csg_screen *screen, double t);

/* Fills cull->relief from the opaque candidates where there is something to gain. false: out of
 * memory. */
bool csg_occlusion_draw(struct csg_cull *cull);

/* Whether a candidate may show at some pixel, behind those of cull->relief, and how it is drawn
 * then; narrows its rectangle to those where it is drawn by itself. */
bool csg_occlusion_shows(struct csg_cull *cull, struct csg_candidate *candidate);

/*
 * More translucent objects than CSG_MAX_OVERLAYS are drawn together, so that the nearest far side
 * shows through the nearest near one: where the crowd alone has so many, notes that, and leaves out
 * the candidates that are neither. false: out of memory.
 */
bool csg_occlusion_hide_translucent(struct csg_cull *cull);

#endif
