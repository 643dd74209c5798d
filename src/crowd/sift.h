/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_SIFT_H
#define CSG_CROWD_SIFT_H

/*
 * Many objects of several solids each: those that cannot show in this view are left out before
 * anything else is asked of them. Left out, exactly: what is outside of the picture, what covers no
 * pixel's centre, and what is hidden at each of them by the crowd or by nearer objects of a few
 * convex solids.
 */

#include "crowd/relief.h"
#include "pack/frame.h"

/* Takes them from frame->listed. base: what the crowd hides; NULL: nothing. false: out of
 * memory. */
bool csg_sift(struct csg_frame *frame, const struct csgcast_scene *scene,
              const struct csg_relief *base);

#endif
