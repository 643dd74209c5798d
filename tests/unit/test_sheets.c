/* SPDX-License-Identifier: MIT */
/*
 * Single faces without volume: they show as solids of a union do, which is what OpenSCAD's preview
 * has of them, but are left out where they are taken away, and where they have two sides.
 */
#include <string.h>

#include "check.h"
#include "csg/scene.h"

#define POINTS "points = [[0,0,5],[9,0,5],[9,9,5],[0,9,5]]"
#define SHEET "polyhedron(" POINTS ", faces = [[0,1,2,3]]);"
#define BOTH_SIDES "polyhedron(" POINTS ", faces = [[0,1,2,3], [3,2,1,0]]);"

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

int main(void)
{
    test_leaves(SHEET, 1);
    test_leaves("cube(20); " SHEET, 2);
    test_leaves(BOTH_SIDES, 0);
    test_leaves("difference() { cube(20); " SHEET "}", 1);
    test_leaves("difference() { " SHEET "difference() { cube(20); sphere(9); } }", 3);
    test_leaves("difference() { cube(20); cube([20, 20, 5]); cube([20, 20, 0]); }", 2);
    return num_failed > 0;
}
