/* SPDX-License-Identifier: MIT */
/*
 * A ray that leaves out subtrees by their boxes meets the same leaf at the same place as one that
 * asks all: random trees with unbounded solids and complements, from outside and inside.
 */
#define DICE_SEED 11

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "csg/scene.h"
#include "dice.h"
#include "reference/bounds.h"
#include "reference/reference.h"

enum { NUM_SCENES = 60, NUM_RAYS = 1500, ROOM = 1 << 19 };

struct text {
    char data[ROOM];
    size_t num;
};

static void put(struct text *text, const char *what)
{
    text->num += (size_t)snprintf(text->data + text->num, ROOM - text->num, "%s", what);
}

static void put_solid(struct text *text)
{
    static const char *const solids[] = {"sphere(2.5);", "cube([3, 4, 2]);",
                                         "cylinder(h = 5, r1 = 2, r2 = 1);",
                                         "sphere(r = 3, $fn = 7);"};
    char line[200];
    const double a = random_between(0, 6.28), c = cos(a), s = sin(a);
    snprintf(line, sizeof line, "multmatrix([[%g,%g,0,%g],[%g,%g,0,%g],[0,0,1,%g],[0,0,0,1]])", c,
             -s, random_between(-9, 9), s, c, random_between(-9, 9), random_between(-9, 9));
    put(text, line);
    put(text, random_between(0, 1) < 0.05 ? "halfspace(normal = [0.3, 0.5, 1], offset = 4);"
                                          : solids[(int)random_between(0, 4)]);
}

/* A few levels deep. */
static void put_tree(struct text *text, int depth)
{
    static const char *const ops[] = {"union() {", "difference() {", "intersection() {",
                                      "difference() {", "union() {"};
    if (depth == 0) {
        put_solid(text);
        return;
    }
    put(text, ops[(int)random_between(0, 5)]);
    const bool is_wide = depth == 1 && random_between(0, 1) < 0.1;
    for (int i = (int)(is_wide ? random_between(40, 90) : random_between(2, 5)); i > 0; i--)
        put_tree(text, random_between(0, 1) < 0.3 ? 0 : depth - 1);
    put(text, "}\n");
}

static struct csg_ray random_ray(void)
{
    const double far = random_between(0, 1) < 0.3 ? 6 : 40;
    const struct csg_vec3 org =
        csg_vec3(random_between(-far, far), random_between(-far, far), random_between(-far, far));
    const struct csg_vec3 to =
        csg_vec3(random_between(-8, 8), random_between(-8, 8), random_between(-8, 8));
    struct csg_vec3 dir = csg_sub(to, org);
    if (random_between(0, 1) < 0.1)
        dir = csg_vec3(0, 0, -1);
    return (struct csg_ray){org, dir, 0};
}

static size_t compare(const struct csgcast_scene *scene, int number)
{
    struct csg_tree_bounds bounds;
    CHECK(csg_tree_bounds_init(&bounds, scene), "scene %d: memory", number);
    struct csg_ray_scratch *all = csg_ray_scratch_create(NULL);
    struct csg_ray_scratch *some = csg_ray_scratch_create(&bounds);
    bool failed = !all || !some;
    size_t num_hits = 0;
    for (int i = 0; i < NUM_RAYS && !failed; i++) {
        const struct csg_ray ray = random_ray();
        struct csg_hit a = {0}, b = {0};
        const bool in_all = csg_reference_trace(scene, CSG_LAYER_MODEL, &ray, all, &a, &failed);
        const bool in_some = csg_reference_trace(scene, CSG_LAYER_MODEL, &ray, some, &b, &failed);
        num_hits += in_all;
        CHECK(in_all == in_some && a.t == b.t && a.leaf == b.leaf && a.cut == b.cut,
              "scene %d, ray %d: %d at %.17g on %u, not %d at %.17g on %u", number, i, in_some, b.t,
              b.leaf, in_all, a.t, a.leaf);
    }
    CHECK(!failed, "scene %d: memory", number);
    csg_ray_scratch_destroy(all);
    csg_ray_scratch_destroy(some);
    csg_tree_bounds_finish(&bounds);
    return num_hits;
}

int main(void)
{
    static struct text text;
    size_t num_hits = 0;
    for (int i = 0; i < NUM_SCENES; i++) {
        text.num = 0;
        put_tree(&text, 4);
        struct csgcast_scene *scene = csgcast_scene_parse(text.data, text.num, NULL);
        CHECK(scene, "scene %d", i);
        if (scene)
            num_hits += compare(scene, i);
        csgcast_scene_destroy(scene);
    }
    CHECK(num_hits > NUM_SCENES * NUM_RAYS / 10, "the test tests little: %zu hits", num_hits);
    return num_failed > 0;
}
