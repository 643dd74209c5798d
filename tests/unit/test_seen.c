/* SPDX-License-Identifier: MIT */
/*
 * Large objects seen from near, of which the picture shows little: what it shows is what the
 * reference finds, and what is handed over is little, too.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "csgcast/csgcast.h"
#include "dice.h"

enum { SIZE = 64, NUM_SOLIDS = 900, TEXT_SIZE = 200 * NUM_SOLIDS };

#define MAX_DEPTH_ERROR 1e-4 /* relative */
#define MAX_EDGE_SHARE 0.004 /* of the pixels, where a ray passes an edge */

/* Of what is handed over for all of the scene, a view that shows a small part takes less. */
#define CLOSE_SHARE 0.3

struct scene_text {
    char text[TEXT_SIZE];
    size_t num;
};

static void put_solid(struct scene_text *to)
{
    static const char *const kinds[3] = {"sphere(%.9g);\n", "rotate([31,52,7]) cube(%.9g);\n",
                                         "rotate([20,70,0]) cylinder(h = 3, r = %.9g);\n"};
    double at[3];
    for (int i = 0; i < 3; i++)
        at[i] = random_between(0, 60);
    to->num += (size_t)snprintf(to->text + to->num, TEXT_SIZE - to->num,
                                "translate([%.9g,%.9g,%.9g]) ", at[0], at[1], at[2]);
    to->num += (size_t)snprintf(to->text + to->num, TEXT_SIZE - to->num,
                                kinds[at[0] < 20   ? 0
                                      : at[1] < 30 ? 1
                                                   : 2],
                                random_between(1, 3));
}

static void put(struct scene_text *to, const char *text)
{
    to->num += (size_t)snprintf(to->text + to->num, TEXT_SIZE - to->num, "%s", text);
}

/* A cube less solids all over it. */
static void put_holes(struct scene_text *to)
{
    put(to, "difference() { cube(60);\n");
    for (int i = 0; i < NUM_SOLIDS; i++)
        put_solid(to);
    put(to, "}");
}

/* A cube less pairs of which one is cut from the other, or both are united. */
static void put_nested(struct scene_text *to)
{
    put(to, "difference() { cube(60);\n");
    for (int i = 0; i < NUM_SOLIDS / 2; i++) {
        put(to, i % 3 ? "difference() {" : "union() {");
        put_solid(to);
        put_solid(to);
        put(to, "}");
    }
    put(to, "}");
}

/* Each is an object, and one of them is around the eye: they are drawn as one. */
static void put_union(struct scene_text *to)
{
    put(to, "translate([-4,-4,-4]) difference() { cube(40); translate([5,5,5]) cube(3); }\n");
    for (int i = 0; i < NUM_SOLIDS; i++)
        put_solid(to);
}

/* The first NUM_CLOSE show a small part. */
enum { NUM_CLOSE = 3 };

static const struct csgcast_camera cameras[] = {
    {.kind = CSGCAST_CAMERA_VECTOR, .eye = {80, 20, 30}, .center = {60, 20, 30}, .fov = 20},
    {.kind = CSGCAST_CAMERA_VECTOR, .eye = {31, 29, 33}, .center = {60, 31, 22}, .fov = 25},
    {.kind = CSGCAST_CAMERA_VECTOR,
     .eye = {100, 50, 40},
     .center = {10, 10, 5},
     .projection = CSGCAST_ORTHOGRAPHIC,
     .fov = 6},
    {.kind = CSGCAST_CAMERA_VECTOR, .eye = {63, 63, 63}, .center = {60, 60, 58}, .fov = 40},
    {.kind = CSGCAST_CAMERA_VECTOR, .eye = {2.5, 2.5, 2.5}, .center = {3, 4, 5}, .fov = 30},
};

struct picture {
    float z[SIZE * SIZE], id[SIZE * SIZE];
};

static bool draw(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                 const struct csgcast_camera *camera, struct picture *picture)
{
    const struct csgcast_view view = {.width = SIZE, .height = SIZE, .camera = *camera};
    return csgcast_render(renderer, scene, &view,
                          &(struct csgcast_image){.z = picture->z, .id = picture->id});
}

static size_t count_wrong(const struct picture *a, const struct picture *b)
{
    size_t wrong = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        wrong += a->z[i] != b->z[i] && !(fabsf(a->z[i] - b->z[i]) <= MAX_DEPTH_ERROR * a->z[i]);
    return wrong;
}

static size_t uploaded(struct csgcast_renderer *renderer)
{
    struct csgcast_stats stats;
    csgcast_renderer_get_stats(renderer, &stats);
    return stats.texture_bytes;
}

typedef void put_fn(struct scene_text *to);

static void check(struct csgcast_renderer *renderers[2], const char *name, put_fn *put_scene)
{
    static struct scene_text text;
    static struct picture pictures[2];
    text.num = 0;
    put_scene(&text);
    struct csgcast_scene *scene = csgcast_scene_parse(text.text, text.num, NULL);
    const struct csgcast_camera all = {.viewall = true, .autocenter = true};
    CHECK(scene && draw(renderers[1], scene, &all, &pictures[1]), "%s", name);
    const size_t whole = uploaded(renderers[1]);
    for (size_t i = 0; scene && i < sizeof cameras / sizeof *cameras; i++) {
        bool ok = true;
        for (int j = 0; j < 2; j++)
            ok &= draw(renderers[j], scene, &cameras[i], &pictures[j]);
        const size_t wrong = count_wrong(&pictures[0], &pictures[1]);
        const size_t close = uploaded(renderers[1]);
        CHECK(ok && (double)wrong <= MAX_EDGE_SHARE * SIZE * SIZE, "%s %zu: %zu pixels", name, i,
              wrong);
        CHECK(i >= NUM_CLOSE || (double)close < CLOSE_SHARE * (double)whole,
              "%s %zu: %zu of %zu bytes", name, i, close, whole);
    }
    csgcast_scene_destroy(scene);
}

int main(void)
{
    struct csgcast_renderer *renderers[2];
    for (int i = 0; i < 2; i++)
        renderers[i] = csgcast_renderer_create(&(struct csgcast_renderer_params){
            .backend = i ? CSGCAST_BACKEND_AUTO : CSGCAST_BACKEND_REFERENCE});
    CHECK(renderers[0] && renderers[1], "nothing to draw with");
    check(renderers, "holes", put_holes);
    check(renderers, "nested", put_nested);
    check(renderers, "union", put_union);
    for (int i = 0; i < 2; i++)
        csgcast_renderer_destroy(renderers[i]);
    return num_failed != 0;
}
