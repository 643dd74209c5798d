/* SPDX-License-Identifier: MIT */
#include "plane/balls.h"

#include <stdlib.h>

#include "common/order.h"
#include "plane/prism.h"

#define PI 3.14159265358979323846264338327950288

/* Distances below this share of the largest coordinate are none. */
#define NEAR 1e-10

/* Three centres whose triangle is smaller than this share of the square of its sides are in line.
 */
#define IN_LINE 1e-10

/* All balls are on the side of dot(normal, x) <= offset. */
struct wrap {
    struct csg_part *part;
    const struct csg_ball *balls;
    size_t num;
    double near, rounding;
    CSG_ARRAY(struct csg_plane) planes; /* that touch three balls and more */
    bool *used;                         /* by ball: it reaches to the hull's surface */
};

bool csg_shape_is_ball(const struct csg_shape *shape, struct csg_ball *ball)
{
    static const double tolerance = 1e-12;
    const double(*m)[4] = shape->quadric.to_canon.m;
    const int8_t *diag = shape->quadric.diag;
    double dots[3][3];
    if (!shape->has_quadric || shape->num_planes > 0 || diag[0] != 1 || diag[1] != 1 ||
        diag[2] != 1 || diag[3] != -1 || shape->quadric.linear != 0)
        return false;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            dots[i][j] = m[0][i] * m[0][j] + m[1][i] * m[1][j] + m[2][i] * m[2][j];
    const double square = dots[0][0];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (!(fabs(dots[i][j] - (i == j ? square : 0)) <= tolerance * square))
                return false;
    double center[3];
    for (int i = 0; i < 3; i++)
        center[i] = -(m[0][i] * m[0][3] + m[1][i] * m[1][3] + m[2][i] * m[2][3]) / square;
    ball->center = csg_vec3_of(center);
    ball->radius = 1 / sqrt(square);
    return true;
}

/* ---- balls that matter -------------------------------------------------------------------- */

static double size_of(const struct csg_ball *balls, size_t num)
{
    double size = 0;
    for (size_t i = 0; i < num; i++) {
        const struct csg_vec3 c = balls[i].center;
        size = fmax(size, csg_vec3_largest(c) + balls[i].radius);
    }
    return size;
}

static bool is_in_another(const struct csg_ball *balls, size_t num, size_t i, double near)
{
    for (size_t j = 0; j < num; j++) {
        const double beyond = csg_length(csg_sub(balls[i].center, balls[j].center)) +
                              balls[i].radius - balls[j].radius;
        const bool are_equal = beyond > -near && balls[i].radius >= balls[j].radius - near;
        if (j != i && beyond <= near && (!are_equal || j < i))
            return true;
    }
    return false;
}

size_t csg_balls_drop_inner(struct csg_ball *balls, size_t num)
{
    const double near = NEAR * size_of(balls, num);
    for (size_t i = 0; i < num;) {
        if (is_in_another(balls, num, i, near))
            balls[i] = balls[--num];
        else
            i++;
    }
    return num;
}

/* ---- planes ------------------------------------------------------------------------------- */

static double reach(const struct csg_ball *ball, struct csg_vec3 normal)
{
    return csg_dot(normal, ball->center) + ball->radius;
}

static bool supports(const struct wrap *wrap, struct csg_vec3 normal, double offset)
{
    for (size_t i = 0; i < wrap->num; i++)
        if (reach(&wrap->balls[i], normal) > offset + wrap->near)
            return false;
    return true;
}

static bool touches(const struct wrap *wrap, const struct csg_plane *plane, size_t ball)
{
    return fabs(reach(&wrap->balls[ball], plane->normal) - plane->offset) <= 4 * wrap->near;
}

static bool is_known(const struct wrap *wrap, struct csg_vec3 normal, double offset)
{
    for (size_t i = 0; i < wrap->planes.num; i++)
        if (csg_length(csg_sub(wrap->planes.data[i].normal, normal)) <= 1e-7 &&
            fabs(wrap->planes.data[i].offset - offset) <= 4 * wrap->near)
            return true;
    return false;
}

static bool try_plane(struct wrap *wrap, struct csg_vec3 normal, double offset)
{
    const struct csg_plane plane = {csg_normalize(normal), offset};
    if (!supports(wrap, normal, offset) || is_known(wrap, plane.normal, offset))
        return true;
    return csg_array_push(&wrap->planes, plane);
}

/*
 * n.c + r is the same for three balls: with u and v from the first centre to the others
 *     n.u = r0 - r1,  n.v = r0 - r2,  n = a u + b v +- g w,  w = u x v,
 * where a and b solve the two equations and g makes n a unit vector.
 */
static bool try_triple(struct wrap *wrap, const struct csg_ball *p, const struct csg_ball *q,
                       const struct csg_ball *r)
{
    const struct csg_vec3 u = csg_sub(q->center, p->center), v = csg_sub(r->center, p->center);
    const struct csg_vec3 w = csg_cross(u, v);
    const double uu = csg_dot(u, u), uv = csg_dot(u, v), vv = csg_dot(v, v), ww = csg_dot(w, w);
    if (!(ww > IN_LINE * IN_LINE * uu * vv))
        return true;
    const double x = p->radius - q->radius, y = p->radius - r->radius;
    const struct csg_vec3 flat =
        csg_add(csg_scale((x * vv - y * uv) / ww, u), csg_scale((y * uu - x * uv) / ww, v));
    const double rest = 1 - csg_dot(flat, flat);
    if (!(rest >= 0))
        return true;
    const struct csg_vec3 up = csg_scale(sqrt(rest / ww), w);
    const struct csg_vec3 one = csg_add(flat, up), other = csg_sub(flat, up);
    return try_plane(wrap, one, reach(p, one)) && try_plane(wrap, other, reach(p, other));
}

static bool find_planes(struct wrap *wrap)
{
    const struct csg_ball *balls = wrap->balls;
    bool ok = true;
    for (size_t i = 0; i < wrap->num; i++)
        for (size_t j = i + 1; j < wrap->num; j++)
            for (size_t k = j + 1; k < wrap->num && ok; k++)
                ok = try_triple(wrap, &balls[i], &balls[j], &balls[k]);
    return ok;
}

/* The polyhedron of all points in which the planes touch. */
static enum csg_hull_result add_core(struct wrap *wrap)
{
    struct csg_points points = {0};
    struct csg_shape shape = {.frame = csg_map_identity, .rounding = wrap->rounding};
    bool ok = true;
    for (size_t i = 0; i < wrap->planes.num; i++) {
        const struct csg_plane *plane = &wrap->planes.data[i];
        for (size_t j = 0; j < wrap->num && ok; j++) {
            if (!touches(wrap, plane, j))
                continue;
            wrap->used[j] = true;
            ok = csg_array_push(
                &points.points,
                csg_add(wrap->balls[j].center, csg_scale(wrap->balls[j].radius, plane->normal)));
        }
    }
    enum csg_hull_result result = ok ? CSG_HULL_FLAT : CSG_HULL_NO_MEMORY;
    if (ok && points.points.num > 3)
        result = csg_hull_fill(&shape, &points);
    free(points.points.data);
    if (result == CSG_HULL_DONE)
        return csg_part_add(wrap->part, &shape, false) ? CSG_HULL_DONE : CSG_HULL_NO_MEMORY;
    csg_shape_finish(&shape);
    return result == CSG_HULL_FLAT ? CSG_HULL_DONE : result;
}

/* ---- cones -------------------------------------------------------------------------------- */

/* Two balls, and the planes that touch both: their normals are a circle about the axis. */
struct pair {
    const struct csg_ball *p, *q;
    struct csg_vec3 axis, e1, e2;
    double length, cosine, sine; /* of the normals with the axis */
};

static bool init_pair(struct pair *pair, const struct csg_ball *p, const struct csg_ball *q)
{
    const struct csg_vec3 along = csg_sub(q->center, p->center);
    pair->p = p;
    pair->q = q;
    pair->length = csg_length(along);
    if (!(pair->length > 0))
        return false;
    pair->axis = csg_scale(1 / pair->length, along);
    const struct csg_vec3 aside = fabs(pair->axis.x) < 0.7 ? csg_vec3(1, 0, 0) : csg_vec3(0, 1, 0);
    pair->e1 = csg_normalize(csg_cross(pair->axis, aside));
    pair->e2 = csg_cross(pair->axis, pair->e1);
    pair->cosine = (p->radius - q->radius) / pair->length;
    pair->sine = sqrt(fmax(0, 1 - pair->cosine * pair->cosine));
    return pair->sine > 0;
}

static struct csg_vec3 normal_at(const struct pair *pair, double angle)
{
    const struct csg_vec3 out =
        csg_add(csg_scale(cos(angle), pair->e1), csg_scale(sin(angle), pair->e2));
    return csg_add(csg_scale(pair->cosine, pair->axis), csg_scale(pair->sine, out));
}

static bool is_outside_at(const struct wrap *wrap, const struct pair *pair, double angle)
{
    const struct csg_vec3 normal = normal_at(pair, angle);
    return supports(wrap, normal, reach(pair->p, normal));
}

/* Between two neighbouring planes that touch both balls, the cone is all outside or all inside. */
static bool is_outside(const struct wrap *wrap, const struct pair *pair, double *angles)
{
    const size_t p = (size_t)(pair->p - wrap->balls), q = (size_t)(pair->q - wrap->balls);
    size_t num = 0;
    for (size_t i = 0; i < wrap->planes.num; i++) {
        const struct csg_plane *plane = &wrap->planes.data[i];
        if (touches(wrap, plane, p) && touches(wrap, plane, q))
            angles[num++] =
                atan2(csg_dot(plane->normal, pair->e2), csg_dot(plane->normal, pair->e1));
    }
    if (num == 0)
        return is_outside_at(wrap, pair, 0);
    qsort(angles, num, sizeof *angles, csg_compare_doubles);
    for (size_t i = 0; i < num; i++) {
        const double next = i + 1 < num ? angles[i + 1] : angles[0] + 2 * PI;
        if (is_outside_at(wrap, pair, (angles[i] + next) / 2))
            return true;
    }
    return false;
}

/* The cone between the circles in which it touches the balls. */
static bool add_cone(struct wrap *wrap, const struct pair *pair)
{
    const double r0 = pair->p->radius * pair->sine, r1 = pair->q->radius * pair->sine;
    const double r = fmax(r0, r1);
    const struct csg_map disc = csg_map_scaling(csg_vec3(r, r, 1));
    const struct csg_lift lift = {.z0 = pair->p->radius * pair->cosine,
                                  .s0 = r0 / r,
                                  .z1 = pair->length + pair->q->radius * pair->cosine,
                                  .s1 = r1 / r};
    struct csg_shape shape = {.frame = csg_map_identity, .rounding = wrap->rounding};
    struct csg_map place = csg_map_identity;
    const struct csg_vec3 columns[4] = {pair->e1, pair->e2, pair->axis, pair->p->center};
    for (int i = 0; i < 4; i++) {
        place.m[0][i] = columns[i].x;
        place.m[1][i] = columns[i].y;
        place.m[2][i] = columns[i].z;
    }
    if (csg_disc_fill(&shape, &disc, &lift) && csg_shape_map(&shape, &place))
        return csg_part_add(wrap->part, &shape, false);
    csg_shape_finish(&shape);
    return false;
}

static bool add_cones(struct wrap *wrap)
{
    double *angles = malloc((wrap->planes.num + 1) * sizeof *angles);
    bool ok = angles != NULL;
    for (size_t i = 0; i < wrap->num; i++)
        for (size_t j = i + 1; j < wrap->num && ok; j++) {
            struct pair pair;
            if ((wrap->balls[i].radius == 0 && wrap->balls[j].radius == 0) ||
                !init_pair(&pair, &wrap->balls[i], &wrap->balls[j]) ||
                !is_outside(wrap, &pair, angles))
                continue;
            wrap->used[i] = wrap->used[j] = true;
            ok = add_cone(wrap, &pair);
        }
    free(angles);
    return ok;
}

static bool add_balls(struct wrap *wrap)
{
    bool ok = true;
    for (size_t i = 0; i < wrap->num && ok; i++) {
        const struct csg_ball *ball = &wrap->balls[i];
        const double r = ball->radius;
        if (r == 0 || (wrap->num > 1 && !wrap->used[i]))
            continue;
        struct csg_shape shape = {.frame = csg_map_identity,
                                  .has_quadric = true,
                                  .convex = true,
                                  .quadric = {.diag = {1, 1, 1, -1}},
                                  .rounding = wrap->rounding};
        const struct csg_vec3 c = ball->center;
        const struct csg_vec3 scaled = csg_scale(-1 / r, c);
        shape.quadric.to_canon = csg_map_scaling(csg_vec3(1 / r, 1 / r, 1 / r));
        shape.quadric.to_canon.m[0][3] = scaled.x;
        shape.quadric.to_canon.m[1][3] = scaled.y;
        shape.quadric.to_canon.m[2][3] = scaled.z;
        shape.bounds =
            (struct csg_box){csg_sub(c, csg_vec3(r, r, r)), csg_add(c, csg_vec3(r, r, r))};
        shape.written = shape.bounds;
        ok = csg_part_add(wrap->part, &shape, false);
    }
    return ok;
}

enum csg_hull_result csg_ball_hull(struct csg_part *part, const struct csg_ball *balls, size_t num,
                                   double rounding)
{
    struct wrap wrap = {.part = part,
                        .balls = balls,
                        .num = num,
                        .near = NEAR * size_of(balls, num),
                        .rounding = rounding,
                        .used = calloc(num + 1, sizeof *wrap.used)};
    enum csg_hull_result result = CSG_HULL_NO_MEMORY;
    if (wrap.used && find_planes(&wrap) && csg_part_open(part, false)) {
        result = add_core(&wrap);
        if (result == CSG_HULL_DONE && !(add_cones(&wrap) && add_balls(&wrap)))
            result = CSG_HULL_NO_MEMORY;
        csg_part_close(part);
    }
    free(wrap.planes.data);
    free(wrap.used);
    return result;
}
