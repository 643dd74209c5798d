/* SPDX-License-Identifier: MIT */
/*
 * How boxes lie to leaves: where the answer is not "varies", all points of the box must agree with
 * it, for every kind of solid; and boxes small against the solid must get an answer now and then.
 * What cells keep of leaves must answer as the leaves do, and of balls also where these do not
 * know.
 */
#define DICE_SEED 11

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "carrier/side.h"
#include "cells/leaf.h"
#include "check.h"
#include "csg/scene.h"
#include "dice.h"

static struct csg_vec3 random_point(const struct csg_box *box)
{
    return csg_vec3(random_between(box->lo.x, box->hi.x), random_between(box->lo.y, box->hi.y),
                    random_between(box->lo.z, box->hi.z));
}

static struct csg_box random_box(void)
{
    const struct csg_box space = {{-9, -9, -9}, {9, 9, 9}};
    const struct csg_vec3 center = random_point(&space);
    const double size = random_between(0, 1) < 0.5 ? 0.3 : 3;
    const struct csg_vec3 half = csg_vec3(random_between(0.01, size), random_between(0.01, size),
                                          random_between(0.01, size));
    return (struct csg_box){csg_sub(center, half), csg_add(center, half)};
}

static const char text[] =
    "difference() { cube(18, center = true);\n"
    "cube([4, 6, 8]); rotate([10, 20, 30]) cube([4, 6, 8], center = true);\n"
    "sphere(5); scale([1, 2, 0.5]) sphere(3); rotate([40, 0, 0]) cylinder(h = 9, r = 3);\n"
    "rotate([40, 70, 0]) cylinder(h = 9, r1 = 3, r2 = 1, center = true); cylinder(h = 6, r1 = 4, "
    "r2 = 0);\n"
    "tetrahedron([[0, 0, 0], [6, 0, 0], [0, 7, 1], [1, 1, 8]]); hyperboloid(r = 2, c = 2, h = 9, "
    "center = true);\n"
    "hyperboloid(r = 2, c = 2, h = 7, sheets = 2); paraboloid(r = 3, c = 2, h = 6); paraboloid(r = "
    "3, saddle = true, h = 5);\n"
    "intersection() { cube(12, center = true); quadric([1, 0, 0, 0, 1, 0, 0, -1, 0, 0]); }\n"
    "intersection() { cube(12, center = true); quadric([-1, 0, 0, 0, -1, 0, 0, 1, 0, 2]); }\n"
    "intersection() { cube(12, center = true); quadric([1, 0.2, 0, 0, -1, 0, 0, -1, 0, 1]); } }\n";

static void check_points(const struct csg_shape *shape, const struct csg_box *box, uint8_t known,
                         uint32_t leaf)
{
    for (int i = 0; i < 8 && known != CSG_VARIES; i++)
        CHECK(csg_shape_contains(shape, random_point(box)) == (known == CSG_EVERYTHING), "leaf %u",
              leaf);
}

static void check_cell_leaf(const struct csgcast_scene *scene, const struct csg_cell_leaf *leaves,
                            uint32_t leaf, const struct csg_box *box, uint8_t known)
{
    const uint8_t own = csg_cell_leaf_side(scene, leaves, leaf, box);
    const bool ball = leaves[leaf].radius > 0;
    CHECK(own == known || (ball && known == CSG_VARIES), "leaf %u: its cells' answer", leaf);
    check_points(&scene->leaves[leaf].shape, box, own, leaf);
    if (scene->leaves[leaf].shape.has_quadric && known != CSG_NOTHING)
        CHECK(csg_cell_leaf_quadric_varies(scene, leaves, leaf, box) ==
                  csg_side_quadric_varies(scene, leaf, box),
              "leaf %u: its cells' quadric", leaf);
}

static void check_leaf(const struct csgcast_scene *scene, const struct csg_cell_leaf *leaves,
                       uint32_t leaf)
{
    const bool is_box = csg_side_is_box(scene, leaf);
    size_t num_known = 0;
    for (int i = 0; i < 3000; i++) {
        const struct csg_box box = random_box();
        const uint8_t known = csg_side_of_leaf(scene, leaf, is_box, &box);
        num_known += known != CSG_VARIES;
        CHECK(known == csg_side_of_leaf(scene, leaf, false, &box) || known == CSG_VARIES || is_box,
              "leaf %u: faces and box disagree", leaf);
        check_points(&scene->leaves[leaf].shape, &box, known, leaf);
        check_cell_leaf(scene, leaves, leaf, &box, known);
    }
    CHECK(num_known > 300, "leaf %u: %zu known", leaf, num_known);
}

int main(void)
{
    const struct csgcast_scene_params params = {.name = "side"};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    CHECK(scene != NULL, "the scene");
    struct csg_cell_leaf *leaves =
        scene ? csg_cell_leaves_create(scene, &scene->objects->data[0]) : NULL;
    CHECK(leaves != NULL && scene->objects->num == 1, "its leaves, as cells have them");
    size_t num_balls = 0;
    for (uint32_t leaf = 0; leaves && leaf < scene->num_leaves; leaf++) {
        num_balls += leaves[leaf].radius > 0;
        check_leaf(scene, leaves, leaf);
    }
    CHECK(num_balls == 1, "%zu balls", num_balls);
    free(leaves);
    csgcast_scene_destroy(scene);
    return num_failed != 0;
}
