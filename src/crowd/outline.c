/* SPDX-License-Identifier: MIT */
#include "crowd/outline.h"

/* Share of lengths, and cosines, that are the rounding of products of matrices. */
#define NOISE 1e-9

/* A frustum's radii are distances from its apex: further away than this many of its heights it is
 * outlined by its box, as an apex so far off has no digits for the caps. */
#define MAX_APEX 1e4

size_t csg_outline_size(enum csg_outline kind)
{
    return kind == CSG_OUTLINE_BALL ? 0 : kind == CSG_OUTLINE_DISCS ? 11 : 9;
}

static void put(double *numbers, struct csg_vec3 v)
{
    numbers[0] = v.x;
    numbers[1] = v.y;
    numbers[2] = v.z;
}

/* The corner of a box of these half-edges is further away than any point of what is in it. */
static double reach_of(const struct csg_vec3 axes[3])
{
    double most = 0;
    for (int i = 0; i < 4; i++) {
        const struct csg_vec3 y = csg_scale(i & 1 ? -1 : 1, axes[1]);
        const struct csg_vec3 z = csg_scale(i & 2 ? -1 : 1, axes[2]);
        most = fmax(most, csg_length(csg_add(axes[0], csg_add(y, z))));
    }
    return most;
}

static void measure_box(const struct csg_shape *shape, struct csg_outline_ball *ball,
                        double *numbers)
{
    const struct csg_box *box = &shape->bounds;
    const struct csg_vec3 half = csg_scale(0.5, csg_sub(box->hi, box->lo));
    const double size[3] = {half.x, half.y, half.z};
    struct csg_vec3 axes[3];
    for (int i = 0; i < 3; i++) {
        axes[i] = csg_scale(size[i], csg_map_column(&shape->frame, i));
        put(numbers + 3 * i, axes[i]);
    }
    ball->center = csg_map_point(&shape->frame, csg_box_middle(box));
    ball->radius = reach_of(axes);
}

/* The image of the unit ball. The squares of the half-axes of an ellipsoid sum up to those of any
 * conjugate ones. */
static void measure_ellipsoid(const struct csg_map *from_canon, struct csg_outline_ball *ball,
                              double *numbers)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        put(numbers + 3 * i, csg_map_column(from_canon, i));
        sum += csg_dot(csg_map_column(from_canon, i), csg_map_column(from_canon, i));
    }
    ball->center = csg_map_column(from_canon, 3);
    ball->radius = sqrt(sum);
}

/* Whether the plane is a cap, along both axes; and where it cuts the axis. */
static bool find_cap(const struct csg_plane *plane, const struct csg_map *from_canon, double *z)
{
    const struct csg_vec3 n = plane->normal;
    for (int i = 0; i < 2; i++)
        if (fabs(csg_dot(n, csg_map_column(from_canon, i))) >
            NOISE * csg_length(csg_map_column(from_canon, i)))
            return false;
    *z = (plane->offset - csg_dot(n, csg_map_column(from_canon, 3))) /
         csg_dot(n, csg_map_column(from_canon, 2));
    return isfinite(*z);
}

/* A bound of |h + s (a cos + b sin)|: with the Gram matrix's largest eigenvalue for the disc. */
static double disc_reach(struct csg_vec3 h, struct csg_vec3 a, struct csg_vec3 b, double s)
{
    const double aa = csg_dot(a, a), bb = csg_dot(b, b), ab = csg_dot(a, b);
    const double largest = 0.5 * (aa + bb) + hypot(0.5 * (aa - bb), ab);
    const double across = hypot(csg_dot(h, a), csg_dot(h, b));
    return sqrt(csg_dot(h, h) + 2 * s * across + s * s * largest);
}

/* x^2 + y^2 <= 1 or <= z^2 between two planes of constant z. */
static bool measure_discs(const struct csg_shape *shape, const struct csg_quadric *quadric,
                          const struct csg_map *from_canon, struct csg_outline_ball *ball,
                          double *numbers)
{
    const bool cone = quadric->diag[2] == -1;
    double z[2];
    if (shape->num_planes != 2 || quadric->linear != 0 || quadric->diag[3] != (cone ? 0 : -1) ||
        !find_cap(&shape->planes[0], from_canon, &z[0]) ||
        !find_cap(&shape->planes[1], from_canon, &z[1]))
        return false;
    const double height = fabs(z[1] - z[0]), most = fmax(fabs(z[0]), fabs(z[1]));
    const double least = z[0] * z[1] < 0 ? fmin(fabs(z[0]), fabs(z[1])) : 0; /* of both nappes */
    if (cone && (least > NOISE * most || most > MAX_APEX * height))
        return false;
    const struct csg_vec3 a = csg_map_column(from_canon, 0), b = csg_map_column(from_canon, 1);
    const struct csg_vec3 w = csg_map_column(from_canon, 2);
    const struct csg_vec3 half = csg_scale(0.5 * (z[1] - z[0]), w);
    const double lower = cone ? fabs(z[0]) : 1, upper = cone ? fabs(z[1]) : 1;
    ball->center = csg_add(csg_map_column(from_canon, 3), csg_scale(0.5 * (z[0] + z[1]), w));
    ball->radius = fmax(disc_reach(half, a, b, lower), disc_reach(half, a, b, upper));
    put(numbers, half);
    put(numbers + 3, a);
    put(numbers + 6, b);
    numbers[9] = lower;
    numbers[10] = upper;
    return true;
}

/* false: no ellipsoid, cylinder or frustum. */
static bool measure_quadric(const struct csg_shape *shape, const struct csg_quadric *quadric,
                            enum csg_outline *kind, struct csg_outline_ball *ball, double *numbers)
{
    const int8_t *d = quadric->diag;
    struct csg_map from_canon;
    *kind = CSG_OUTLINE_BALL;
    if (shape->num_planes == 0 && csg_quadric_ball(quadric, &ball->center, &ball->radius))
        return true;
    if (d[0] != 1 || d[1] != 1 || !csg_map_invert(&quadric->to_canon, &from_canon))
        return false;
    if (d[2] != 1) {
        *kind = CSG_OUTLINE_DISCS;
        return measure_discs(shape, quadric, &from_canon, ball, numbers);
    }
    if (d[3] != -1 || shape->num_planes > 0)
        return false;
    *kind = CSG_OUTLINE_ELLIPSOID;
    measure_ellipsoid(&from_canon, ball, numbers);
    return true;
}

enum csg_outline csg_outline_of(const struct csg_shape *shape, const struct csg_quadric *quadric,
                                struct csg_outline_ball *ball, double numbers[CSG_OUTLINE_MAX])
{
    enum csg_outline kind;
    if (quadric && measure_quadric(shape, quadric, &kind, ball, numbers))
        return kind;
    measure_box(shape, ball, numbers);
    return CSG_OUTLINE_BOX;
}
