/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_FILL_H
#define CSG_CROWD_FILL_H

/* What a frame draws of the scene's crowd. */

#include "pack/frame.h"

/*
 * Fills frame->crowd from the scene's, and appends its attribute blocks to the frame's texels. The
 * frame's screen is set. Other objects, and members that have to be drawn as they are, are listed
 * in frame->listed. false: out of memory.
 */
bool csg_crowd_fill(struct csg_frame *frame, const struct csgcast_scene *scene,
                    const struct csg_frame_params *params);

#endif
