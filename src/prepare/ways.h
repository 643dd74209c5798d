/* SPDX-License-Identifier: MIT */
#ifndef CSG_PREPARE_WAYS_H
#define CSG_PREPARE_WAYS_H

#include "csg/scene.h"

/* Sums up for scene's info how the nodes of its leaves come about. false: out of memory. */
bool csg_ways_fill(struct csgcast_scene *scene);

#endif
