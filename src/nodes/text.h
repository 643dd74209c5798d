/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_TEXT_H
#define CSG_NODES_TEXT_H

#include "nodes/walk.h"

/* Closes the fonts, if there are any. */
void csg_text_finish(struct csg_text_state *state);

/* A number for the fonts that there are, another one after any of them has changed; 0: there is no
 * module that knows them. */
uint64_t csg_text_fonts(const struct csgcast_scene_params *params);

#endif
