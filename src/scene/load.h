/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_LOAD_H
#define CSG_SCENE_LOAD_H

#include "csg/scene.h"
#include "openscad/openscad.h"
#include "scene/source.h"

/*
 * The scene as the text has it: leaves and trees, not simplified, nothing merged. For tests; the
 * public functions finish it. params may be NULL. NULL: messages were given.
 */
struct csgcast_scene *csg_scene_read(const char *text, size_t size,
                                     const struct csgcast_scene_params *params);

/*
 * The finished scene of a text that openscad has made of the file at path, with its camera. params
 * has a directory. NULL: messages were given.
 */
struct csgcast_scene *csg_scene_of_frame(const struct csg_flattened *flattened, size_t frame,
                                         const char *path,
                                         const struct csgcast_scene_params *params);

/* Fills in the directory where params have none: that of the file at path, as own, to be freed.
 * false: out of memory. */
bool csg_scene_place(struct csgcast_scene_params *params, const char *path, char **own);

/* false, with a message, for params that make no sense: they come from the caller. */
bool csg_scene_check(const struct csgcast_scene_params *params, const struct csg_log *log);

struct csg_build_source;
struct csg_document;
struct csg_origins;

/* Once more from the text it keeps, without messages; origins gets where its leaves come from, and
 * document, which the caller finishes, the nodes. */
struct csgcast_scene *csg_scene_reread(const struct csgcast_scene *scene,
                                       struct csg_origins *origins, struct csg_document *document);

/* Likewise from nodes, with messages. Errors leave out what is wrong. NULL: memory is out, a message
 * was given. */
struct csgcast_scene *csg_scene_read_nodes(const struct csg_build_source *source);

#endif
