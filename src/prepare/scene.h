/* SPDX-License-Identifier: MIT */
#ifndef CSG_PREPARE_SCENE_H
#define CSG_PREPARE_SCENE_H

/*
 * From leaves and trees to what frames are drawn from: simplified trees, objects, carriers,
 * sharpness, programs and the crowd. Edits of large scenes go another way, see prepare/follow.h.
 */

#include "csg/scene.h"

/* A zeroed scene with log and name set; NULL, with a message, when memory is out. */
struct csgcast_scene *csg_scene_create(const struct csg_log *log, const char *name);

/* Everything but source and edits. */
void csg_scene_destroy(struct csgcast_scene *scene);
/* Of a leaf that has changed. */
void csg_leaf_fill_box(struct csg_leaf *leaf);

/* Counts the distinct surfaces. */
void csg_scene_fill_carrier_info(struct csgcast_scene *scene);

/* Of that what csg_scene_finish makes, and the trees. */
void csg_scene_drop_derived(struct csgcast_scene *scene);

/*
 * Simplifies the trees, merges coincident carriers, fills box and info: after this the scene is
 * immutable. leaves[] with an empty shape must not occur, but for those marked is_empty: they are
 * left out while building. before: of an edit, see carrier/edit.h; else NULL.
 */
bool csg_scene_finish(struct csgcast_scene *scene, const struct csg_before *before);

#endif
