/* SPDX-License-Identifier: MIT */
/*
 * projection(cut = true): what it draws is where the solid's lower half ends, seen from above; of a
 * solid of many corners without a crossing for each two of them.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>

#include "check.h"
#include "csgcast/csgcast.h"

enum { SIZE = 64, MAX_MEGABYTES = 1000 };

#define HEIGHT 50.0 /* of the eye */

static bool draw(const char *text, float z[SIZE * SIZE])
{
    const struct csgcast_scene_params params = {.facets = CSGCAST_FACETS_AS_WRITTEN};
    const struct csgcast_renderer_params on_cpu = {.backend = CSGCAST_BACKEND_REFERENCE};
    const struct csgcast_view view = {.width = SIZE,
                                      .height = SIZE,
                                      .camera = {.kind = CSGCAST_CAMERA_VECTOR,
                                                 .projection = CSGCAST_ORTHOGRAPHIC,
                                                 .eye = {0.01, 0.02, HEIGHT},
                                                 .center = {0.01, 0.02, 0},
                                                 .fov = 9}};
    const struct csgcast_image image = {.z = z};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    struct csgcast_renderer *renderer = csgcast_renderer_create(&on_cpu);
    const bool ok = scene && renderer && csgcast_render(renderer, scene, &view, &image);
    csgcast_renderer_destroy(renderer);
    csgcast_scene_destroy(scene);
    return ok;
}

static void check_section(const char *solid)
{
    static float lower[SIZE * SIZE], section[SIZE * SIZE];
    char text[1024];
    int num = 0, num_wrong = 0;
    snprintf(text, sizeof text,
             "difference() { rotate([20, 31, 7]) %s translate([-9, -9, 0]) cube(18); }", solid);
    CHECK(draw(text, lower), "%s", text);
    snprintf(text, sizeof text,
             "linear_extrude(height = 1) projection(cut = true) rotate([20, 31, 7]) %s", solid);
    CHECK(draw(text, section), "%s", text);
    for (int i = 0; i < SIZE * SIZE; i++) {
        const bool is_cut = fabs((double)lower[i] - HEIGHT) < 1e-4;
        num += is_cut;
        num_wrong += is_cut == (isinf(section[i]) != 0);
    }
    CHECK(num > 100 && num_wrong == 0, "%s: %d of %d pixels", solid, num_wrong, num);
}

/* Six digits bend its faces apart, so that it is a surface of triangles. */
#define PART                                                                                       \
    "polyhedron(points = [[-3, -3, -1.01235], [3.12346, -3, -1.01235], [3.12346, 3.12346, "        \
    "-1.01235], [0.01235, -1.01235, -1.01235], [-3, 3.12346, -1.01235], [-3, -3, 1.12345], "       \
    "[3.12346, -3, 1.12345], [3.12346, 3.12346, 1.12345], [0.01235, -1.01235, 1.12345], "          \
    "[-3, 3.12346, 1.12345]], faces = [[0, 1, 2, 3, 4], [9, 8, 7, 6, 5], [1, 0, 5, 6], "           \
    "[2, 1, 6, 7], [3, 2, 7, 8], [4, 3, 8, 9], [0, 4, 9, 5]]);"

int main(void)
{
    struct rusage usage;
    check_section("sphere(r = 3, $fn = 8);");
    check_section("translate([0, 0, 0.7]) sphere(r = 3, $fn = 48);");
    check_section("cylinder(h = 2, r = 3, center = true, $fn = 300);");
    check_section("translate([0, 0, 0.7]) sphere(r = 3, $fn = 200);");
    check_section(PART);
    check_section("difference() { " PART " cylinder(h = 9, r = 1.5, center = true, $fn = 5); }");
    check_section("difference() { cube([5, 5, 3], center = true); mirror([1, 0, 0]) " PART " }");
    getrusage(RUSAGE_SELF, &usage);
    CHECK(usage.ru_maxrss / 1024 < MAX_MEGABYTES, "%ld MB", usage.ru_maxrss / 1024);
    return num_failed != 0;
}
