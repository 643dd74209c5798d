/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_OFFSET_H
#define CSG_PLANE_OFFSET_H

#include "plane/sweep.h"

enum csg_join { CSG_JOIN_ROUND, CSG_JOIN_MITER, CSG_JOIN_SQUARE };

struct csg_offset {
    double distance; /* outwards; negative: inwards */
    enum csg_join join;
    int num;    /* ROUND: segments of a full circle */
    bool exact; /* ROUND: discs where the corners are sharp */
};

/* Replaces the subtree at node, the last of the drawing, by what it becomes when its outline moves,
 * as Clipper's offsets have it. */
enum csg_sweep_result csg_drawing_offset(struct csg_drawing *drawing, uint32_t node,
                                         const struct csg_offset *offset);

#endif
