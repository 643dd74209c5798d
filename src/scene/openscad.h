/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_OPENSCAD_H
#define CSG_SCENE_OPENSCAD_H

#include "common/file.h"

/* The program: the caller's, the environment's, or the one in the path. */
const char *csg_openscad_program(const struct csgcast_scene_params *params);

/*
 * Flattens a .scad file to .csg text by running the installed openscad. Its warnings are passed
 * on, its errors too, as errors. The caller frees text->data. false: a message was given.
 */
bool csg_openscad_flatten(const char *path, const struct csgcast_scene_params *params,
                          const struct csg_log *log, struct csg_bytes *text);

/*
 * Passes on the lines that openscad printed, prefix in front of each; those that only say how far
 * the work is just where it failed. Returns whether one of them means that the result is
 * incomplete. Leaves messages as they were.
 */
bool csg_openscad_pass_on(const struct csg_log *log, const char *prefix,
                          struct csg_bytes *messages, bool failed);

#endif
