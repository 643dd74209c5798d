/* SPDX-License-Identifier: MIT */
#ifndef CSG_PREPARE_FOLLOW_H
#define CSG_PREPARE_FOLLOW_H

/*
 * Edits of scenes of many objects. Where an edit leaves all objects the structure that they have,
 * only what follows from the leaves that changed is made anew, and put where it was: the boxes of
 * their objects, the carriers, and for these objects and those whose carriers are others now what
 * their geometry asks of numbers, their members of the crowd and their cells.
 */

#include "carrier/edit.h"

/* What an edited scene has for the edits to come: where its leaves are. */
struct csg_follower;

void csg_follower_destroy(struct csg_follower *follower);

/* false: the scene is as it was, but for its leaves and, where memory ran out, what was kept of
 * carriers: csg_scene_finish has to make all of it. */
bool csg_follow(struct csgcast_scene *scene, const struct csg_before *before);

/* After an edit of nothing but colours, none of which became opaque or translucent. */
void csg_follow_colors(struct csgcast_scene *scene, const uint32_t *leaves, size_t num);

#endif
