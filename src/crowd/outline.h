/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_OUTLINE_H
#define CSG_CROWD_OUTLINE_H

/*
 * What the members of a crowd look like from outside, as far as their rectangle on the screen and
 * their nearest point go: a few numbers each, whatever the view.
 */

#include "solids/shape.h"

enum csg_outline {
    CSG_OUTLINE_BALL,      /* center and radius say it all */
    CSG_OUTLINE_ELLIPSOID, /* three conjugate half-axes */
    CSG_OUTLINE_DISCS,     /* a cylinder or frustum, the hull of its two discs: from the middle to
                              the upper one's, two conjugate half-axes, and what these are
                              multiplied by for the lower and for the upper disc */
    CSG_OUTLINE_BOX        /* three half-edges of a box around the solid; of a box, its own */
};

/* A ball around the solid; of CSG_OUTLINE_BALL itself. */
struct csg_outline_ball {
    struct csg_vec3 center;
    double radius;
};

/* Enough numbers for any outline. */
enum { CSG_OUTLINE_MAX = 11 };

/* How many numbers an outline of this kind has. */
size_t csg_outline_size(enum csg_outline kind);

/* The kind that suits a convex, bounded solid best; ball and numbers, in world space. quadric: the
 * one that is drawn, NULL where the shape has none. */
enum csg_outline csg_outline_of(const struct csg_shape *shape, const struct csg_quadric *quadric,
                                struct csg_outline_ball *ball, double numbers[CSG_OUTLINE_MAX]);

#endif
