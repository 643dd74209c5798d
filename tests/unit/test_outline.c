/* SPDX-License-Identifier: MIT */
/*
 * The rectangle and the nearest depth of a crowd's members against points all over their surface:
 * none is outside, and on each side some point comes as far.
 */
#define DICE_SEED 3

#include <csgcast/csgcast.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "crowd/crowd.h"
#include "crowd/project.h"
#include "dice.h"

enum { num_solids = 150, num_angles = 400, num_views = 3, size = 2000 };

/* The furthest point of a circle of so many is so much of its radius short, at most. */
#define SHORT 1e-4

/* What a point of the surface is in the solid's own space. */
struct solid {
    int kind; /* 0 cylinder or frustum, 1 cone on its tip, 2 ellipsoid, 3 sphere, 4 cube */
    double r[3];
    struct csg_map map;
};

static struct csg_vec3 point_of(const struct solid *solid, int i, int j)
{
    const double a = 6.283185307179586 * i / num_angles, b = 3.141592653589793 * j / num_angles;
    const double *r = solid->r;
    struct csg_vec3 p;
    if (solid->kind < 2)
        p = j % 2 ? csg_vec3(r[0] * cos(a), r[0] * sin(a), 0)
                  : csg_vec3(r[1] * cos(a), r[1] * sin(a), r[2]);
    else if (solid->kind < 4)
        p = csg_vec3(r[0] * sin(b) * cos(a), r[1] * sin(b) * sin(a), r[2] * cos(b));
    else
        p = csg_vec3(i & 1 ? r[0] : 0, i & 2 ? r[1] : 0, i & 4 ? r[2] : 0);
    return csg_map_point(&solid->map, p);
}

static int num_rows(const struct solid *solid)
{
    return solid->kind < 2 ? 2 : solid->kind < 4 ? num_angles + 1 : 1;
}

static struct solid random_solid(int kind)
{
    struct solid solid = {.kind = kind};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            solid.map.m[i][j] = random_between(-1, 1) * (j == 3 ? 4 : 1);
    for (int i = 0; i < 3; i++)
        solid.r[i] = random_between(0.1, 1);
    if (kind == 1)
        solid.r[0] = 0;
    if (kind == 0 && random_between(0, 1) < 0.5)
        solid.r[1] = solid.r[0];
    if (kind == 3) {
        solid.r[1] = solid.r[2] = solid.r[0];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                solid.map.m[i][j] = i == j;
    }
    return solid;
}

static struct csgcast_scene *scene_of(const struct solid *solid)
{
    static const char *const texts[5] = {"cylinder(r1 = %.17g, r2 = %.17g, h = %.17g);",
                                         "cylinder(r1 = %.17g, r2 = %.17g, h = %.17g);",
                                         "ellipsoid(r = [%.17g, %.17g, %.17g]);",
                                         "sphere(r = %.17g);", "cube([%.17g, %.17g, %.17g]);"};
    const double(*m)[4] = solid->map.m;
    char text[1024];
    const int num = snprintf(text, sizeof text,
                             "multmatrix([[%.17g,%.17g,%.17g,%.17g],[%.17g,%.17g,%.17g,%.17g],"
                             "[%.17g,%.17g,%.17g,%.17g],[0,0,0,1]]) ",
                             m[0][0], m[0][1], m[0][2], m[0][3], m[1][0], m[1][1], m[1][2], m[1][3],
                             m[2][0], m[2][1], m[2][2], m[2][3]);
    snprintf(text + num, sizeof text - (size_t)num, texts[solid->kind], solid->r[0], solid->r[1],
             solid->r[2]);
    return csgcast_scene_parse(text, strlen(text), NULL);
}

/* From a few lengths away, from far away with a narrow field, in parallel. */
static struct csg_screen screen_of(int view, const struct csg_box *box)
{
    const double half = view == 0 ? 2 : view == 1 ? 0.012 : 7;
    const struct csgcast_frustum frustum = {.eye = {0, view == 1 ? -1000 : -11, 0.5},
                                            .right = {1, 0, 0},
                                            .up = {0, 0, 1},
                                            .forward = {0, 1, 0},
                                            .half_width = half,
                                            .half_height = half,
                                            .orthographic = view == 2};
    struct csg_screen screen;
    csg_screen_init(&screen, &frustum, size, size, box, true);
    return screen;
}

/* The test's own projection. */
static double pixel_of(int view, struct csg_vec3 p, int axis, double *depth)
{
    const double half = view == 0 ? 2 : view == 1 ? 0.012 : 7;
    *depth = p.y - (view == 1 ? -1000 : -11);
    return 0.5 * size * (1 + (axis ? p.z - 0.5 : p.x) / (half * (view == 2 ? 1 : *depth)));
}

static void check_side(int seed, int view, double lo, double hi, int first, int last)
{
    const double slack = SHORT * (hi - lo) + 0.02;
    const double low = ceil(lo - 0.5), high = floor(hi - 0.5);
    CHECK(first <= low || low < 0, "seed %d, view %d: %g starts at %d", seed, view, lo, first);
    CHECK(last >= high || high > size - 1, "seed %d, view %d: %g ends at %d", seed, view, hi, last);
    CHECK(first >= ceil(lo - slack - 0.5) || first == 0, "seed %d, view %d: %g starts at %d", seed,
          view, lo, first);
    CHECK(last <= floor(hi + slack - 0.5) || last == size - 1, "seed %d, view %d: %g ends at %d",
          seed, view, hi, last);
}

static void check_view(int seed, int view, const struct solid *solid,
                       const struct csgcast_scene *scene)
{
    const struct csg_crowd *crowd = scene->crowd;
    const struct csg_screen screen = screen_of(view, &scene->box);
    const struct csg_camera camera = csg_camera_of(&screen);
    const struct csg_vec3 center = {crowd->x[0], crowd->y[0], crowd->z[0]};
    const struct csg_seen_ball ball = csg_camera_see(&camera, center, crowd->radius[0]);
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY}, near = INFINITY, far = 0;
    double away = 0;
    for (int j = 0; j < num_rows(solid); j++)
        for (int i = 0; i < num_angles; i++) {
            const struct csg_vec3 p = point_of(solid, i, j);
            double depth = 0;
            for (int axis = 0; axis < 2; axis++) {
                const double pixel = pixel_of(view, p, axis, &depth);
                lo[axis] = fmin(lo[axis], pixel);
                hi[axis] = fmax(hi[axis], pixel);
            }
            near = fmin(near, depth);
            far = fmax(far, depth);
            away = fmax(away, csg_length(csg_sub(p, center)));
        }
    struct csg_footprint print;
    const bool shows =
        csg_outline_project(&camera, crowd->classes[0].outline, crowd->numbers, &ball, &print);
    CHECK(away <= crowd->radius[0] * (1 + 1e-9), "seed %d: a point outside of its ball", seed);
    if (!shows) {
        CHECK(hi[0] < 0.5 || hi[1] < 0.5 || lo[0] > size - 0.5 || lo[1] > size - 0.5 ||
                  ceil(lo[0] - 0.5) > floor(hi[0] - 0.5) || ceil(lo[1] - 0.5) > floor(hi[1] - 0.5),
              "seed %d, view %d: does not show", seed, view);
        return;
    }
    for (int axis = 0; axis < 2; axis++)
        check_side(seed, view, lo[axis], hi[axis], print.lo[axis], print.hi[axis]);
    CHECK(print.near <= near + 1e-9 && print.near >= near - SHORT * (far - near) - 1e-9,
          "seed %d, view %d: %.9g is nearest, not %.9g", seed, view, near, print.near);
}

int main(void)
{
    static const enum csg_outline kinds[5] = {CSG_OUTLINE_DISCS, CSG_OUTLINE_DISCS,
                                              CSG_OUTLINE_ELLIPSOID, CSG_OUTLINE_BALL,
                                              CSG_OUTLINE_BOX};
    int num_members = 0;
    for (int seed = 0; seed < num_solids; seed++) {
        const struct solid solid = random_solid(seed % 5);
        struct csgcast_scene *scene = scene_of(&solid);
        if (scene && scene->crowd->num == 1) {
            num_members++;
            CHECK(scene->crowd->classes[0].outline == kinds[solid.kind], "seed %d: outline %d",
                  seed, (int)scene->crowd->classes[0].outline);
            for (int view = 0; view < num_views; view++)
                check_view(seed, view, &solid, scene);
        }
        csgcast_scene_destroy(scene);
    }
    /* A box so askew that its faces are nearly parallel is none. */
    CHECK(num_members > num_solids - 5, "only %d are members", num_members);
    if (num_failed)
        fprintf(stderr, "%d checks failed\n", num_failed);
    return num_failed != 0;
}
