/* SPDX-License-Identifier: MIT */

/* Which objects are drawn in double, and why; and the rule for an eye on a surface. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "csgcast/csgcast.h"

enum { SIZE = 16 };

struct choice {
    const char *text;
    double eye[3], center[3];
    size_t num;      /* objects in double */
    const char *why; /* a part of what numerics says */
};

static const struct choice choices[] = {
    {"cube(10); sphere(r = 7);", {40, 30, 20}, {0, 0, 0}, 0, ""},
    {"cylinder(r = 3, h = 10);", {1e6, 3e5, 2e5}, {0, 0, 0}, 0, ""},
    {"difference() { cube(10); cube(5); }", {40, 30, 20}, {0, 0, 0}, 0, ""},
    {"intersection() { cylinder(r = 7, h = 20, center = true); rotate([90, 0, 0]) "
     "cylinder(r = 7, h = 20, center = true); cube(13, center = true); }",
     {40, 30, 20},
     {0, 0, 0},
     0,
     ""},
    {"cube([10, 10, 1e-6]);", {40, 30, 20}, {5, 5, 0}, 1, "thick"},
    /* alone it would cover no pixel's centre, and need nothing */
    {"difference() { cylinder(r = 1e-4, h = 10); translate([0, 0, 9]) cube(5); }",
     {40, 30, 20},
     {0, 0, 5},
     1,
     "radius of curvature"},
    {"difference() { sphere(r = 10); sphere(r = 9.99999); }", {40, 30, 20}, {0, 0, 0}, 1, "apart"},
    /* a pocket's floor and a hole's ceiling: a wall where they lie above each other */
    {"difference() { cube([40, 10, 10]); translate([2, 2, 6]) cube([5, 5, 9]);"
     " translate([3, 3, -1]) cube([5, 5, 6.99999]); }",
     {80, 60, 40},
     {20, 5, 5},
     1,
     "apart"},
    {"difference() { cube([40, 10, 10]); translate([2, 2, 6]) cube([5, 5, 9]);"
     " translate([30, 2, -1]) cube([5, 5, 6.99999]); }",
     {80, 60, 40},
     {20, 5, 5},
     0,
     ""},
    {"difference() { cube([40, 10, 10]); translate([2, 2, 6]) cube([5, 5, 9]);"
     " translate([5, 3, 6]) rotate([0, 0.001, 0]) translate([0, 0, -7]) cube([5, 5, 7]); }",
     {80, 60, 40},
     {20, 5, 5},
     1,
     "radians"},
    {"difference() { cube([40, 10, 10]); translate([2, 2, 6]) cube([5, 5, 9]);"
     " translate([30, 3, 6]) rotate([0, 0.001, 0]) translate([0, 0, -7]) cube([5, 5, 7]); }",
     {80, 60, 40},
     {20, 5, 5},
     0,
     ""},
    /* rings of a profile are thin where its corners are close; what counts is the profile */
    {"difference() { rotate_extrude($fn = 360) translate([50, 0]) circle(1, $fn = 360);"
     " cube(60); }",
     {200, 150, 100},
     {0, 0, 0},
     0,
     ""},
    {"difference() { rotate_extrude($fn = 60) polygon([[0, 0], [9, 0], [9, 3], [19, 3],"
     " [19, 3.00001], [9, 3.00001], [9, 4], [8, 5], [7, 5.5], [6, 5.7], [5, 5.8], [0, 5.8]]); "
     "cube(60); }",
     {80, 60, 40},
     {0, 0, 0},
     1,
     "1e-05"},
    {"tetrahedron(points = [[-9, -9, 0], [9, -9, 0], [0, 9, 0], [0, 0, 0.0004]]);",
     {40, 30, 20},
     {0, 0, 0},
     1,
     "radians"},
    {"translate([-50, -50, -10]) cube([100, 100, 10]);",
     {0, 0, 0.01},
     {9, 0, -1},
     1,
     "close to a face"},
    /* only the object that needs it, and those that share a surface with it where they meet it */
    {"cube([10, 10, 1e-6]); translate([20, 20, 3]) sphere(r = 2);",
     {40, 30, 20},
     {5, 5, 0},
     1,
     "thick"},
    {"cube([10, 10, 1e-6]); color(\"red\") translate([9, 0, 0]) cube(5); "
     "color(\"red\") translate([20, 0, 0]) cube(5); translate([0, 20, 3]) cube(5);",
     {80, 60, 40},
     {5, 5, 0},
     2,
     "shares"},
    /* what is beside it on the other side of a plane has no pixel in common with it */
    {"linear_extrude(4) polygon([[0, 0], [10, 0], [10, 1e-4]]); color(\"red\") linear_extrude(4) "
     "polygon([[0, 0], [10, 1e-4], [9, 5]]); color(\"green\") linear_extrude(4) "
     "polygon([[0, 0], [9, 5], [5, 9]]);",
     {40, 30, 20},
     {5, 2, 0},
     1,
     "radians"},
    {"linear_extrude(4) polygon([[0, 0], [10, 0], [10, 1e-4]]); color(\"red\") linear_extrude(4) "
     "polygon([[0, 0], [10, -1e-4], [9, 5]]); color(\"green\") linear_extrude(4) "
     "polygon([[0, 0], [9, 5], [5, 9]]);",
     {40, 30, 20},
     {5, 2, 0},
     2,
     "shares"},
    /* edges that are nearly flat, between faces on the same side, are no matter */
    {"intersection() { cube(10); rotate([0.001, 0, 0]) translate([-1, -1, -1]) cube([12, 12, 11]); "
     "}",
     {40, 30, 20},
     {5, 5, 5},
     0,
     ""},
    {"difference() { cube(10); rotate([0.001, 0, 0]) translate([-1, -1, -1]) cube([12, 12, 11]); }",
     {40, 30, 20},
     {5, 5, 10},
     1,
     "radians"},
};

static struct csgcast_scene *parse(const char *text)
{
    return csgcast_scene_parse(text, strlen(text), NULL);
}

static struct csgcast_view view_of(const double eye[3], const double center[3])
{
    struct csgcast_view view = {
        .width = SIZE, .height = SIZE, .camera = {.kind = CSGCAST_CAMERA_VECTOR}};
    memcpy(view.camera.eye, eye, sizeof view.camera.eye);
    memcpy(view.camera.center, center, sizeof view.camera.center);
    return view;
}

static void check_choice(struct csgcast_renderer *renderer, const struct choice *choice)
{
    float z[SIZE * SIZE];
    struct csgcast_stats stats;
    struct csgcast_scene *scene = parse(choice->text);
    const struct csgcast_view view = view_of(choice->eye, choice->center);
    CHECK(scene && csgcast_render(renderer, scene, &view, &(struct csgcast_image){.z = z}), "%s",
          choice->text);
    csgcast_renderer_get_stats(renderer, &stats);
    CHECK(stats.precise_objects == choice->num, "%s: %zu: %s", choice->text, stats.precise_objects,
          stats.numerics);
    CHECK(strstr(stats.numerics, choice->why), "%s: %s", choice->text, stats.numerics);
    csgcast_scene_destroy(scene);
}

/* Of a profile by itself the rings are one object where float does not hold them one by one. */
static void check_rings(struct csgcast_renderer *renderer)
{
    char text[4096];
    float z[SIZE * SIZE];
    struct csgcast_stats stats;
    int at = snprintf(text, sizeof text, "rotate_extrude($fn = 60) polygon([[0, 0]");
    for (int i = 0; i < 100; i++)
        at += snprintf(text + at, sizeof text - (size_t)at, ", [%d, %g]", 9 + i % 2, 0.005 * i);
    snprintf(text + at, sizeof text - (size_t)at, ", [9, 10], [0, 10]]);");
    struct csgcast_scene *scene = parse(text);
    const struct csgcast_view view = view_of((double[3]){60, 40, 30}, (double[3]){0, 0, 0});
    CHECK(scene && csgcast_render(renderer, scene, &view, &(struct csgcast_image){.z = z}),
          "rings");
    csgcast_renderer_get_stats(renderer, &stats);
    CHECK(stats.precise_objects == 0, "rings: %zu: %s", stats.precise_objects, stats.numerics);
    csgcast_scene_destroy(scene);
}

/* They are, too, where they lie far around the axis and what is turned is small. */
static void check_wide_rings(void)
{
#define RING "rotate_extrude($fn = 60) translate([50, 0]) circle(1, $fn = 24);"
    static const struct {
        const char *text;
        size_t num;
    } cases[] = {
        {RING, 1},
        {RING "translate([150, 0]) " RING "translate([0, 150]) " RING "translate([150, 150]) " RING,
         48},
        {"rotate_extrude($fn = 60) translate([50, 0]) circle(10, $fn = 24);", 12},
        {"rotate_extrude($fn = 60) translate([50, 0]) scale([1, 30]) circle(1, $fn = 24);", 12},
        {"rotate_extrude($fn = 60) translate([50, 0]) circle(1, $fn = 8);", 4},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct csgcast_scene_info info = {0};
        struct csgcast_scene *scene = parse(cases[i].text);
        CHECK(scene, "%s", cases[i].text);
        csgcast_scene_get_info(scene, &info);
        CHECK(info.num_objects == cases[i].num, "%s: %zu", cases[i].text, info.num_objects);
        csgcast_scene_destroy(scene);
    }
}

/* Without double in the driver the CPU casts those pixels, and the picture is the same. */
static void check_cpu(struct csgcast_renderer *with, struct csgcast_renderer *without)
{
    const struct choice *choice = &choices[6];
    float z[2][SIZE * SIZE];
    uint8_t colors[2][4 * SIZE * SIZE];
    struct csgcast_stats stats;
    struct csgcast_scene *scene = parse(choice->text);
    const struct csgcast_view view = view_of(choice->eye, choice->center);
    CHECK(csgcast_render(with, scene, &view, &(struct csgcast_image){.z = z[0]}), "double");
    CHECK(csgcast_render(without, scene, &view,
                         &(struct csgcast_image){.z = z[1], .rgba8 = colors[0]}),
          "CPU");
    CHECK(csgcast_render(without, scene, &view, &(struct csgcast_image){.rgba8 = colors[1]}),
          "colours alone");
    CHECK(memcmp(colors[0], colors[1], sizeof colors[0]) == 0, "the same colours");
    csgcast_renderer_get_stats(without, &stats);
    CHECK(stats.unfinished_pixels > 0 && strstr(stats.variants, "reference 1"), "%s",
          stats.variants);
    for (int i = 0; i < SIZE * SIZE; i++)
        CHECK(z[0][i] == z[1][i] || fabsf(z[0][i] - z[1][i]) < 1e-5f * z[1][i], "pixel %d", i);
    csgcast_scene_destroy(scene);
}

/* An eye on a surface: where its rays go into the solid they start inside, else outside. */
struct on_surface {
    const char *text;
    double eye[3], center[3];
    double depth;
};

static const struct on_surface on_surfaces[] = {
    {"cube(10);", {5, 5, 10}, {5, 5, 0}, 10},
    {"cube(10);", {5, 5, 10}, {5, 5, 20}, INFINITY},
    {"cube(10);", {10, 10, 10}, {5, 5, 5}, 17.320508},
    {"cube(10); translate([0, 0, -20]) cube(10);", {5, 5, 10}, {5, 5, 0}, 10},
    {"cube(10); translate([3, 3, -5]) cube(10);", {5, 5, 10}, {5, 5, 0}, 15},
    {"cube(10); translate([0, 0, 15]) cube(10);", {5, 5, 10}, {5, 5, 20}, 5},
    {"sphere(r = 5);", {0, 0, 5}, {0, 0, 0}, 10},
    {"sphere(r = 5);", {3, 0, 4}, {6, 0, 8}, INFINITY},
    {"cylinder(r = 5, h = 10);", {3, 4, 5}, {-3, -4, 5}, 10},
    {"cylinder(r1 = 5, r2 = 0, h = 10);", {0, 0, 10}, {0, 0, 0}, 10},
    {"difference() { cube(10); translate([2, 2, 5]) cube(20); }", {5, 5, 5}, {5, 5, 0}, 5},
    {"difference() { cube(10); translate([2, 2, 5]) cube([20, 20, 3]); }", {5, 5, 5}, {5, 5, 9}, 3},
    {"rotate([30, 40, 50]) cube(10, center = true);", {0, 0, 0}, {0, 0, -1}, 0},
};

static void check_on_surface(struct csgcast_renderer *renderer, const struct on_surface *at)
{
    float z[SIZE * SIZE];
    struct csgcast_scene *scene = parse(at->text);
    struct csgcast_view view = view_of(at->eye, at->center);
    view.camera.fov = 0.5; /* the middle of the picture is enough */
    CHECK(scene && csgcast_render(renderer, scene, &view, &(struct csgcast_image){.z = z}), "%s",
          at->text);
    const double depth = (double)z[SIZE / 2 * SIZE + SIZE / 2];
    if (at->depth > 0)
        CHECK(isinf(at->depth) ? isinf(depth) : fabs(depth / at->depth - 1) < 0.02,
              "%s from %g %g %g with %s: %g instead of %g", at->text, at->eye[0], at->eye[1],
              at->eye[2], csgcast_renderer_name(renderer), depth, at->depth);
    csgcast_scene_destroy(scene);
}

int main(void)
{
    const struct csgcast_renderer_params reference = {.backend = CSGCAST_BACKEND_REFERENCE};
    struct csgcast_renderer *gl = csgcast_renderer_create(NULL);
    struct csgcast_renderer *cpu = csgcast_renderer_create(&reference);
    setenv("CSGCAST_NO_DOUBLE", "1", 1);
    struct csgcast_renderer *single = csgcast_renderer_create(NULL);
    CHECK(gl && cpu && single, "renderers");
    if (num_failed)
        return 1;
    for (size_t i = 0; i < sizeof choices / sizeof *choices; i++)
        check_choice(gl, &choices[i]);
    check_rings(gl);
    check_wide_rings();
    check_cpu(gl, single);
    for (size_t i = 0; i < sizeof on_surfaces / sizeof *on_surfaces; i++) {
        check_on_surface(gl, &on_surfaces[i]);
        check_on_surface(cpu, &on_surfaces[i]);
    }
    csgcast_renderer_destroy(gl);
    csgcast_renderer_destroy(cpu);
    csgcast_renderer_destroy(single);
    return num_failed != 0;
}
