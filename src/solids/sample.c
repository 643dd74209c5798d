/* SPDX-License-Identifier: MIT */
#include "solids/sample.h"

#include <stdint.h>

#include "common/random.h"

/* Lines tried for each point wanted. Most lines give two points. */
#define LINES_PER_POINT 32

/* Half the size, in canonical units, of the box that is sampled of an unbounded solid. */
#define UNBOUNDED_REACH 3

/* Newton steps that remove the rounding of the roots: two are enough, each doubles the digits. */
#define NUM_POLISH 2

/* Inverse of to_canon, whose rows may differ in size by more than csg_map_invert forgives. */
static bool invert_canonical(const struct csg_map *to_canon, struct csg_map *inverse)
{
    struct csg_map even = *to_canon;
    double length[3];
    for (int i = 0; i < 3; i++) {
        const double *row = to_canon->m[i];
        length[i] = csg_length(csg_vec3_of(row));
        for (int j = 0; j < 4; j++)
            even.m[i][j] /= length[i];
    }
    if (!csg_map_invert(&even, inverse))
        return false;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            inverse->m[i][j] /= length[j];
    return true;
}

/* The box that lines are drawn through, and the map from it to the shape's space. What planes cut
 * off has tight bounds; a quadric alone fits its own axes better, however long and thin it is. */
static bool sampled_box(const struct csg_shape *shape, struct csg_box *box, struct csg_map *map)
{
    const bool is_finite = csg_box_is_finite(&shape->bounds);
    const double reach = is_finite ? 1 : UNBOUNDED_REACH;
    *box = shape->bounds;
    *map = shape->frame;
    if (is_finite && shape->num_planes > 0)
        return true;
    *box = (struct csg_box){{-reach, -reach, -reach}, {reach, reach, reach}};
    return invert_canonical(&shape->quadric.to_canon, map);
}

static struct csg_vec3 random_point(const struct csg_box *box, const struct csg_map *map,
                                    uint64_t *state)
{
    const double x = csg_random_between(state, 0, 1), y = csg_random_between(state, 0, 1),
                 z = csg_random_between(state, 0, 1);
    const struct csg_vec3 size = csg_sub(box->hi, box->lo);
    return csg_map_point(map, csg_add(box->lo, csg_vec3(x * size.x, y * size.y, z * size.z)));
}

/* Roots of f on the line from + t (to - from), by values: f is quadratic in t. */
static int line_roots(const struct csg_quadric *quadric, struct csg_vec3 from, struct csg_vec3 to,
                      double roots[2])
{
    const struct csg_vec3 middle = csg_scale(0.5, csg_add(from, to));
    const double f0 = csg_quadric_value(quadric, from), f1 = csg_quadric_value(quadric, middle),
                 f2 = csg_quadric_value(quadric, to);
    const double a = 2 * (f0 - 2 * f1 + f2), b = 0.5 * (4 * f1 - 3 * f0 - f2); /* a t^2 + 2 b t */
    const double discriminant = b * b - a * f0;
    if (!(discriminant > 0))
        return 0;
    const double q = -(b + (b < 0 ? -sqrt(discriminant) : sqrt(discriminant)));
    roots[0] = q / a;
    roots[1] = f0 / q;
    return 2;
}

static struct csg_vec3 polish(const struct csg_quadric *quadric, struct csg_vec3 p)
{
    for (int i = 0; i < NUM_POLISH; i++) {
        const struct csg_vec3 g = csg_quadric_gradient(quadric, p);
        const double square = csg_dot(g, g);
        if (square > 0)
            p = csg_sub(p, csg_scale(csg_quadric_value(quadric, p) / square, g));
    }
    return p;
}

static bool is_within_planes(const struct csg_shape *shape, struct csg_vec3 p)
{
    for (size_t i = 0; i < shape->num_planes; i++)
        if (!(csg_dot(shape->planes[i].normal, p) <= shape->planes[i].offset))
            return false;
    return csg_vec3_is_finite(p);
}

size_t csg_shape_sample(const struct csg_shape *shape, struct csg_vec3 *points, size_t max)
{
    struct csg_box box;
    struct csg_map map;
    uint64_t state = 1;
    size_t num = 0;
    if (!shape->has_quadric || !sampled_box(shape, &box, &map))
        return 0;
    for (size_t i = 0; i < LINES_PER_POINT * max && num < max; i++) {
        const struct csg_vec3 from = random_point(&box, &map, &state);
        const struct csg_vec3 to = random_point(&box, &map, &state);
        double roots[2];
        const int num_roots = line_roots(&shape->quadric, from, to, roots);
        for (int j = 0; j < num_roots && num < max; j++) {
            const struct csg_vec3 p =
                polish(&shape->quadric, csg_add(from, csg_scale(roots[j], csg_sub(to, from))));
            if (is_within_planes(shape, p))
                points[num++] = p;
        }
    }
    return num;
}
