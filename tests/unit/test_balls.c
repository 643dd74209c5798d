/* SPDX-License-Identifier: MIT */
/*
 * Hulls of balls against what a convex hull is: it has all points between points of the balls, and
 * none beyond a plane that all balls are below.
 */
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "plane/balls.h"

enum { max_balls = 12, num_points = 2000, num_directions = 300 };

static unsigned long long state;

static double random_unit(void)
{
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return (double)(state >> 11) / 9007199254740992.0;
}

static struct csg_vec3 random_direction(void)
{
    const double z = 2 * random_unit() - 1, angle = 6.283185307179586 * random_unit();
    const double r = sqrt(1 - z * z);
    return csg_vec3(r * cos(angle), r * sin(angle), z);
}

static bool is_inside(const struct csg_part *part, struct csg_vec3 p)
{
    for (size_t i = 0; i < part->shapes.num; i++)
        if (csg_shape_contains(&part->shapes.data[i], p))
            return true;
    return false;
}

/* The furthest point in that direction. */
static struct csg_vec3 support(const struct csg_ball *balls, size_t num, struct csg_vec3 n)
{
    size_t best = 0;
    for (size_t i = 1; i < num; i++)
        if (csg_dot(n, balls[i].center) + balls[i].radius >
            csg_dot(n, balls[best].center) + balls[best].radius)
            best = i;
    return csg_add(balls[best].center, csg_scale(balls[best].radius, n));
}

/* A little inwards of a point between three that the hull reaches furthest to. */
static struct csg_vec3 inner_point(const struct csg_ball *balls, size_t num)
{
    const struct csg_vec3 n = random_direction(), center = balls[0].center;
    const double spread = random_unit() < 0.5 ? 0.05 : 2;
    struct csg_vec3 p = csg_vec3(0, 0, 0);
    double weights[3], sum = 0;
    for (int i = 0; i < 3; i++)
        sum += weights[i] = random_unit();
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 m = csg_normalize(csg_add(n, csg_scale(spread, random_direction())));
        p = csg_add(p, csg_scale(weights[i] / sum, support(balls, num, m)));
    }
    return csg_add(csg_scale(1 - 1e-7, p), csg_scale(1e-7, center));
}

static bool is_beyond_a_plane(const struct csg_ball *balls, size_t num, struct csg_vec3 p)
{
    for (int i = 0; i < num_directions; i++) {
        const struct csg_vec3 n = random_direction();
        if (csg_dot(n, csg_sub(p, support(balls, num, n))) > 1e-7)
            return true;
    }
    return false;
}

static void check_hull(struct csg_ball *balls, size_t num, int seed)
{
    struct csg_part part = {0};
    int num_missing = 0, num_extra = 0;
    const size_t left = csg_balls_drop_inner(balls, num);
    const enum csg_hull_result result = csg_ball_hull(&part, balls, left, 0);
    CHECK(result == CSG_HULL_DONE, "seed %d: %d", seed, (int)result);
    for (int i = 0; i < num_points; i++) {
        const struct csg_vec3 p = csg_scale(12, random_direction());
        const struct csg_vec3 q = csg_scale(random_unit(), p);
        num_missing += !is_inside(&part, inner_point(balls, left));
        num_extra += is_inside(&part, q) && is_beyond_a_plane(balls, left, q);
    }
    CHECK(num_missing == 0, "seed %d: %d points are missing", seed, num_missing);
    CHECK(num_extra == 0, "seed %d: %d points are too many", seed, num_extra);
    csg_part_finish(&part);
}

/* On a grid centres are in line and in a plane, and many balls touch one plane. */
static void add_random(struct csg_ball *balls, size_t num, bool on_grid)
{
    for (size_t i = 0; i < num; i++) {
        double c[3];
        for (int k = 0; k < 3; k++)
            c[k] = on_grid ? floor(3 * random_unit()) * 3 : 8 * random_unit() - 4;
        balls[i].center = csg_vec3(c[0], c[1], c[2]);
        balls[i].radius = on_grid ? 1 : random_unit() < 0.3 ? 0 : 2 * random_unit();
    }
    balls[0].radius = 1; /* the hull has a volume */
}

int main(void)
{
    for (int seed = 0; seed < 60; seed++) {
        struct csg_ball balls[max_balls];
        state = 77 + (unsigned long long)seed;
        random_unit();
        const size_t num = 1 + (size_t)(random_unit() * max_balls);
        add_random(balls, num, seed % 2 == 0);
        check_hull(balls, num, seed);
    }
    if (num_failed)
        fprintf(stderr, "%d checks failed\n", num_failed);
    return num_failed != 0;
}
