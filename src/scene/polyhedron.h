/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_POLYHEDRON_H
#define CSG_SCENE_POLYHEDRON_H

#include "polyhedra/mesh.h"
#include "solids/value.h"

/* The clean mesh of a polyhedron(points, faces). false, with a message, when memory is out. */
bool csg_polyhedron_read(const struct csg_args *args, struct csg_mesh *mesh);

#endif
