/* SPDX-License-Identifier: MIT */
#ifndef CSG_SHARPNESS_WALL_H
#define CSG_SHARPNESS_WALL_H

/*
 * How thin a turned profile is. Rings of a stack are as thin as the corners of the profile are
 * close, but that is no wall: the next ring goes on where one ends, at the same carrier. What
 * counts is how far it is across the profile from one side to another.
 */

#include "csg/stack.h"

/* What sharpness has to know of leaves that are part of a stack. */
enum {
    CSG_WALL_RING = 1, /* its height is not the height of a solid */
    CSG_WALL_LOW = 2,  /* another ring covers all of its low face, */
    CSG_WALL_HIGH = 4  /* ... of its high face */
};

/* Marks the leaves of a stack, by leaf, and finds the least distance across the profile, solid or
 * not, up to a hundredth of its size; infinite where there is no volume. false: out of memory. */
bool csg_wall_measure(const struct csgcast_scene *scene, const struct csg_stacks *stacks,
                      const struct csg_stack *stack, uint8_t *marks, double *least);

/* Whether float may not hold the ring by itself in pictures of all its profile, that size. */
bool csg_wall_is_fine(const struct csg_leaf *leaf, double size);

/* The radius of curvature of a ring's frustum at its wide end: the length of the normal from there
 * to the axis. A cone as flat as a ring's may be is hardly curved. */
double csg_wall_curvature(const struct csg_shape *shape);

#endif
