/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_OPENSCAD_H
#define CSG_SCENE_OPENSCAD_H

#include "scene/file.h"

/*
 * Flattens a .scad file to .csg text by running the installed openscad. Its warnings are passed
 * on, its errors too, as errors. The caller frees text->data. false: a message was given.
 */
bool csg_openscad_flatten(const char *path, const struct csgcast_scene_params *params,
                          const struct csg_log *log, struct csg_bytes *text);

#endif
