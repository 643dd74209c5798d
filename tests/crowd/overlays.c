/* SPDX-License-Identifier: MIT */

/*
 * More %, # and translucent objects than are drawn one after the other. None is in front of another
 * one: the picture of all of them is that of those with even numbers, and elsewhere that of the
 * others, each of which is few enough.
 *
 *     overlays egl|osmesa
 */

#include <csgcast/csgcast.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ideal/text.h"

enum { SIZE = 200, PIXELS = SIZE * SIZE, SIDE = 10 };

enum { EVEN = 1, ODD = 2, NONE = 0, ALL = EVEN | ODD };

/* What stands before each of them, an opaque one for every seventh, and what else there is. */
static const struct scene {
    const char *name, *prefix, *seventh, *beside;
} scenes[] = {
    {"%", "%", "%color([1, 0, 0, 1])", "sphere(r = 0.1);"},
    {"# beside a solid", "#", "#color([1, 0, 0, 1])", "sphere(r = 0.1);"},
    {"# on everything", "#", "#color([1, 0, 0, 1])", "#sphere(r = 0.1);"},
    {"translucent", "color([0, 0, 1, 0.5])", "color([0, 1, 0, 0.2])", "sphere(r = 0.1);"},
};

/* The first one has no far side of its own, as it is of several solids. */
static const char *const solids[] = {
    "difference() { cube(1.2, center = true); cylinder(h = 3, r = 0.3, center = true); }",
    "sphere(r = 0.8);",
    "cube([1.5, 1, 1.2], center = true);",
    "cylinder(h = 1.4, r1 = 0.8, r2 = 0.2, center = true);",
    "cylinder(h = 1, r = 0.7, center = true);",
};

static char *make_scene(const struct scene *scene, int which)
{
    struct text text = {0};
    for (int i = 0; i < 2; i++)
        text_put(&text, "translate([%d, %d, 0]) %s\n", i ? -2 : 2 * SIDE, i ? -2 : 2 * SIDE,
                 scene->beside);
    for (int i = 0; i < SIDE * SIDE; i++)
        if (which & (i % 2 ? ODD : EVEN))
            text_put(&text, "%s translate([%d, %d, %d]) rotate([%d, 20, 0]) %s\n",
                     i % 7 == 3 ? scene->seventh : scene->prefix, 2 * (i % SIDE), 2 * (i / SIDE),
                     i % 3, 10 * i + 7, solids[i % 5]);
    return text.data;
}

static float pictures[ALL + 1][4 * PIXELS];

static bool draw(struct csgcast_renderer *renderer, const struct scene *scene, int which)
{
    char *text = make_scene(scene, which);
    struct csgcast_scene *parsed = csgcast_scene_parse(text, strlen(text), NULL);
    const struct csgcast_view view = {.width = SIZE,
                                      .height = SIZE,
                                      .camera = {.kind = CSGCAST_CAMERA_GIMBAL,
                                                 .projection = CSGCAST_ORTHOGRAPHIC,
                                                 .translate = {SIDE - 1, SIDE - 1, 0},
                                                 .distance = 60}};
    const struct csgcast_image image = {.rgba = pictures[which]};
    const bool ok = parsed && csgcast_render(renderer, parsed, &view, &image);
    csgcast_scene_destroy(parsed);
    free(text);
    return ok;
}

/* Pictures of other scenes have other roundings. */
#define MAX_COLOR_ERROR 1e-3f

static bool are_equal(const float *a, const float *b)
{
    float error = 0;
    for (int i = 0; i < 4; i++)
        error = fmaxf(error, fabsf(a[i] - b[i]));
    return error <= MAX_COLOR_ERROR;
}

static bool check(struct csgcast_renderer *renderer, const struct scene *scene)
{
    int wrong = 0, covered = 0;
    for (int which = NONE; which <= ALL; which++)
        if (!draw(renderer, scene, which))
            return false;
    for (int i = 0; i < 4 * PIXELS; i += 4) {
        const bool even = !are_equal(pictures[EVEN] + i, pictures[NONE] + i);
        const bool odd = !are_equal(pictures[ODD] + i, pictures[NONE] + i);
        covered += even || odd;
        wrong += (even && odd) || !are_equal(pictures[ALL] + i, pictures[even ? EVEN : ODD] + i);
    }
    printf("%s: %d of %d pixels wrong\n", scene->name, wrong, covered);
    return wrong == 0 && covered > PIXELS / 10;
}

int main(int argc, char **argv)
{
    if (argc != 2)
        return 2;
    const struct csgcast_renderer_params params = {
        .backend = strcmp(argv[1], "egl") == 0 ? CSGCAST_BACKEND_EGL : CSGCAST_BACKEND_OSMESA};
    struct csgcast_renderer *renderer = csgcast_renderer_create(&params);
    bool ok = renderer != NULL;
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes && renderer; i++)
        ok &= check(renderer, &scenes[i]);
    csgcast_renderer_destroy(renderer);
    puts(ok ? "ok" : "FAILED");
    return !ok;
}
