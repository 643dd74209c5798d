/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_LOAD_H
#define CSG_SCENE_LOAD_H

#include "csg/scene.h"

/*
 * The scene as the text has it: leaves and trees, not simplified, nothing merged. For tests; the
 * public functions finish it. params may be NULL. NULL: messages were given.
 */
struct csgcast_scene *csg_scene_read(const char *text, size_t size,
                                     const struct csgcast_scene_params *params);

#endif
