/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_WALK_H
#define CSG_PACK_WALK_H

/* An object's cells as this frame's shaders see them, see shaders/csg/walk.glsl. */

#include "cells/cells.h"
#include "pack/terms.h"

/* Whether rays can walk through a box in this view: seen from outside, in front of the eye. */
bool csg_walk_can_see(const struct csg_screen *screen, const struct csg_box *box);

/* Whether the texture of all the frame's cells has room for these. */
bool csg_walk_has_room(const struct csg_frame *frame, const struct csg_cells *cells);

/* Appends one draw of the object in a rectangle of the screen; terms are the object's. false: out
 * of memory. */
bool csg_walk_add(struct csg_terms *terms, const struct csg_cells *cells,
                  const struct csg_rect *rect, const struct csg_draw *draw);

#endif
