/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_POLYHEDRON_H
#define CSG_NODES_POLYHEDRON_H

#include "nodes/walk.h"
#include "polyhedra/mesh.h"
#include "solids/value.h"

/* Cleans the node's mesh, whose faces OpenSCAD has in that order or reversed. false, with a
 * message, when memory is out. */
bool csg_polyhedron_clean(struct csg_walk *walk, uint32_t node, bool reversed,
                          struct csg_mesh *mesh);

/* is_hull: OpenSCAD takes the hull of the node's closed mesh for it, as it is nearly convex and
 * meets other solids. false, with a message, when memory is out. */
bool csg_polyhedron_find_hull(struct csg_walk *walk, uint32_t node, const struct csg_mesh *mesh,
                              bool *is_hull);

/* Adds the solid of a clean mesh, the node's, to part: the one way from faces to leaves.
 * in_boolean: see struct csg_space; elsewhere faces that bound no volume are there as well, as
 * sheets. What is wrong with the mesh is reported. false, with a message, when memory is out. */
bool csg_polyhedron_add(struct csg_walk *walk, uint32_t node, bool in_boolean,
                        struct csg_mesh *mesh, struct csg_part *part);

#endif
