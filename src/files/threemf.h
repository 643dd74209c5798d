/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_THREEMF_H
#define CSG_FILES_THREEMF_H

/*
 * Meshes in 3MF, through csgcast-3mf.so, which is opened for each file. As in OpenSCAD 2021.01 each
 * mesh object counts, once and where its points are; the build, components and units do not.
 */

#include "common/file.h"
#include "files/mesh_list.h"

enum csg_3mf_file {
    CSG_3MF_FILE_DONE,
    CSG_3MF_FILE_NO_MODULE,
    CSG_3MF_FILE_MALFORMED, /* error, of that size, tells what is wrong */
    CSG_3MF_FILE_NO_MEMORY,
};

/* The meshes are not clean yet. */
enum csg_3mf_file csg_3mf_read(const struct csg_bytes *bytes, struct csg_mesh_list *list,
                               char *error, size_t size);

#endif
