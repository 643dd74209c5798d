/* SPDX-License-Identifier: MIT */
#ifndef TESTS_OPENSCAD_MESH_H
#define TESTS_OPENSCAD_MESH_H

/* OpenSCAD's result as triangles, in the doubles that its STL file spells out. */

#include "common/linear.h"

#include <stddef.h>

struct triangle {
    struct csg_vec3 corner[3]; /* counter-clockwise seen from outside */
};

struct mesh {
    struct triangle *triangles;
    size_t num_triangles;
    struct csg_box bounds;
};

/* Reads an ASCII STL file; one without facets is the empty solid. false, with a message. */
bool mesh_read(const char *path, struct mesh *mesh);
void mesh_finish(struct mesh *mesh);

#endif
