/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_SOURCE_H
#define CSG_SCENE_SOURCE_H

#include <stddef.h>

#include "csgcast/csgcast.h"

/* What a scene was read from, kept for edits. */
struct csg_source {
    char *text; /* owned; NULL: of a fixed scene */
    size_t size;
    struct csgcast_scene_params params;        /* without what was for the .scad, and without log */
    char *name, *directory, *openscad, *cache; /* those of params, owned; NULL as there */
    char **fonts;                              /* likewise */
};

/* Takes text over, also where it fails. NULL: out of memory. */
struct csg_source *csg_source_create(char *text, size_t size,
                                     const struct csgcast_scene_params *params);
void csg_source_destroy(struct csg_source *source);

#endif
