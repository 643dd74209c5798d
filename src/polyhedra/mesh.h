/* SPDX-License-Identifier: MIT */
#ifndef CSG_POLYHEDRA_MESH_H
#define CSG_POLYHEDRA_MESH_H

/* Polyhedra by their corners and faces, and their way to convex solids. */

#include <stdint.h>

#include "csg/part.h"
#include "polyhedra/cut.h"

struct csg_mesh_face {
    uint32_t begin, end; /* of its corners in struct csg_mesh */
};

/* Zero-initialise it. Faces may be non-planar and of either orientation. */
struct csg_mesh {
    CSG_ARRAY(struct csg_vec3) points;
    CSG_ARRAY(uint32_t) corners; /* indices of points */
    CSG_ARRAY(struct csg_mesh_face) faces;
    double size;        /* the largest coordinate */
    double rounding;    /* see struct csg_shape */
    bool is_simple;     /* see struct csg_surface */
    bool is_hull;       /* OpenSCAD takes its hull for it, however it is bent */
    bool keeps_dents;   /* OpenSCAD never takes its hull for it, as where it is inside out */
    size_t num_guessed; /* faces not cut as in OpenSCAD, see struct csg_cutter */
};

void csg_mesh_finish(struct csg_mesh *mesh);

bool csg_mesh_add_point(struct csg_mesh *mesh, struct csg_vec3 p);

/* The corners added behind the last face become a face, unless they are fewer than three. */
bool csg_mesh_close_face(struct csg_mesh *mesh);

/* Joins points at the same place, drops corners that follow each other at one point and cuts faces
 * that are not plane; space: where, NULL as they are. false: out of memory. */
bool csg_mesh_clean(struct csg_mesh *mesh, const struct csg_cut_space *space);

/* Whether a face is not plane. */
bool csg_mesh_is_bent(const struct csg_mesh *mesh);

/* The face's plane, its normal to the side from which its corners run counter-clockwise. false: the
 * face has no area. */
bool csg_mesh_plane(const struct csg_mesh *mesh, const struct csg_mesh_face *face,
                    struct csg_plane *plane);

/* Corners nearer to a plane than this share of the largest coordinate lie on it. */
#define CSG_MESH_ON_PLANE 1e-9

/* What keeps a mesh from being closed. */
struct csg_mesh_gaps {
    size_t num;         /* edges that do not belong to faces in opposite directions, pairwise */
    uint32_t points[2]; /* the ends of one of them */
    bool is_folded;     /* more than two faces meet at an edge, or two at two edges of a corner */
};

/* Turns faces over until neighbours agree on which side is out. false: out of memory. */
bool csg_mesh_orient(struct csg_mesh *mesh, struct csg_mesh_gaps *gaps);

/* Adds to films, which is zeroed, the faces of a closed mesh that bound no volume, one for each two
 * that take each other back, but for those within the solid. false: out of memory. */
bool csg_mesh_films(const struct csg_mesh *mesh, const struct csg_mesh_gaps *gaps,
                    struct csg_mesh *films);

/* Of the mesh, mapped. are_shallow: it is closed and in one piece, and convex but for dents whose
 * edges are bent by at most so many degrees; are_there: there are any. false: out of memory. */
bool csg_mesh_find_dents(const struct csg_mesh *mesh, const struct csg_map *map, double degrees,
                         bool *are_shallow, bool *are_there);

/* Of a closed mesh; negative where its faces run clockwise as seen from outside. */
double csg_mesh_volume(const struct csg_mesh *mesh);

/* Times that the surface goes round p. */
double csg_mesh_winding(const struct csg_mesh *mesh, struct csg_vec3 p);

enum csg_mesh_result {
    CSG_MESH_DONE,
    CSG_MESH_TOO_LARGE, /* too many faces, planes or convex pieces */
    CSG_MESH_NO_MEMORY,
};

/* Adds the union of convex solids that the mesh is, or itself where it is convex. max_faces: of a
 * mesh that is not; max_planes: of one that is. A flat mesh adds nothing. */
enum csg_mesh_result csg_mesh_decompose(const struct csg_mesh *mesh, size_t max_faces,
                                        size_t max_planes, struct csg_part *part);

/* The mesh as one shape bounded by its faces (mesh/surface.h). false: out of memory. */
bool csg_mesh_to_shape(const struct csg_mesh *mesh, bool open, struct csg_shape *shape);

/* The mesh as a surface without triangles, only points that a corner has: what a hull needs of it.
 * false: out of memory. */
bool csg_mesh_to_points(const struct csg_mesh *mesh, struct csg_shape *shape);

#endif
