/* SPDX-License-Identifier: MIT */
/*
 * Sections: an object cut out of a wide union becomes many objects, and they hold the same points.
 * What shall stay one object stays one.
 */
#define DICE_SEED 5

#include "prepare/distribute.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "csg/membership.h"
#include "dice.h"

enum { NUM_SOLIDS = 60, NUM_POINTS = 20000, MAX_TEXT = 1 << 16 };

static void add(char *text, const char *more)
{
    strncat(text, more, MAX_TEXT - strlen(text) - 1);
}

static void add_solids(char *text)
{
    static const char *const solids[] = {
        "sphere(2);", "cube([2, 3, 1]);", "cylinder(h = 4, r1 = 1, r2 = 2);",
        "difference() { cube(4, center = true); sphere(2.4); }",
        "intersection() { sphere(2); translate([1, 0, 0]) sphere(2); }"};
    for (int i = 0; i < NUM_SOLIDS; i++) {
        char place[128];
        snprintf(place, sizeof place, "translate([%.6f, %.6f, %.6f]) rotate([%.3f, %.3f, 0]) ",
                 random_between(-10, 10), random_between(-10, 10), random_between(-10, 10),
                 i % 3 * random_between(0, 90), i % 3 * random_between(0, 90));
        add(text, place);
        add(text, solids[i % 5]);
    }
}

static struct csgcast_scene *load(const char *text)
{
    const struct csgcast_scene_params params = {.name = "distribute"};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    CHECK(scene != NULL, "%.80s", text);
    return scene;
}

static bool holds(const struct csgcast_scene *scene, struct csg_vec3 point)
{
    for (size_t i = 0; i < scene->objects->num; i++)
        if (csg_object_contains(scene, &scene->objects->data[i], point))
            return true;
    return false;
}

/* op of a union and what cuts it, as one scene and as two. */
static void check_same(const char *op, const char *solids, const char *cut)
{
    static char text[2 * MAX_TEXT];
    const bool is_difference = strcmp(op, "difference") == 0;
    snprintf(text, sizeof text, "%s() { union() { %s } %s }", op, solids, cut);
    struct csgcast_scene *whole = load(text), *all = load(solids), *other = load(cut);
    size_t num_in = 0;
    CHECK(whole->objects->num > NUM_SOLIDS / 4, "%s with %s: %zu objects", op, cut,
          whole->objects->num);
    for (int i = 0; i < NUM_POINTS; i++) {
        const struct csg_vec3 point =
            csg_vec3(random_between(-12, 12), random_between(-12, 12), random_between(-12, 12));
        const bool in = holds(whole, point);
        num_in += in;
        CHECK(in == (holds(all, point) && holds(other, point) != is_difference),
              "%s with %s at %g %g %g", op, cut, point.x, point.y, point.z);
    }
    CHECK(num_in > NUM_POINTS / 50, "%zu points inside", num_in);
    csgcast_scene_destroy(whole);
    csgcast_scene_destroy(all);
    csgcast_scene_destroy(other);
}

/* Each part knows the first solid of all, whose colour its cut faces may take. */
static void check_minuends(const char *solids)
{
    static char text[2 * MAX_TEXT];
    snprintf(text, sizeof text, "difference() { union() { %s } cube(30); }", solids);
    struct csgcast_scene *scene = load(text);
    const struct csg_node *nodes = scene->trees[CSG_LAYER_MODEL].data;
    for (size_t i = 0; i < scene->objects->num; i++) {
        const struct csg_object *object = &scene->objects->data[i];
        const struct csg_leaf *minuend = csg_object_minuend(scene, object);
        CHECK(nodes[object->begin].op == CSG_LEAF || minuend == &scene->leaves[0],
              "object %zu has another minuend", i);
    }
    csgcast_scene_destroy(scene);
}

/* Painted as a whole, so drawn as a whole. */
static void check_one(const char *paint, const char *solids)
{
    static char text[2 * MAX_TEXT];
    size_t num = 0;
    snprintf(text, sizeof text, "difference() { %s union() { %s } cube(30); }", paint, solids);
    struct csgcast_scene *scene = load(text);
    for (size_t i = 0; i < scene->objects->num; i++)
        num += scene->objects->data[i].layer == CSG_LAYER_MODEL;
    CHECK(num == 1, "%s: %zu objects", paint, num);
    csgcast_scene_destroy(scene);
}

int main(void)
{
    static char solids[MAX_TEXT], nested[2 * MAX_TEXT];
    add_solids(solids);
    check_same("difference", solids, "cube(30);");
    check_same("difference", solids, "rotate([20, 30, 0]) cube(30); sphere(5);");
    check_same("intersection", solids, "sphere(9);");
    check_same("intersection", solids, "difference() { cylinder(h = 40, r = 9); sphere(6); }");
    check_same("intersection", solids,
               "polyhedron([[-20, -20, -20], [30, 0, 0], [0, 30, 0], [3, 3, 30]], "
               "[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]);");
    snprintf(nested, sizeof nested, "difference() { union() { %s } sphere(7); }", solids);
    check_same("difference", nested, "translate([0, 0, 3]) cube(30);");
    check_minuends(solids);
    check_one("color([1, 0, 0, 0.5])", solids);
    check_one("#", solids);
    return num_failed != 0;
}
