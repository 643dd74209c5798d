/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_REVOLVE_H
#define CSG_PLANE_REVOLVE_H

/* rotate_extrude: the drawing, cut into trapezoids, turned about its y axis, which becomes z. */

#include "csg/part.h"
#include "plane/profile.h"

struct csg_turn {
    double start, angle; /* degrees from +x; angle in (-360, 360] and not 0; 360: all round */
    int num;             /* OpenSCAD's segments */
    bool facetted;       /* stay flat */
};

/* Half a turn in one segment lies in a plane. */
static inline bool csg_turn_is_flat(const struct csg_turn *turn)
{
    return turn->facetted && fabs(turn->angle) == 180.0 * turn->num;
}

/* The profile must lie on one side of the axis. false: out of memory. */
bool csg_revolve(struct csg_part *part, const struct csg_profile *profile,
                 const struct csg_turn *turn, double rounding);

#endif
