/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_MESH_FILE_H
#define CSG_NODES_MESH_FILE_H

#include "common/file.h"
#include "polyhedra/mesh.h"

/* Files of meshes and of heights: words between blanks, and binary STL. */

enum csg_mesh_file {
    CSG_MESH_FILE_DONE,
    CSG_MESH_FILE_PARTLY,    /* without some triangles; line tells which is the first, or is 0 */
    CSG_MESH_FILE_MALFORMED, /* line tells where, or is 0 */
    CSG_MESH_FILE_FOREIGN,   /* a dialect that only OpenSCAD may know */
    CSG_MESH_FILE_NO_MEMORY,
};

/* Words of a text, line by line. */
struct csg_words {
    const char *at, *end;
    size_t line;
};

/* The next word of this line; false at its end. */
bool csg_words_next(struct csg_words *words, const char **word, size_t *length);

/* Goes on to the next line; false where there is none. */
bool csg_words_next_line(struct csg_words *words);

/* The next word of this line as a finite number. false: it is none, or missing. */
bool csg_words_number(struct csg_words *words, double *number);

/* Binary STL: a header, the number of triangles, and each with a normal and two bytes behind it. */
enum { CSG_STL_HEADER = 80, CSG_STL_COUNT = 4, CSG_STL_RECORD = 50, CSG_STL_POINT = 12 };

uint32_t csg_stl_uint32(const char *bytes);
struct csg_vec3 csg_stl_point(const char *bytes);

/* Adds a triangle, but one with a corner that is not finite. false: out of memory. */
bool csg_stl_add(struct csg_mesh *mesh, const char *corners, bool *is_left_out);

/* After the last one. */
void csg_stl_end(struct csg_mesh *mesh);

/* As OpenSCAD 2021.01 reads them. The mesh is not clean yet. */
enum csg_mesh_file csg_stl_file_read(const struct csg_bytes *bytes, struct csg_mesh *mesh,
                                     size_t *line);
enum csg_mesh_file csg_off_file_read(const struct csg_bytes *bytes, struct csg_mesh *mesh,
                                     size_t *line);

#endif
