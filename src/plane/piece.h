/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_PIECE_H
#define CSG_PLANE_PIECE_H

/* Convex pieces that together are a drawing. Abutting pieces share sides to the last bit. */

#include "plane/sweep.h"

/* The points with dot(normal, p) <= offset; normal has unit length. */
struct csg_line {
    struct csg_vec2 normal;
    double offset;
};

struct csg_piece {
    uint32_t first_line, num_lines;
    uint32_t first_corner, num_corners; /* some come twice, in no order */
};

/* Zero-initialise it. */
struct csg_pieces {
    CSG_ARRAY(struct csg_piece) pieces;
    CSG_ARRAY(struct csg_line) lines;
    CSG_ARRAY(struct csg_vec2) corners;
};

void csg_pieces_finish(struct csg_pieces *pieces);

/* Cuts the subtree of a drawing into pieces. pieces is empty where the drawing is. */
enum csg_sweep_result csg_pieces_cut(struct csg_pieces *pieces, const struct csg_drawing *drawing,
                                     uint32_t node);

#endif
