/* SPDX-License-Identifier: MIT */
/*
 * Drawings with OpenSCAD's vertices: as written, coordinates are cut off to multiples of 2^-16
 * where OpenSCAD does it, Booleans have the area that they must have, and outlines have the inside
 * to their left; in the other modes nothing is rounded.
 */
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "clip/module.h"
#include "csg/scene.h"

struct result {
    double area; /* twice */
    double x[64], y[64];
    size_t begin, num, num_contours;
};

static bool begin_contour(void *user)
{
    struct result *result = user;
    result->begin = result->num;
    result->num_contours++;
    return true;
}

/* The area as a fan from the contour's first point. */
static bool add_point(void *user, double x, double y)
{
    struct result *result = user;
    const size_t at = result->num, first = result->begin;
    if (at == 64)
        return false;
    result->x[at] = x;
    result->y[at] = y;
    result->num++;
    if (at >= first + 2)
        result->area += (result->x[at - 1] - result->x[first]) * (y - result->y[first]) -
                        (result->y[at - 1] - result->y[first]) * (x - result->x[first]);
    return true;
}

static const double large[] = {0, 0, 4, 0, 4, 4, 0, 4};
static const double small[] = {1, 1, 1, 2, 2, 2, 2, 1}; /* clockwise */
static const double aside[] = {3, 3, 6, 3, 6, 6, 3, 6};
static const double off_grid[] = {0.1, 0.1, 0.9, 0.1, -0.1, 0.9};
static const double far_off[] = {0, 0, 1e14, 0, 0, 1};

static void check(const struct csg_clip_module *module, enum csg_clip_op op,
                  const double *const points[2], double area, size_t num_contours)
{
    struct result result = {0};
    const struct csg_clip_sink sink = {&result, begin_contour, add_point};
    const struct csg_clip_path paths[2] = {{points[0], 4, 0, 0, false},
                                           {points[1], 4, 1, 1, false}};
    CHECK(module->combine(op, 2, paths, 2, &sink) == CSG_CLIP_DONE, "op %d", (int)op);
    CHECK(result.area == 2 * area && result.num_contours == num_contours,
          "op %d: area %g, %zu contours", (int)op, result.area / 2, result.num_contours);
}

static void check_grid(const struct csg_clip_module *module)
{
    struct result result = {0};
    const struct csg_clip_sink sink = {&result, begin_contour, add_point};
    const struct csg_clip_path paths[2] = {{off_grid, 3, 0, 0, false}, {far_off, 3, 0, 0, false}};
    CHECK(module->combine(CSG_CLIP_UNION, 1, paths, 1, &sink) == CSG_CLIP_DONE, "a triangle");
    for (size_t i = 0; i < result.num; i++)
        CHECK(result.x[i] == -6553 / 65536.0 || result.x[i] == 6553 / 65536.0 ||
                  result.x[i] == 58982 / 65536.0,
              "%.9g is not cut off", result.x[i]);
    CHECK(module->combine(CSG_CLIP_UNION, 1, &paths[1], 1, &sink) == CSG_CLIP_TOO_LARGE, "1e14");
}

static void check_mode(enum csgcast_facets facets, double x)
{
    static const char text[] = "linear_extrude(height = 1) polygon([[0, 0], [0.1, 0], [0, 1]]);";
    const struct csgcast_scene_params params = {.facets = facets};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    CHECK(scene && scene->num_leaves == 1, "one prism");
    if (scene)
        CHECK(fabs(scene->leaves[0].shape.bounds.hi.x - x) < 1e-12, "ends at %.9g",
              scene->leaves[0].shape.bounds.hi.x);
    csgcast_scene_destroy(scene);
}

int main(void)
{
    const char *path = getenv("CSGCAST_CLIP_MODULE");
    void *handle = path ? dlopen(path, RTLD_NOW) : NULL;
    const struct csg_clip_module *module =
        handle ? (const struct csg_clip_module *)dlsym(handle, CSG_CLIP_MODULE_NAME) : NULL;
    CHECK(module, "csgcast-clip.so does not load (Debian: libpolyclipping-dev)");
    if (!module)
        return 1;
    check(module, CSG_CLIP_UNION, (const double *const[]){large, aside}, 24, 1);
    check(module, CSG_CLIP_DIFFERENCE, (const double *const[]){large, small}, 15, 2);
    check(module, CSG_CLIP_INTERSECTION, (const double *const[]){aside, large}, 1, 1);
    check(module, CSG_CLIP_INTERSECTION, (const double *const[]){aside, small}, 0, 0);
    check_grid(module);
    check_mode(CSGCAST_FACETS_AS_WRITTEN, 6553 / 65536.0);
    check_mode(CSGCAST_FACETS_AUTO, 0.1);
    return num_failed > 0;
}
