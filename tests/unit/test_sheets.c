/* SPDX-License-Identifier: MIT */
/*
 * Faces without volume: they show as solids of a union do, which is what OpenSCAD's preview and its
 * mesh have of them, but are left out where they are taken away, and in Booleans where they have
 * two sides.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "csg/scene.h"

#define POINTS "points = [[0,0,5],[9,0,5],[9,9,5],[0,9,5]]"
#define SHEET "polyhedron(" POINTS ", faces = [[0,1,2,3]]);"
#define BOTH_SIDES "polyhedron(" POINTS ", faces = [[0,1,2,3], [3,2,1,0]]);"

/* Two tetrahedra with the face 0 1 2 in common. */
#define TOUCHING                                                                                   \
    "polyhedron(points = [[0,0,5],[9,0,5],[0,9,5],[0,0,9],[0,0,1]], faces = [[0,1,2], [2,1,0], "   \
    "[0,3,1], [1,3,2], [2,3,0], [0,1,4], [1,2,4], [2,0,4]]);"

/* Corners in a plane but for the last bit of one. */
#define THIN                                                                                       \
    "polyhedron(points = [[0,0,5],[9,0,5],[9,9,5],[0,9,5.000000000000001]], faces = [[0,1,2,3]]);"

static void silent(void *user, enum csgcast_log_level level, enum csgcast_message id,
                   const char *text)
{
    (void)user, (void)level, (void)id, (void)text;
}

static void test_leaves(const char *text, size_t num_leaves)
{
    const struct csgcast_scene_params params = {.log = silent};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    struct csgcast_scene_info info;
    CHECK(scene, "%s", text);
    csgcast_scene_get_info(scene, &info);
    CHECK(info.num_leaves == num_leaves, "%s: %zu leaves, not %zu", text, info.num_leaves,
          num_leaves);
    csgcast_scene_destroy(scene);
}

/* A pit from above and one from below that end in the same face, [0, 3] x [0, 3] at z = 5. */
static const char pits[] =
    "polyhedron(points = [[-9,-9,0],[9,-9,0],[9,9,0],[-9,9,0],[-9,-9,9],[9,-9,9],[9,9,9],[-9,9,9],"
    "[0,0,5],[3,0,5],[3,3,5],[0,3,5]], faces = [[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7],"
    "[4,5,9,8],[5,6,10,9],[6,7,11,10],[7,4,8,11],[8,9,10,11],"
    "[1,0,8,9],[2,1,9,10],[3,2,10,11],[0,3,11,8],[11,10,9,8]]);";

/* The distance from an eye down to what is at x and y. */
static void test_depth_from(enum csgcast_backend backend, const char *text, double x, double y,
                            double eye, float z)
{
    const struct csgcast_scene_params params = {.log = silent, .facets = CSGCAST_FACETS_AS_WRITTEN};
    const struct csgcast_renderer_params renderer_params = {.backend = backend};
    const struct csgcast_view view = {
        .width = 1,
        .height = 1,
        .camera = {.kind = CSGCAST_CAMERA_VECTOR, .eye = {x, y, eye}, .center = {x, y, eye - 100}}};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    struct csgcast_renderer *renderer = csgcast_renderer_create(&renderer_params);
    float seen = NAN;
    const struct csgcast_image image = {.z = &seen};
    CHECK(scene && renderer && csgcast_render(renderer, scene, &view, &image), "%s", text);
    CHECK(seen == z || fabsf(seen - z) < 1e-4f, "%s: %g, not %g", text, (double)seen, (double)z);
    csgcast_renderer_destroy(renderer);
    csgcast_scene_destroy(scene);
}

static void test_depth(enum csgcast_backend backend, const char *text, double x, double y, float z)
{
    test_depth_from(backend, text, x, y, 100, z);
}

static void test_depths(enum csgcast_backend backend)
{
    static const char half[] = "multmatrix([[1,0,0,0],[0,0,-1,0],[0,1,0,0],[0,0,0,1]]) "
                               "rotate_extrude(angle = 180, $fn = 3) polygon([[1,0],[2,0],[1,1]]);";
    char cut[sizeof pits + 64];
    snprintf(cut, sizeof cut, "difference() { %s sphere(0.1); }", pits);
    test_depth(backend, pits, 1.1, 1.2, 95);
    test_depth(backend, pits, -8.9, -8.9, 91.044444f);
    test_depth(backend, cut, 1.1, 1.2, INFINITY);
    test_depth(backend, BOTH_SIDES, 1.1, 1.2, 95);
    test_depth(backend, "hull() { " THIN " }", 1.1, 1.2, 95);
    test_depth(backend, half, 0.1, -0.2, 100);
    test_depth(backend, half, 0.1, -1.2, INFINITY);
    test_depth_from(backend, TOUCHING, 1, 1.5, 6, 6 - 1 - 4 * 2.5f / 9);
    test_depth_from(backend, TOUCHING, 1, 1.5, 100, 95 - 4 * 6.5f / 9);
}

int main(void)
{
    test_depths(CSGCAST_BACKEND_REFERENCE);
    test_depths(CSGCAST_BACKEND_AUTO);
    test_leaves(SHEET, 1);
    test_leaves("cube(20); " SHEET, 2);
    test_leaves(BOTH_SIDES, 1);
    test_leaves("cube(20); " BOTH_SIDES, 2);
    test_leaves("polyhedron(" POINTS ", faces = [[0,1,2,3], [2,1,0], [3,2,0]]);", 1);
    test_leaves("difference() { " BOTH_SIDES " sphere(9); }", 0);
    test_leaves("difference() { cube(20); " BOTH_SIDES "}", 1);
    test_leaves("hull() { cube(20); " BOTH_SIDES "}", 1);
    test_leaves("hull() { " SHEET " }", 0);
    test_leaves("hull() { " THIN " }", 1);
    test_leaves("difference() { hull() { " THIN " } sphere(1); }", 0);
    test_leaves(TOUCHING, 2);
    test_leaves("difference() { " TOUCHING " sphere(1); }", 2);
    test_leaves("difference() { cube(20); " SHEET "}", 1);
    test_leaves("difference() { " SHEET "difference() { cube(20); sphere(9); } }", 3);
    test_leaves("difference() { cube(20); cube([20, 20, 5]); cube([20, 20, 0]); }", 2);
    return num_failed > 0;
}
