/* SPDX-License-Identifier: MIT */
/*
 *     cells egl|osmesa ROUNDS
 *
 * Draws scenes in cells and by the loop over whole trees: leaf, depth and normal of every pixel
 * must be the same bits. Scenes: a sponge whose holes go through each other, a plate of round
 * holes, boxes through one point, flush holes, balls that overlap, nested cubes in one place, a
 * hole that samples of tiles miss, and random trees, on a grid (faces coincide) and off it. Then
 * scenes whose solids are moved about, as their cells keep what an edit does not change.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "csgcast/csgcast.h"
#include "ideal/text.h"
#include "random_scene.h"

enum { SIZE = 160 };

struct picture {
    float z[SIZE * SIZE], normal[SIZE * SIZE * 3], id[SIZE * SIZE];
};

static const char *const turns[3] = {"[0,0,0]", "[90,0,0]", "[0,90,0]"};

/* Squares of a sponge's side, each a box through the whole cube along each axis. */
static void put_holes(struct text *text, int level, double x, double y, double size)
{
    const double third = size / 3;
    if (level == 0)
        return;
    for (int axis = 0; axis < 3; axis++)
        text_put(text, "rotate(%s) translate([%.17g,%.17g,-20]) cube([%.17g,%.17g,40]);\n",
                 turns[axis], x + third, y + third, third, third);
    for (int i = 0; i < 9; i++)
        if (i != 4)
            put_holes(text, level - 1, x + i % 3 * third, y + i / 3 * third, third);
}

static char *sponge(void)
{
    struct text text = {0};
    text_put(&text, "difference() { cube(27, center = true);\n");
    put_holes(&text, 3, -13.5, -13.5, 27);
    text_put(&text, "}\n");
    return text.data;
}

static char *plate(void)
{
    struct text text = {0};
    text_put(&text, "difference() { rotate([20,30,40]) cube([60,60,4]);\n");
    for (int i = 0; i < 16 * 16; i++)
        text_put(&text,
                 "rotate([20,30,40]) translate([%g,%g,-1]) cylinder(h = 6, r1 = 1.2, r2 = %g);\n",
                 2 + 3.7 * (i % 16), 2 + 3.7 * (i / 16), 0.4 + 0.05 * (i % 7));
    text_put(&text, "}\n");
    return text.data;
}

/* Boxes through one point, so that its cell needs many bunches; some of them coincide. */
static char *star(void)
{
    struct text text = {0};
    text_put(&text, "difference() { intersection() { cube(20, center = true); "
                    "rotate([0,0,45]) cube([22,22,18], center = true); }\n");
    for (int i = 0; i < 90; i++)
        text_put(&text, "rotate([%d,%d,%d]) cube([%g,%g,40], center = true);\n", 37 * i % 180,
                 53 * i % 180, 15 * (i % 12), 0.3 + 0.1 * (i % 4), 0.2 + 0.1 * (i % 3));
    text_put(&text, "}\n");
    return text.data;
}

/* Round and square holes that begin and end flush, on a grid, in the common part of two solids. */
static char *rods(void)
{
    struct text text = {0};
    text_put(&text, "difference() { cylinder(h = 20, r = 16); translate([-12,-12,0]) "
                    "cube([24,24,4]);\n");
    for (int i = 0; i < 120; i++)
        text_put(&text,
                 i % 3 ? "translate([%d,%d,%d]) cylinder(h = %d, r1 = 1, r2 = %g);\n"
                       : "translate([%d,%d,%d]) cube([2,2,%d]);\n",
                 2 * (i % 15) - 14, 2 * (i / 15) - 8, 4 * (i % 4), 4 + 4 * (i % 3),
                 0.5 * (1 + i % 3));
    text_put(&text, "}\n");
    return text.data;
}

/* Balls of which few bound what all of them have in common, less balls that are in each other; each
 * has a twin that is too near for it to be told which of both matters. */
static char *balls(void)
{
    struct text text = {0};
    text_put(&text, "difference() { intersection() {\n");
    for (int i = 0; i < 300; i++)
        text_put(&text, "translate([%.17g,%.17g,%.17g]) sphere(%.17g);\n",
                 0.3 * (i / 2 * 17 % 11) - 1.5, 0.3 * (i / 2 * 29 % 13) - 1.8,
                 0.2 * (i / 2 % 5) + 1e-7 * (i % 2), 10 + 0.05 * (i / 2 * 23 % 40));
    text_put(&text, "}\n");
    for (int i = 0; i < 300; i++)
        text_put(&text, "translate([%.17g,%.17g,%.17g]) sphere(%.17g);\n", 8 - 0.5 * (i / 2 % 9),
                 0.5 * (i / 2 * 5 % 8) - 7, 3 + 0.4 * (i / 2 % 6) + 1e-7 * (i % 2),
                 1 + 0.1 * (i / 2 * 31 % 30));
    text_put(&text, "}\n");
    return text.data;
}

/* Balls that overlap at one corner of a cube, beside the places where tiles are sampled. */
static char *corner(void)
{
    struct text text = {0};
    text_put(&text, "difference() { cube(100, center = true);\n");
    for (int i = 0; i < 900; i++)
        text_put(&text, "translate([%d,%d,%d]) sphere(%.17g);\n", 45 + i * 17 % 11,
                 45 + i * 29 % 13, 45 + i * 7 % 10, 14 + 0.01 * (i * 23 % 400));
    text_put(&text, "}\n");
    return text.data;
}

static char *nest(void)
{
    struct text text = {0};
    text_put(&text, "intersection() { sphere(12); union() {\n");
    for (int i = 1; i < 200; i++)
        text_put(&text, "rotate([%d,0,%d]) cube(%g, center = true);\n", i, 2 * i, 0.1 * i);
    text_put(&text, "}}\n");
    return text.data;
}

static bool draw(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                 struct csgcast_view *view, const char *variant, struct picture *picture)
{
    const struct csgcast_image image = {
        .z = picture->z, .normal = picture->normal, .id = picture->id};
    view->variant = variant;
    return csgcast_render(renderer, scene, view, &image);
}

static const struct csgcast_camera cameras[] = {
    {0},
    {.kind = CSGCAST_CAMERA_GIMBAL, .rotate = {90, 0, 0}, .viewall = true, .autocenter = true},
    {.kind = CSGCAST_CAMERA_GIMBAL,
     .rotate = {110, 20, 200},
     .projection = CSGCAST_ORTHOGRAPHIC,
     .viewall = true,
     .autocenter = true},
    {.kind = CSGCAST_CAMERA_VECTOR, .eye = {1.3, -2.1, 0.7}, .center = {5, 4, 3}, .fov = 70},
    {.kind = CSGCAST_CAMERA_VECTOR, .eye = {40, -35, 30}, .center = {0, 4, 1}, .fov = 60},
};

/* variant: cells, or auto, which may choose them. in_cells: whether the scene must be drawn so at
 * least once. */
static bool check(struct csgcast_renderer *renderer, const char *name, char *text,
                  const char *variant, bool in_cells)
{
    static struct picture cells, loop;
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    bool ok = scene != NULL, used = false;
    for (size_t i = 0; ok && i < sizeof cameras / sizeof *cameras; i++) {
        struct csgcast_view view = {.width = SIZE, .height = SIZE, .camera = cameras[i]};
        struct csgcast_stats stats;
        ok = draw(renderer, scene, &view, variant, &cells);
        csgcast_renderer_get_stats(renderer, &stats);
        const bool is_used = strstr(stats.variants, "cells") != NULL;
        if (ok && in_cells && used && is_used && stats.bytes_uploaded >= stats.texture_bytes) {
            printf("FAIL %s, camera %zu: cells are handed over again\n", name, i);
            ok = false;
        }
        used |= is_used;
        ok = ok && draw(renderer, scene, &view, "loop", &loop);
        if (ok && memcmp(&cells, &loop, sizeof cells) != 0) {
            printf("FAIL %s, camera %zu: cells and loop differ\n", name, i);
            ok = false;
        }
    }
    if (ok && in_cells && !used) {
        printf("FAIL %s: never drawn in cells\n", name);
        ok = false;
    }
    csgcast_scene_destroy(scene);
    free(text);
    return ok;
}

/* Onto the grid, off it, and away; the first leaf, which most of the others are cut from, too. */
static bool move_leaf(struct csgcast_scene *scene, int round)
{
    static const double steps[3][3] = {{3, 0, 0}, {0.37, -0.21, 0.11}, {0, 1, 60}};
    struct csgcast_leaf leaf;
    const size_t num = csgcast_scene_num_leaves(scene);
    const size_t index = round % 8 == 7 ? 0 : (size_t)round * 7919 % num;
    if (!csgcast_scene_get_leaf(scene, index, &leaf))
        return false;
    for (int i = 0; i < 3; i++)
        leaf.matrix[4 * i + 3] += steps[round % 3][i];
    return csgcast_scene_set_matrix(scene, index, leaf.matrix);
}

static bool check_edits(struct csgcast_renderer *renderer, const char *name, char *text)
{
    static struct picture cells, loop;
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    bool ok = scene != NULL;
    for (int round = 0; ok && round < 12; round++) {
        struct csgcast_view view = {.width = SIZE, .height = SIZE, .camera = cameras[round % 3]};
        ok = move_leaf(scene, round) && draw(renderer, scene, &view, "cells", &cells) &&
             draw(renderer, scene, &view, "loop", &loop);
        if (ok && memcmp(&cells, &loop, sizeof cells) != 0) {
            printf("FAIL %s, edit %d: cells and loop differ\n", name, round);
            ok = false;
        }
    }
    csgcast_scene_destroy(scene);
    free(text);
    return ok;
}

int main(int argc, char **argv)
{
    if (argc != 3)
        return 2;
    const struct csgcast_renderer_params params = {
        .backend = strcmp(argv[1], "egl") == 0 ? CSGCAST_BACKEND_EGL : CSGCAST_BACKEND_OSMESA};
    struct csgcast_renderer *renderer = csgcast_renderer_create(&params);
    if (!renderer)
        return 1;
    bool ok = check(renderer, "sponge", sponge(), "cells", true);
    ok &= check(renderer, "plate", plate(), "cells", true);
    ok &= check(renderer, "star", star(), "cells", true);
    ok &= check(renderer, "rods", rods(), "cells", true);
    ok &= check(renderer, "balls", balls(), "cells", true);
    ok &= check(renderer, "nest", nest(), "cells", true);
    ok &= check(renderer, "corner", corner(), "auto", true);
    ok &= check_edits(renderer, "edited sponge", sponge());
    ok &= check_edits(renderer, "edited plate", plate());
    ok &= check_edits(renderer, "edited rods", rods());
    ok &= check_edits(renderer, "edited balls", balls());
    struct random_state random = {2026};
    for (int i = 0; i < atoi(argv[2]); i++) {
        const struct random_params tree = {2 + i % 7, 8 + i * 11 % 60, i % 2 ? 1 : 0, i % 3 == 0};
        char name[32];
        snprintf(name, sizeof name, "random %d", i);
        ok &= check(renderer, name, random_scene(&random, &tree), "cells", false);
    }
    csgcast_renderer_destroy(renderer);
    return !ok;
}
