/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_PRECISE_H
#define CSG_PACK_PRECISE_H

/* The objects of a frame that are drawn in double. */

#include "pack/frame.h"

/* Fills frame->precisions: objects that float does not hold, and those that share a surface with
 * one, on the same side and in another colour, where they are not apart (pack/apart.h): its
 * crossings then have to be the same bits for both. false: out of memory. */
bool csg_frame_judge(struct csg_frame *frame, const struct csgcast_scene *scene,
                     const struct csg_frame_params *params, const struct csg_box *focus);

/* The verdict on an object; of CSG_WHOLE_LAYER that on any of the layer's. */
struct csg_precision csg_frame_precision(const struct csg_frame *frame,
                                         const struct csgcast_scene *scene, uint32_t object,
                                         uint8_t layer);

#endif
