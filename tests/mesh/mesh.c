/* SPDX-License-Identifier: MIT */

/*
 * Surfaces of triangles. Solids made of cubes must look the same when they are written as one
 * polyhedron of many faces, in Booleans with flush faces and with rays exactly through edges and
 * corners; tubes that cross themselves, and slivers seen nearly along their planes, must look as
 * the reference has them.
 *
 *     mesh [--backend=egl|osmesa|reference] [--rounds=N] [--size=PIXELS] [--seed=S]
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bodies.h"
#include "ideal/judge.h"
#include "ideal/options.h"

#define MAX_DEPTH_ERROR 6e-6 /* relative */
#define MAX_NORMAL_ERROR 0.1 /* degrees */
#define MAX_EDGE_SHARE 4e-3  /* pixels that may differ within a pixel of an edge */

/* More faces than polyhedra are cut into convex solids for. */
enum { CUTS = 8, TUBE_N = 60, TUBE_M = 40, FAN_N = 3000 };

/* P, Q: solids made of cubes; T, U: tubes. */
static const char *const formulas[] = {
    "P",
    "difference() { P cylinder(h = 2, r = 1.25); }",
    "difference() { cube(size = [3, 3, 3]); P }",
    "difference() { P Q }",
    "intersection() { P Q sphere(r = 2.5); }",
    ("difference() { cube(size = [8, 8, 8], center = true); union() { P "
     "multmatrix([[1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]]) Q } }"),
    "T",
    "difference() { T U sphere(r = 2); }",
    "difference() { sphere(r = 3); T }",
    "union() { intersection() { T U } P }",
};
enum { NUM_FORMULAS = sizeof formulas / sizeof *formulas };

struct run {
    struct csgcast_renderer *renderer, *reference;
    struct picture expected, got;
    int size, failed;
};

struct operands {
    struct text cubes[2], mesh[2]; /* of P and Q */
    struct text tubes[2];
};

static struct operands make_operands(struct dice *dice)
{
    struct operands operands = {0};
    for (int i = 0; i < 2; i++) {
        const struct voxels voxels = voxels_random(dice);
        voxels_put_cubes(&operands.cubes[i], &voxels);
        voxels_put_polyhedron(&operands.mesh[i], &voxels, CUTS);
        tube_put(&operands.tubes[i], TUBE_N, TUBE_M, dice);
    }
    return operands;
}

static void free_operands(struct operands *operands)
{
    for (int i = 0; i < 2; i++) {
        text_free(&operands->cubes[i]);
        text_free(&operands->mesh[i]);
        text_free(&operands->tubes[i]);
    }
}

static struct csgcast_scene *make_scene(const char *formula, const struct operands *operands,
                                        bool cubes, const char *name)
{
    struct text text = {0};
    for (const char *c = formula; *c; c++) {
        const bool alone = (c == formula || c[-1] == ' ') && (c[1] == ' ' || !c[1]);
        if (alone && (*c == 'P' || *c == 'Q'))
            text_put(&text, "%s", (cubes ? operands->cubes : operands->mesh)[*c - 'P'].data);
        else if (alone && (*c == 'T' || *c == 'U'))
            text_put(&text, "%s", operands->tubes[*c - 'T'].data);
        else
            text_put(&text, "%c", *c);
    }
    const struct csgcast_scene_params params = {.name = name};
    struct csgcast_scene *scene = csgcast_scene_parse(text.data, text.num, &params);
    if (!cubes) {
        char path[100];
        FILE *file;
        snprintf(path, sizeof path, "%s.csg", name);
        file = getenv("MESH_KEEP") ? fopen(path, "w") : NULL;
        if (file) {
            fputs(text.data, file);
            fclose(file);
        }
    }
    text_free(&text);
    return scene;
}

/* ---- views -------------------------------------------------------------------------------- */

/* Pixels are half as wide as the polyhedra's squares, and centres are on their corners. */
static struct csgcast_view aligned_view(struct dice *dice, int size)
{
    struct csgcast_view view = {.width = size, .height = size};
    const double pixel = 0.5 / CUTS;
    view.camera = (struct csgcast_camera){
        .kind = CSGCAST_CAMERA_GIMBAL, .projection = CSGCAST_ORTHOGRAPHIC, .distance = 16};
    view.camera.fov = 2 * atan(0.5 * size * pixel / view.camera.distance) * 180 / 3.14159265358979;
    for (int i = 0; i < 3; i++) {
        view.camera.rotate[i] = 90 * dice_pick(dice, 4);
        view.camera.translate[i] = 1.5 + 0.5 * pixel;
    }
    return view;
}

static struct csgcast_view random_view(struct dice *dice, int size)
{
    struct csgcast_view view = {.width = size, .height = size};
    view.camera.kind = CSGCAST_CAMERA_GIMBAL;
    for (int i = 0; i < 3; i++) {
        view.camera.rotate[i] = dice_between(dice, 0, 360);
        view.camera.translate[i] = dice_between(dice, 0, 2);
    }
    view.camera.distance = dice_between(dice, 10, 200);
    view.camera.fov = 2 * atan(4 / view.camera.distance) * 180 / 3.14159265358979;
    view.camera.projection = dice_pick(dice, 2) ? CSGCAST_ORTHOGRAPHIC : CSGCAST_PERSPECTIVE;
    return view;
}

/* From somewhere among the solids. */
static struct csgcast_view inner_view(struct dice *dice, int size)
{
    struct csgcast_view view = random_view(dice, size);
    view.camera.distance = dice_between(dice, 0.5, 3);
    view.camera.fov = 80;
    view.camera.projection = CSGCAST_PERSPECTIVE;
    return view;
}

/* ---- judging ------------------------------------------------------------------------------ */

static bool differs(const struct picture *a, const struct picture *b, int i)
{
    if (isnan(b->z[i]) || (a->id[i] < 0) != (b->id[i] < 0))
        return true;
    return a->id[i] >= 0 &&
           (!(fabs((double)b->z[i] / (double)a->z[i] - 1) <= MAX_DEPTH_ERROR) ||
            !(picture_angle(a->normal + 3 * i, b->normal + 3 * i) <= MAX_NORMAL_ERROR));
}

/* In the aligned view, pixels in the plane of the cubes' sides: which side they see is nobody's
 * concern. Centres are at 1.5 + n / 16, n or n - 1 counting from the picture's middle. */
static bool is_on_side(int x, int y, int size)
{
    const int i = (x + 8 * size - size / 2) % 16, j = (y + 8 * size - size / 2) % 16;
    return i == 7 || i == 8 || j == 7 || j == 8;
}

static void judge(struct run *run, const char *name, const char *view, bool aligned)
{
    const struct picture *a = &run->expected, *b = &run->got;
    const int num = a->width * a->height;
    int wrong = 0, edge = 0, where = 0;
    for (int i = 0; i < num; i++) {
        if (!differs(a, b, i) || (aligned && is_on_side(i % a->width, i / a->width, a->width)))
            continue;
        if (picture_is_edge(a, i % a->width, i / a->width, 10))
            edge++;
        else if (!wrong++)
            where = i;
    }
    if (wrong == 0 && edge <= MAX_EDGE_SHARE * num + 2)
        return;
    run->failed++;
    printf("FAIL %s, %s view: %d pixels wrong, first %d,%d: leaf %g and %g, depth %.9g and %.9g, "
           "normal off by %.3g degrees; %d at edges\n",
           name, view, wrong, where % a->width, where / a->width, (double)a->id[where],
           (double)b->id[where], (double)a->z[where], (double)b->z[where],
           picture_angle(a->normal + 3 * where, b->normal + 3 * where), edge);
}

static void check(struct run *run, const char *formula, const struct operands *operands,
                  struct dice *dice, const char *name)
{
    const bool is_made_of_cubes = strchr(formula, 'T') == NULL;
    struct csgcast_scene *expected = make_scene(formula, operands, is_made_of_cubes, name);
    struct csgcast_scene *scene = make_scene(formula, operands, false, name);
    const struct csgcast_view views[3] = {
        aligned_view(dice, run->size), random_view(dice, run->size), inner_view(dice, run->size)};
    static const char *const names[3] = {"aligned", "random", "inner"};
    for (int i = 0; i < 3; i++) {
        if (!expected || !scene ||
            !picture_render(run->reference, expected, &views[i], &run->expected) ||
            !picture_render(run->renderer, scene, &views[i], &run->got)) {
            printf("FAIL %s: not drawn\n", name);
            run->failed++;
            continue;
        }
        judge(run, name, names[i], i == 0);
    }
    csgcast_scene_destroy(expected);
    csgcast_scene_destroy(scene);
}

/* Slivers far thinner than a pixel, seen nearly along their planes: the depth is still that of the
 * plane. */
static void check_fan(struct run *run)
{
    struct text text = {0};
    fan_put(&text, FAN_N);
    const struct csgcast_scene_params params = {.name = "fan"};
    struct csgcast_scene *scene = csgcast_scene_parse(text.data, text.num, &params);
    text_free(&text);
    for (int i = 0; i < 8; i++) {
        struct csgcast_view view = {.width = run->size, .height = run->size};
        view.camera = (struct csgcast_camera){.kind = CSGCAST_CAMERA_GIMBAL,
                                              .translate = {25, 12, 5},
                                              .rotate = {i < 4 ? 89.5 : 90.4, 0, 40 + 25 * i},
                                              .distance = 200,
                                              .fov = 12};
        view.camera.projection = i % 2 ? CSGCAST_ORTHOGRAPHIC : CSGCAST_PERSPECTIVE;
        if (scene && picture_render(run->reference, scene, &view, &run->expected) &&
            picture_render(run->renderer, scene, &view, &run->got))
            judge(run, "fan", i % 2 ? "orthographic" : "perspective", false);
        else
            run->failed++;
    }
    csgcast_scene_destroy(scene);
}

static struct csgcast_renderer *make_renderer(enum csgcast_backend backend)
{
    const struct csgcast_renderer_params params = {.backend = backend};
    return csgcast_renderer_create(&params);
}

int main(int argc, char **argv)
{
    struct run run = {.size = 64};
    enum csgcast_backend backend = CSGCAST_BACKEND_EGL;
    unsigned long long seed = 1;
    int rounds = 2;
    for (int i = 1; i < argc; i++)
        if (!option_int(argv[i], "--rounds=", &rounds) &&
            !option_int(argv[i], "--size=", &run.size) && !option_seed(argv[i], &seed) &&
            !option_backend(argv[i], &backend))
            return fprintf(stderr, "mesh: cannot use %s\n", argv[i]), 2;
    run.renderer = make_renderer(backend);
    run.reference = make_renderer(CSGCAST_BACKEND_REFERENCE);
    if (!run.renderer || !run.reference)
        return 1;
    run.expected = picture_create(run.size, run.size);
    run.got = picture_create(run.size, run.size);
    struct dice dice = {seed};
    for (int round = 0; round < rounds; round++) {
        struct operands operands = make_operands(&dice);
        for (int i = 0; i < NUM_FORMULAS; i++) {
            char name[60];
            snprintf(name, sizeof name, "mesh-%llu-%d-%d", seed, round, i);
            check(&run, formulas[i], &operands, &dice, name);
        }
        free_operands(&operands);
    }
    check_fan(&run);
    printf("%s: %d rounds, %d pictures failed\n", run.failed ? "FAIL" : "ok", rounds, run.failed);
    picture_free(&run.expected);
    picture_free(&run.got);
    csgcast_renderer_destroy(run.renderer);
    csgcast_renderer_destroy(run.reference);
    return run.failed > 0;
}
