/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_HANDOFF_MESH_H
#define CSG_NODES_HANDOFF_MESH_H

/*
 * What openscad exports, read back. Binary STL is the format in which OpenSCAD 2021.01 loses least:
 * floats, against six digits in all the others.
 */

#include "nodes/mesh_file.h"
#include "plane/drawing.h"

/* Fills an empty mesh with the triangles, corners at the same place joined; its rounding is that of
 * floats. Triangles without area are left out. Malformed: it stays empty. */
enum csg_mesh_file csg_stl_read(const struct csg_bytes *bytes, struct csg_mesh *mesh);

/* The floor at z = 0 of a drawing that was extruded from there: adds its contours, mapped, to the
 * drawing as one figure. false: out of memory. */
bool csg_stl_outline(const struct csg_mesh *mesh, const struct csg_map *map, double rounding,
                     struct csg_drawing *drawing);

#endif
