/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_POLYHEDRON_H
#define CSG_SCENE_POLYHEDRON_H

#include "polyhedra/mesh.h"
#include "scene/walk.h"
#include "solids/value.h"

/* The clean mesh of a polyhedron(points, faces). false, with a message, when memory is out. */
bool csg_polyhedron_read(const struct csg_args *args, struct csg_mesh *mesh);

/* Adds the solid of a clean mesh, the node's, to part: the one way from faces to leaves. What is
 * wrong with the mesh is reported. false, with a message, when memory is out. */
bool csg_polyhedron_add(struct csg_walk *walk, uint32_t node, struct csg_mesh *mesh,
                        struct csg_part *part);

#endif
