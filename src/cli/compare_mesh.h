/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_COMPARE_MESH_H
#define CSG_CLI_COMPARE_MESH_H

#include "compare/module.h"
#include "options.h"

struct csg_mesh_source {
    const struct csg_cli_options *options;
    const struct csgcast_scene_params *params; /* what openscad gets */
    struct csg_log log;
    /* Results: */
    struct csg_soup soup; /* the caller finishes it, in any case */
    const char *name;     /* the file, or the program that made the mesh */
    double seconds;       /* that took; 0 for a file */
};

/* Reads --mesh, or has openscad export the scene. false, with a message. */
bool csg_mesh_source_read(struct csg_mesh_source *source, const struct csg_compare_module *module);

#endif
