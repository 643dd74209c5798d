/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_SURFACE_FACE_H
#define CSG_PACK_SURFACE_FACE_H

/* A triangle of a surface as it is seen in a part of the picture. */

#include "pack/surface.h"
#include "pack/terms.h"

/* A part of the picture that a record is made for. */
struct csg_surface_part {
    struct csg_terms *terms;
    const struct csg_surface_view *view;
    int size[2];  /* pixels */
    double lo[2]; /* counted from the reference pixel */
};

/* An edge of a triangle in the part's pixels, as the shader gets it. */
struct csg_view_edge {
    float texel[4];
    double left, right;  /* where it is within the part's rows */
    int first_row, rows; /* whose centres it passes */
    int turns;           /* 1 upwards, -1 downwards */
};

struct csg_view_face {
    double plane[4]; /* once csg_view_face_fill_plane was called */
    struct csg_view_edge edges[4];
    int num_edges;
    bool thin;          /* too thin to be met by its plane */
    double left, right; /* pixels */
    int first_row, end_row;
    uint32_t normal; /* place in the record; 0 while no list has the face */
    uint32_t triangle;
};

/* All but the plane. false: it is not in the part. */
bool csg_view_face_fill(struct csg_view_face *face, const struct csg_surface_part *part,
                        uint32_t triangle);

/* The plane that the triangle lies on, as its leaf shares it with others: far from all else in
 * memory, so it is asked for only what shows. Returns the normal out of the solid. */
struct csg_vec3 csg_view_face_fill_plane(struct csg_view_face *face,
                                         const struct csg_surface_part *part);

#endif
