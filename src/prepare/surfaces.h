/* SPDX-License-Identifier: MIT */
#ifndef CSG_PREPARE_SURFACES_H
#define CSG_PREPARE_SURFACES_H

#include "csg/scene.h"

/* Makes the surfaces of triangles ready for the frames: hierarchies, and which of their faces lie
 * upon each other, on all cores. What is there already stays. false: out of memory. */
bool csg_surfaces_build(struct csgcast_scene *scene);

#endif
