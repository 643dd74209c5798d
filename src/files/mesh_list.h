/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_MESH_LIST_H
#define CSG_FILES_MESH_LIST_H

#include "polyhedra/mesh.h"

/* The objects of a file, which are united. Zero-initialise it. */
struct csg_mesh_list {
    CSG_ARRAY(struct csg_mesh) meshes;
};

void csg_mesh_list_finish(struct csg_mesh_list *list);

/* A new mesh at the end; NULL: out of memory. */
struct csg_mesh *csg_mesh_list_add(struct csg_mesh_list *list);

#endif
