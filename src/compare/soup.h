/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMPARE_SOUP_H
#define CSG_COMPARE_SOUP_H

/* A mesh as bare triangles, in the doubles that its file spells out. */

#include "common/linear.h"
#include "common/log.h"

#include <stddef.h>

struct csg_triangle {
    struct csg_vec3 corner[3]; /* counter-clockwise seen from outside */
};

struct csg_soup {
    struct csg_triangle *triangles;
    size_t num_triangles;
    struct csg_box bounds;
};

/*
 * Reads an ASCII STL file; one without facets is the empty solid. An own reader, since OpenSCAD
 * 2025 writes every digit of its doubles there, and assimp would round them to float. false, with a
 * message.
 */
bool csg_soup_read(const char *path, struct csg_soup *soup, const struct csg_log *log);

/* The same through assimp: binary STL, OFF, OBJ, 3MF and whatever else it knows, in float. */
bool csg_soup_import(const char *path, struct csg_soup *soup, const struct csg_log *log);

/* Whether the file begins as ASCII STL does. */
bool csg_soup_is_ascii_stl(const char *path);

void csg_soup_finish(struct csg_soup *soup);

#endif
