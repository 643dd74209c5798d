/* SPDX-License-Identifier: MIT */
#ifndef CSG_OPENSCAD_OPENSCAD_H
#define CSG_OPENSCAD_OPENSCAD_H

#include "common/array.h"
#include "common/file.h"
#include "common/folder.h"

/* The program: the caller's, the environment's, or the one in the path. */
const char *csg_openscad_program(const struct csgcast_scene_params *params);

/* What openscad has made of a .scad file: texts in a folder of our own. It starts as zeroes. */
struct csg_flattened {
    struct csg_folder folder;
    size_t num_frames;                        /* 0: one text, of no animation */
    CSG_ARRAY(char *) fonts;                  /* of the parameters, and that the file uses */
    CSG_ARRAY(struct csgcast_camera) cameras; /* that the file asks for, a text; may be fewer */
};

/*
 * Flattens a .scad file to .csg text by running the installed openscad; for an animation of
 * num_frames > 0 at $t = 0, 1 / num_frames, ... Its warnings are passed on, its errors too, as
 * errors. The caller finishes flattened in either case. false: a message was given.
 */
bool csg_openscad_flatten(const char *path, const struct csgcast_scene_params *params,
                          size_t num_frames, const struct csg_log *log,
                          struct csg_flattened *flattened);

/* Fills fonts, when openscad has run. false: a message was given. */
bool csg_flattened_find_fonts(struct csg_flattened *flattened,
                              const struct csgcast_scene_params *params, const struct csg_log *log);

/* The text of a frame; the caller frees text->data. false: a message was given. */
bool csg_flattened_read(const struct csg_flattened *flattened, size_t frame,
                        const struct csg_log *log, struct csg_bytes *text);

/* Of kind DEFAULT where the file asks for none. */
struct csgcast_camera csg_flattened_camera(const struct csg_flattened *flattened, size_t frame);

/* Removes the texts. */
void csg_flattened_finish(struct csg_flattened *flattened);

/* What helps where the program does not run; "" where installing it does not. */
const char *csg_openscad_remedy(int error);

/*
 * Passes on the lines that openscad printed, prefix in front of each; those that only say how far
 * the work is just where it failed, and of very many the first and the last ones, but all of what
 * the scene echoes. Returns whether one of them means that the result is
 * incomplete. Leaves messages as they were.
 */
bool csg_openscad_pass_on(const struct csg_log *log, const char *prefix, struct csg_bytes *messages,
                          bool failed);

/* Whether text is anywhere in what openscad printed. */
bool csg_openscad_mentions(const struct csg_bytes *messages, const char *text);

#endif
