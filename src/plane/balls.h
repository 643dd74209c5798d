/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_BALLS_H
#define CSG_PLANE_BALLS_H

#include "csg/part.h"
#include "polyhedra/hull.h"

/* A ball, or a point of radius 0. */
struct csg_ball {
    struct csg_vec3 center;
    double radius;
};

/* The number of tangent planes that are tried grows with the cube of the balls. */
#define CSG_BALLS_MAX 100

/* Whether the shape is a ball. */
bool csg_shape_is_ball(const struct csg_shape *shape, struct csg_ball *ball);

/* Drops balls inside of others; returns how many are left. */
size_t csg_balls_drop_inner(struct csg_ball *balls, size_t num);

/*
 * Adds the convex hull of at most CSG_BALLS_MAX balls, none inside of another, exactly: the
 * polyhedron of the points in which planes touch three balls and more, cones that touch two, and
 * the balls. All of them lie in the hull, and its surface consists of theirs.
 */
enum csg_hull_result csg_ball_hull(struct csg_part *part, const struct csg_ball *balls, size_t num,
                                   double rounding);

#endif
