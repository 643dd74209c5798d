/* SPDX-License-Identifier: MIT */

/*
 * Two ways to say the same: pairs of scenes and cameras that must give the same picture. Operands
 * are seeded random trees, half of them on a grid, where faces coincide.
 *
 *     metamorphic [--backend=egl|osmesa|reference] [--rounds=N] [--size=PIXELS] [--seed=S]
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ideal/options.h"
#include "metamorphic.h"
#include "twin/random_scene.h"

/* Where the pair is drawn by different keys, or turned: float's noise. */
#define MAX_DEPTH_ERROR 6e-6 /* relative */
#define MAX_NORMAL_ERROR 0.1 /* degrees */
#define MAX_EDGE_SHARE 2e-3  /* pixels that may differ within a pixel of an edge */

/* Longer than any operand. */
#define ALL "cube(size = 200, center = true);"

struct pair {
    const char *name;
    const char *first, *second; /* A B C: the operands; H: a solid around them all */
    bool exact;                 /* the same numbers are computed: the same depths to the bit */
};

static const struct pair pairs[] = {
    {"difference as intersection", "difference() { A B }",
     "intersection() { A difference() { H B } }", false},
    {"De Morgan, union", "difference() { H union() { A B } }",
     "intersection() { difference() { H A } difference() { H B } }", true},
    {"De Morgan, intersection", "difference() { H intersection() { A B } }",
     "union() { difference() { H A } difference() { H B } }", true},
    {"permuted union", "union() { A B C }", "union() { C A B }", true},
    {"permuted intersection", "intersection() { union() { A B } C }",
     "intersection() { C union() { B A } }", true},
    {"permuted cutters", "difference() { A B C }", "difference() { A C B }", true},
    {"nested difference", "difference() { A B C }", "difference() { difference() { A B } C }",
     true},
    {"cutters united", "difference() { A B C }", "difference() { A union() { B C } }", true},
    {"nested union", "union() { A union() { B C } }", "group() { group() { A B } group() { C } }",
     true},
    {"distributed", "intersection() { A union() { B C } }",
     "union() { intersection() { A B } intersection() { A C } }", true},
    {"twice", "union() { A B }", "union() { A B A intersection() { A B } }", true},
    {"absorbed", "union() { A B }", "difference() { H difference() { difference() { H A } B } }",
     false},
};
enum { NUM_PAIRS = sizeof pairs / sizeof *pairs };

void put_formula(struct text *text, const char *formula, const struct operands *operands)
{
    for (const char *c = formula; *c; c++) {
        const bool alone = c > formula && c[-1] == ' ' && c[1] == ' ';
        if (alone && *c == 'H')
            text_put(text, "%s", ALL);
        else if (alone && *c >= 'A' && *c <= 'C')
            text_put(text, "union() {\n%s}\n", operands->texts[*c - 'A']);
        else
            text_put(text, "%c", *c);
    }
}

struct csgcast_scene *parse(const struct text *text, const char *name)
{
    const struct csgcast_scene_params params = {.name = name};
    return csgcast_scene_parse(text->data, text->num, &params);
}

static bool differs(const struct picture *a, const struct picture *b, int i, bool exact)
{
    if ((a->id[i] < 0) != (b->id[i] < 0))
        return true;
    if (a->id[i] < 0)
        return false;
    if (exact && a->z[i] == b->z[i])
        return false;
    return exact || !(fabs((double)b->z[i] / (double)a->z[i] - 1) <= MAX_DEPTH_ERROR) ||
           !(picture_angle(a->normal + 3 * i, b->normal + 3 * i) <= MAX_NORMAL_ERROR);
}

bool judge(struct run *run, const char *name, int size, bool exact)
{
    struct picture *a = &run->first, *b = &run->second;
    a->width = a->height = b->width = b->height = size;
    int wrong = 0, edge = 0, where = 0;
    for (int i = 0; i < size * size; i++) {
        if (!differs(&run->first, &run->second, i, exact))
            continue;
        if (picture_is_edge(&run->first, i % size, i / size, 15) ||
            picture_is_edge(&run->second, i % size, i / size, 15))
            edge++;
        else if (!wrong++)
            where = i;
    }
    const bool ok = wrong == 0 && edge <= MAX_EDGE_SHARE * size * size + 2;
    run->num++;
    run->failed += !ok;
    if (!ok)
        printf("FAIL %s: %d pixels differ, first %d,%d: depth %.9g and %.9g; %d at edges\n", name,
               wrong, where % size, where / size, (double)run->first.z[where],
               (double)run->second.z[where], edge);
    return ok;
}

void save(const char *name, const char *which, const struct text *text)
{
    char path[160];
    snprintf(path, sizeof path, "%s-%s.csg", name, which);
    FILE *file = fopen(path, "w");
    if (file) {
        fputs(text->data, file);
        fclose(file);
    }
}

struct csgcast_view random_view(struct dice *dice, int size)
{
    struct csgcast_view view = {.width = size, .height = size};
    view.camera.kind = CSGCAST_CAMERA_GIMBAL;
    for (int i = 0; i < 3; i++)
        view.camera.rotate[i] = dice_between(dice, 0, 360);
    view.camera.distance = dice_between(dice, 60, 150);
    view.camera.fov = 2 * atan(16 / view.camera.distance) * 57.29578;
    view.camera.projection = dice_pick(dice, 2) ? CSGCAST_ORTHOGRAPHIC : CSGCAST_PERSPECTIVE;
    return view;
}

/* Objects in double: which they are may differ in a pair, as it is judged object by object. */
static size_t count_precise(const struct run *run)
{
    struct csgcast_stats stats;
    csgcast_renderer_get_stats(run->renderer, &stats);
    return stats.precise_objects;
}

/* Depths are measured from the middle of the scene's box, which may be smaller in one of a pair,
 * where more of it is found not to matter: then they are the same but for rounding. */
static bool has_same_bounds(const struct csgcast_scene *a, const struct csgcast_scene *b)
{
    double lo[2][3], hi[2][3];
    const bool has_first = csgcast_scene_get_bounds(a, lo[0], hi[0]);
    const bool has_second = csgcast_scene_get_bounds(b, lo[1], hi[1]);
    return has_first == has_second &&
           (!has_first || (!memcmp(lo[0], lo[1], sizeof *lo) && !memcmp(hi[0], hi[1], sizeof *hi)));
}

/* Judges the two pictures, if they have been drawn, and keeps the texts of what differs. */
static void finish_texts(struct run *run, const char *name, bool drawn, bool exact,
                         struct text *first, struct text *second)
{
    if (!drawn || !judge(run, name, run->size, exact)) {
        run->failed += !drawn;
        save(name, "first", first);
        save(name, "second", second);
    }
    text_free(first);
    text_free(second);
}

/* Both scenes from the same camera. */
static void check_pair(struct run *run, const struct pair *pair, const struct operands *operands,
                       struct dice *dice, const char *name)
{
    struct text first = {0}, second = {0};
    put_formula(&first, pair->first, operands);
    put_formula(&second, pair->second, operands);
    struct csgcast_scene *a = parse(&first, name), *b = parse(&second, name);
    const struct csgcast_view view = random_view(dice, run->size);
    bool drawn = a && b && picture_render(run->renderer, a, &view, &run->first);
    size_t num_precise = count_precise(run);
    drawn = drawn && picture_render(run->renderer, b, &view, &run->second);
    num_precise += count_precise(run);
    const bool exact = pair->exact && num_precise == 0 && drawn && has_same_bounds(a, b);
    finish_texts(run, name, drawn, exact, &first, &second);
    csgcast_scene_destroy(a);
    csgcast_scene_destroy(b);
}

/* A map of the scene and what it does to the camera: p -> scale (+-x, y, z) + move, then turned
 * by a quarter about z, quarters times. */
struct motion {
    const char *name;
    double scale, move[3];
    bool mirror;
    double turn; /* degrees about z */
};

static const struct motion motions[] = {
    {"moved", 1, {-13.25, 700.5, 41}, false, 0},
    {"turned", 1, {0, 0, 0}, false, 33.75},
    {"scaled", 0.001, {0, 0, 0}, false, 0},
    {"moved, turned and scaled", 512, {31.5, -8, 64}, false, 211.5},
    {"mirrored", 1, {0, 0, 0}, true, 0},
};
enum { NUM_MOTIONS = sizeof motions / sizeof *motions };

static void put_motion(struct text *text, const struct motion *motion)
{
    const double angle = motion->turn * 3.14159265358979323846 / 180, s = motion->scale;
    const double side = motion->mirror ? -1 : 1;
    text_put(text,
             "multmatrix([[%.17g, %.17g, 0, %.17g], [%.17g, %.17g, 0, %.17g], "
             "[0, 0, %.17g, %.17g], [0, 0, 0, 1]])\n",
             side * s * cos(angle), -s * sin(angle), motion->move[0], side * s * sin(angle),
             s * cos(angle), motion->move[1], s, motion->move[2]);
}

/* A gimbal camera turned about z by turn and mirrored in x looks along the mirrored axis with the
 * picture mirrored left to right. */
static void move_camera(struct csgcast_camera *camera, const struct motion *motion)
{
    for (int i = 0; i < 3; i++)
        camera->translate[i] = motion->move[i];
    camera->distance *= motion->scale;
    if (motion->mirror) {
        camera->rotate[1] = -camera->rotate[1];
        camera->rotate[2] = -camera->rotate[2];
    }
    camera->rotate[2] += motion->turn;
}

static void flip(struct picture *picture)
{
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width / 2; x++) {
            const int i = y * picture->width + x, j = (y + 1) * picture->width - 1 - x;
            const float z = picture->z[i], id = picture->id[i];
            float n[3];
            picture->z[i] = picture->z[j];
            picture->z[j] = z;
            picture->id[i] = picture->id[j];
            picture->id[j] = id;
            memcpy(n, picture->normal + 3 * i, sizeof n);
            memcpy(picture->normal + 3 * i, picture->normal + 3 * j, sizeof n);
            memcpy(picture->normal + 3 * j, n, sizeof n);
        }
}

/* Brings the picture of the moved scene back. */
static void undo(struct picture *picture, const struct motion *motion)
{
    const double angle = motion->turn * 3.14159265358979323846 / 180;
    const float c = (float)cos(angle), s = (float)sin(angle);
    if (motion->mirror)
        flip(picture);
    for (int i = 0; i < picture->width * picture->height; i++) {
        float *n = picture->normal + 3 * i;
        const float x = c * n[0] + s * n[1], y = c * n[1] - s * n[0];
        n[0] = motion->mirror ? -x : x;
        n[1] = y;
        picture->z[i] /= (float)motion->scale;
    }
}

static void check_motion(struct run *run, const struct motion *motion,
                         const struct operands *operands, struct dice *dice, const char *name)
{
    static const char *const formula = "difference() { union() { A B } C }";
    struct text first = {0}, second = {0};
    put_formula(&first, formula, operands);
    put_motion(&second, motion);
    put_formula(&second, formula, operands);
    struct csgcast_scene *a = parse(&first, name), *b = parse(&second, name);
    struct csgcast_view view = random_view(dice, run->size);
    bool drawn = a && b && picture_render(run->renderer, a, &view, &run->first);
    move_camera(&view.camera, motion);
    drawn = drawn && picture_render(run->renderer, b, &view, &run->second);
    undo(&run->second, motion);
    finish_texts(run, name, drawn, false, &first, &second);
    csgcast_scene_destroy(a);
    csgcast_scene_destroy(b);
}

static struct operands random_operands(struct random_state *random, bool grid)
{
    const struct random_params params = {2, 4, grid, 1};
    struct operands operands;
    for (int i = 0; i < 3; i++)
        operands.texts[i] = random_scene(random, &params);
    return operands;
}

static void check_all(struct run *run, int rounds, unsigned long long seed)
{
    struct random_state random = {seed};
    struct dice dice = {seed + 1};
    char name[100];
    for (int round = 0; round < rounds; round++) {
        struct operands operands = random_operands(&random, round % 2);
        for (int i = 0; i < NUM_PAIRS; i++) {
            snprintf(name, sizeof name, "%llu-%d %s", seed, round, pairs[i].name);
            check_pair(run, &pairs[i], &operands, &dice, name);
        }
        for (int i = 0; i < NUM_MOTIONS; i++) {
            snprintf(name, sizeof name, "%llu-%d %s", seed, round, motions[i].name);
            check_motion(run, &motions[i], &operands, &dice, name);
        }
        snprintf(name, sizeof name, "%llu-%d", seed, round);
        check_windows(run, &operands, &dice, name);
        for (int i = 0; i < 3; i++)
            free(operands.texts[i]);
    }
}

int main(int argc, char **argv)
{
    struct run run = {.size = 48, .backend = CSGCAST_BACKEND_EGL};
    unsigned long long seed = 1;
    int rounds = 6;
    for (int i = 1; i < argc; i++)
        if (!option_int(argv[i], "--rounds=", &rounds) &&
            !option_int(argv[i], "--size=", &run.size) && !option_seed(argv[i], &seed) &&
            !option_backend(argv[i], &run.backend))
            return fprintf(stderr, "metamorphic: cannot use %s\n", argv[i]), 2;
    run.renderer =
        csgcast_renderer_create(&(struct csgcast_renderer_params){.backend = run.backend});
    run.first = picture_create(run.size, run.size);
    run.second = picture_create(run.size, run.size);
    if (run.renderer)
        check_all(&run, rounds, seed);
    printf("%s: %d of %d pairs differ\n", run.failed || !run.num ? "FAIL" : "ok", run.failed,
           run.num);
    picture_free(&run.first);
    picture_free(&run.second);
    csgcast_renderer_destroy(run.renderer);
    return run.failed || !run.num;
}
