/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_PRISM_H
#define CSG_PLANE_PRISM_H

/* Solids between two planes z = z0 and z = z1 > z0 whose sections are one figure, scaled. */

#include "plane/piece.h"
#include "solids/shape.h"

/* The section at height z is scaled about the z axis by a linear function of z. At most one of
 * s0 and s1 is 0; neither is negative. */
struct csg_lift {
    double z0, s0; /* below */
    double z1, s1; /* above */
};

/* Over a convex piece. shape is zeroed, its frame the identity. false: out of memory. */
bool csg_prism_fill(struct csg_shape *shape, const struct csg_pieces *pieces,
                    const struct csg_piece *piece, const struct csg_lift *lift);

/* Over the ellipse disc, see struct csg_figure: part of a cylinder or cone. disc is regular. */
bool csg_disc_fill(struct csg_shape *shape, const struct csg_map *disc,
                   const struct csg_lift *lift);

/* Adds the planes z = z0 and z = z1. */
bool csg_lift_add_caps(const struct csg_lift *lift, struct csg_shape *shape);

/* The box of a section's box between the planes. */
struct csg_box csg_lift_box(const struct csg_lift *lift, const struct csg_box *section);

#endif
