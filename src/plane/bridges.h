/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_BRIDGES_H
#define CSG_PLANE_BRIDGES_H

/*
 * The contours of a figure as rings of corners, each hole joined to what is around it by a bridge,
 * which goes there and back: what is left are rings without holes. A line sweeps over the corners
 * from left to right, and a hole's first corner is joined to the last one in the same gap between
 * edges that the line cuts (the split vertices of de Berg et al., Computational Geometry, 2008,
 * section 3.2).
 */

#include "plane/drawing.h"

/* A corner of a ring. A bridge has its two corners twice. */
struct csg_corner {
    struct csg_vec2 at;
    uint32_t point; /* of the drawing */
    uint32_t before, after;
    uint32_t twin; /* another one of the same contour's corner, due to a bridge; UINT32_MAX: none */
    bool is_joined; /* to an outline, or part of one */
    bool is_cut;    /* not in a ring any more; none is to begin with */
};

struct csg_corners {
    CSG_ARRAY(struct csg_corner) list;
};

/* The rings of a figure whose contours do not cross and have the inside to their left, in n log n
 * of its corners. false: out of memory. The caller frees corners->list.data in any case. */
bool csg_corners_of_figure(const struct csg_drawing *drawing, const struct csg_figure *figure,
                           struct csg_corners *corners);

static inline bool csg_is_same_place(struct csg_vec2 a, struct csg_vec2 b)
{
    return a.x == b.x && a.y == b.y;
}

/* Above 0 where a, b, c turn to the left. The differences are as good as exact in long double. */
static inline long double csg_turn(struct csg_vec2 a, struct csg_vec2 b, struct csg_vec2 c)
{
    return ((long double)b.x - a.x) * ((long double)c.y - a.y) -
           ((long double)b.y - a.y) * ((long double)c.x - a.x);
}

#endif
