/* SPDX-License-Identifier: MIT */
#include "crowds.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "ideal/judge.h"
#include "ideal/text.h"

enum { SIZE = 8 };

/* The eye looks along +x from x = 0, up is z; all rays meet the first face of what is left. */
struct crowd {
    const char *name;
    void (*put)(struct text *text, int num);
    int num, num_full;
    double (*depth)(int num); /* of every pixel; infinity: nothing is left */
};

static void put_box(struct text *text, double x, double length)
{
    text_put(text,
             "multmatrix([[1, 0, 0, %.17g], [0, 1, 0, -5], [0, 0, 1, -5], [0, 0, 0, 1]]) "
             "cube(size = [%.17g, 10, 10]);\n",
             x, length);
}

/* Slabs behind each other, the nearest last. */
static void put_row(struct text *text, int num)
{
    text_put(text, "union() {\n");
    for (int i = num; i-- > 0;)
        put_box(text, 10 + i, 0.5);
    text_put(text, "}\n");
}

static double first_slab(int num)
{
    (void)num;
    return 10;
}

/* Two combs that have only their last teeth in common. */
static void put_combs(struct text *text, int num)
{
    text_put(text, "intersection() {\nunion() {\n");
    for (int i = 0; i < num; i++)
        put_box(text, 10 + i, 0.375);
    text_put(text, "}\nunion() {\n");
    for (int i = 0; i < num; i++)
        put_box(text, 10 + i + (i + 1 < num ? 0.5 : 0.25), 0.375);
    text_put(text, "}\n}\n");
}

static double last_tooth(int num)
{
    return 10 + num - 1 + 0.25;
}

/* A bar cut away by overlapping slabs, all but its far end. */
static void put_chain(struct text *text, int num)
{
    text_put(text, "difference() {\n");
    put_box(text, 10, num + 5);
    for (int i = 0; i < num; i++)
        put_box(text, 10 + i, 1.25);
    text_put(text, "}\n");
}

static double end_of_chain(int num)
{
    return 10 + num - 1 + 1.25;
}

/* a - (b - (c - ...)), each inside the one before: a tree as deep as it has leaves. */
static void put_nest(struct text *text, int num)
{
    for (int i = 0; i < num; i++) {
        text_put(text, i + 1 < num ? "difference() {\n" : "");
        put_box(text, 10 + (i < 2 ? 0 : i), 3.0 * num - i);
    }
    for (int i = 0; i + 1 < num; i++)
        text_put(text, "}\n");
}

/* The second takes away the first's front; the third gives back what it covers. */
static double third_of_nest(int num)
{
    (void)num;
    return 12;
}

static const struct crowd crowds[] = {
    {"solids on a ray, union", put_row, 10000, 10000, first_slab},
    {"solids on a ray, combs", put_combs, 40, 5000, last_tooth},
    {"solids on a ray, chain", put_chain, 80, 10000, end_of_chain},
    {"depth of the tree", put_nest, 1000, 1000, third_of_nest},
};

static bool check(struct csgcast_renderer *renderer, const struct crowd *crowd, int num, bool csv)
{
    struct text text = {0};
    crowd->put(&text, num);
    const struct csgcast_scene_params params = {.name = crowd->name};
    struct csgcast_scene *scene = csgcast_scene_parse(text.data, text.num, &params);
    const struct csgcast_view view = {.width = SIZE,
                                      .height = SIZE,
                                      .camera = {.kind = CSGCAST_CAMERA_VECTOR,
                                                 .center = {1, 0, 0},
                                                 .projection = CSGCAST_ORTHOGRAPHIC,
                                                 .fov = 90}};
    struct picture picture = picture_create(SIZE, SIZE);
    const bool drawn = scene && picture_render(renderer, scene, &view, &picture);
    double largest = 0;
    int wrong = 0;
    for (int i = 0; drawn && i < SIZE * SIZE; i++) {
        const double error = fabs((double)picture.z[i] / crowd->depth(num) - 1);
        wrong += !(error < 1e-6);
        largest = fmax(largest, error);
    }
    const bool ok = drawn && wrong == 0;
    printf(csv ? "%s,%d,shader,%d,%d,,,,,,%.3g,,,%s\n"
               : "| %s | %d | shader | %d | %d | | | | | | %.2g | | | %s |\n",
           crowd->name, num, SIZE * SIZE, wrong, largest, ok ? "ok" : "FAIL");
    fflush(stdout);
    csgcast_scene_destroy(scene);
    picture_free(&picture);
    text_free(&text);
    return ok;
}

bool crowds_check(struct csgcast_renderer *renderer, bool full, bool csv)
{
    bool ok = true;
    for (size_t i = 0; i < sizeof crowds / sizeof *crowds; i++)
        ok &= check(renderer, &crowds[i], full ? crowds[i].num_full : crowds[i].num, csv);
    return ok;
}
