/* SPDX-License-Identifier: MIT */

/*
 * Faces that coincide: every pair of kinds in every relation, seen from everywhere, the shader and
 * the reference against what the solids are by construction (tests/ideal), ray by ray. No pixel
 * may be wrong; pixels within one pixel of a silhouette or crease may differ.
 *
 *     coincidence [--backend=egl|osmesa] [--rounds=N] [--size=PIXELS] [--seed=S] [--variant=NAME]
 *                 [--relation=NAME] [--stride=N] [--full]
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ideal/judge.h"
#include "ideal/options.h"
#include "relations.h"

/* Of the pixels that may differ at edges. */
#define MAX_EDGE_SHARE 4e-3

struct options {
    enum csgcast_backend backend;
    int rounds, size, stride;
    unsigned long long seed;
    const char *variant, *relation;
};

struct totals {
    struct verdict shader, reference;
    size_t other_leaf; /* pixels where the shader names another leaf than the reference */
    int scenes, failed;
};

struct run {
    struct options options;
    struct csgcast_renderer *renderer, *reference;
    struct picture got, expected;
    struct totals by_relation[NUM_RELATIONS], by_placement[NUM_PLACEMENTS];
    int num_reported;
};

enum { MAX_REPORTED = 20 };

static void store(double out[3], struct ideal_vec v)
{
    out[0] = (double)v.x;
    out[1] = (double)v.y;
    out[2] = (double)v.z;
}

/* Generic, along an axis of the solids, or grazing the face that counts. */
static void choose_view(struct dice *dice, const struct pair *pair, struct csgcast_view *view)
{
    const double turn = 6.283185307179586;
    const double distance = dice_between(dice, 25, 200), reach = dice_between(dice, 3, 14);
    double elevation = dice_between(dice, 5, 75), azimuth = dice_between(dice, 0, turn);
    const int mode = dice_pick(dice, 4);
    if (mode == 1)
        elevation = dice_between(dice, 75, 89.9);
    if (mode == 2) {
        elevation = 90 * dice_pick(dice, 3);
        azimuth = turn / 4 * dice_pick(dice, 4);
    }
    const double up = elevation * turn / 360;
    const struct ideal_vec away =
        ideal_vec(sin(up) * cos(azimuth), sin(up) * sin(azimuth), cos(up));
    struct csgcast_camera *camera = &view->camera;
    memset(camera, 0, sizeof *camera);
    camera->kind = CSGCAST_CAMERA_VECTOR;
    camera->projection = dice_pick(dice, 2) ? CSGCAST_ORTHOGRAPHIC : CSGCAST_PERSPECTIVE;
    camera->fov = 2 * atan(reach / distance) * 360 / turn;
    store(camera->center, ideal_to_world(&pair->ideal, pair->target));
    store(camera->eye,
          ideal_to_world(&pair->ideal, ideal_add(pair->target, ideal_scale(distance, away))));
}

static void save(const struct pair *pair, const char *name, const struct csgcast_view *view)
{
    char path[160];
    snprintf(path, sizeof path, "%s.csg", name);
    FILE *file = fopen(path, "w");
    if (!file)
        return;
    const struct csgcast_camera *c = &view->camera;
    fprintf(file, "// eye %.17g %.17g %.17g center %.17g %.17g %.17g fov %.17g%s\n", c->eye[0],
            c->eye[1], c->eye[2], c->center[0], c->center[1], c->center[2], c->fov,
            c->projection == CSGCAST_ORTHOGRAPHIC ? " orthographic" : "");
    fputs(pair->text.data, file);
    fclose(file);
}

static void add(struct verdict *sum, const struct verdict *part)
{
    sum->rays += part->rays;
    sum->wrong += part->wrong;
    sum->edge += part->edge;
}

/* Pixels with another leaf than the reference, though the surface is the right one. */
static size_t count_other_leaves(struct run *run, const struct ideal_view *ideal, const char *name)
{
    const int size = run->options.size;
    size_t num = 0;
    for (int i = 0; i < size * size; i++) {
        if (run->got.id[i] == run->expected.id[i] || ideal_view_is_edge(ideal, i % size, i / size))
            continue;
        if (!num++ && run->num_reported++ < MAX_REPORTED)
            printf("%s: pixel %d,%d shows leaf %g, in the reference %g\n", name, i % size, i / size,
                   (double)run->got.id[i], (double)run->expected.id[i]);
    }
    return num;
}

static void report(struct run *run, const char *name, const char *who,
                   const struct verdict *verdict, const struct picture *picture)
{
    const int i = verdict->y * picture->width + verdict->x;
    if (verdict->wrong && run->num_reported++ < MAX_REPORTED)
        printf("%s: %s: %zu wrong of %zu, first %d,%d: leaf %g depth %.9g normal %.3f %.3f %.3f\n",
               name, who, verdict->wrong, verdict->rays, verdict->x, verdict->y,
               (double)picture->id[i], (double)picture->z[i], (double)picture->normal[3 * i],
               (double)picture->normal[3 * i + 1], (double)picture->normal[3 * i + 2]);
}

static bool check_variants(struct run *run, const struct pair *pair,
                           const struct csgcast_scene *scene, struct csgcast_view *view,
                           const struct ideal_view *ideal, const char *name, struct totals *totals)
{
    const struct tolerance tolerance = {pair->six ? 1e-4 : 2e-5, pair->six ? 1.0 : 0.5};
    bool ok = picture_render(run->reference, scene, view, &run->expected);
    if (!ok)
        return false;
    judge_picture(&run->expected, ideal, &tolerance, &totals->reference);
    report(run, name, "reference", &totals->reference, &run->expected);
    for (size_t i = 0; csgcast_variant_name(i) && ok; i++) {
        struct verdict verdict = {0};
        view->variant = csgcast_variant_name(i);
        if (run->options.variant ? strcmp(run->options.variant, view->variant) != 0
                                 : strcmp(view->variant, "textbook") == 0)
            continue;
        ok = picture_render(run->renderer, scene, view, &run->got);
        judge_picture(&run->got, ideal, &tolerance, &verdict);
        report(run, name, view->variant, &verdict, &run->got);
        add(&totals->shader, &verdict);
        if (!pair->six || !verdict.wrong)
            totals->other_leaf += count_other_leaves(run, ideal, name);
    }
    return ok;
}

static bool check_scene(struct run *run, const struct pair *pair, const struct csgcast_scene *scene,
                        struct csgcast_view *view, const char *name, struct totals *totals)
{
    struct csgcast_frustum frustum;
    if (!csgcast_view_resolve(scene, view, &frustum))
        return false;
    struct ideal_view ideal =
        ideal_view_create(&pair->ideal, &frustum, run->options.size, run->options.size);
    const bool ok = check_variants(run, pair, scene, view, &ideal, name, totals);
    ideal_view_free(&ideal);
    return ok;
}

static void accumulate(struct totals *sum, const struct totals *part)
{
    add(&sum->shader, &part->shader);
    add(&sum->reference, &part->reference);
    sum->other_leaf += part->other_leaf;
    sum->scenes++;
    sum->failed += part->failed;
}

static void check_pair(struct run *run, struct dice *dice, enum relation relation, enum kind a,
                       enum kind b, enum placement placement)
{
    struct pair pair;
    struct totals totals = {0};
    struct csgcast_view view = {.width = run->options.size, .height = run->options.size};
    char name[120];
    snprintf(name, sizeof name, "%s-%s-%s-%s-%llx", relation_names[relation], kind_names[a],
             relation_has_b(relation) ? kind_names[b] : "same", placement_names[placement],
             (unsigned long long)dice->state);
    pair_make(&pair, dice, relation, a, b, placement);
    choose_view(dice, &pair, &view);
    const struct csgcast_scene_params params = {.name = name};
    struct csgcast_scene *scene = csgcast_scene_parse(pair.text.data, pair.text.num, &params);
    const bool ok = scene && check_scene(run, &pair, scene, &view, name, &totals);
    totals.failed = !ok || totals.shader.wrong || totals.reference.wrong || totals.other_leaf;
    if (totals.failed && run->num_reported <= MAX_REPORTED)
        save(&pair, name, &view);
    accumulate(&run->by_relation[relation], &totals);
    accumulate(&run->by_placement[placement], &totals);
    csgcast_scene_destroy(scene);
    text_free(&pair.text);
}

static int num_kinds_of_b(enum relation relation)
{
    return relation_has_b(relation) ? NUM_KINDS : 1;
}

static void check_all(struct run *run)
{
    struct dice dice = {run->options.seed};
    int num = 0;
    for (int round = 0; round < run->options.rounds; round++)
        for (int relation = 0; relation < NUM_RELATIONS; relation++)
            for (int a = 0; a < NUM_KINDS; a++)
                for (int b = 0; b < num_kinds_of_b((enum relation)relation); b++) {
                    const int placement = dice_pick(&dice, NUM_PLACEMENTS);
                    struct dice own = {dice.state};
                    if (run->options.relation &&
                        strcmp(run->options.relation, relation_names[relation]) != 0)
                        continue;
                    if (relation_has_b((enum relation)relation) && num++ % run->options.stride)
                        continue;
                    check_pair(run, &own, (enum relation)relation, (enum kind)a, (enum kind)b,
                               (enum placement)placement);
                }
}

static void print_totals(const char *name, const struct totals *totals)
{
    if (totals->scenes)
        printf("| %s | %d | %zu | %zu | %zu | %zu | %zu | %zu |\n", name, totals->scenes,
               totals->shader.rays, totals->shader.wrong, totals->shader.edge, totals->other_leaf,
               totals->reference.wrong, totals->reference.edge);
}

static bool print_table(const struct run *run)
{
    struct totals all = {0};
    printf("| | scenes | rays | false | at edges | other leaf | false, reference | at edges |\n"
           "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (int i = 0; i < NUM_RELATIONS; i++) {
        print_totals(relation_names[i], &run->by_relation[i]);
        const int scenes = all.scenes + run->by_relation[i].scenes;
        accumulate(&all, &run->by_relation[i]);
        all.scenes = scenes;
    }
    for (int i = 0; i < NUM_PLACEMENTS; i++)
        print_totals(placement_names[i], &run->by_placement[i]);
    print_totals("all", &all);
    const bool many_edges = (double)all.shader.edge > MAX_EDGE_SHARE * (double)all.shader.rays;
    printf("%s: %d of %d scenes failed%s\n", all.failed || many_edges ? "FAIL" : "ok", all.failed,
           all.scenes, many_edges ? ", too many pixels differ at edges" : "");
    return !all.failed && !many_edges && all.scenes;
}

static bool read_option(struct options *options, const char *arg)
{
    if (strcmp(arg, "--full") == 0)
        options->rounds = 2, options->stride = 1, options->size = 48;
    else if (!option_int(arg, "--rounds=", &options->rounds) &&
             !option_int(arg, "--size=", &options->size) && !option_seed(arg, &options->seed) &&
             !option_int(arg, "--stride=", &options->stride) &&
             !option_text(arg, "--variant=", &options->variant) &&
             !option_text(arg, "--relation=", &options->relation) &&
             !option_backend(arg, &options->backend))
        return false;
    return options->rounds > 0 && options->size > 0 && options->stride > 0;
}

int main(int argc, char **argv)
{
    struct run *run = calloc(1, sizeof *run);
    if (!run)
        return 1;
    run->options = (struct options){
        .backend = CSGCAST_BACKEND_EGL, .rounds = 1, .size = 32, .stride = 7, .seed = 1};
    for (int i = 1; i < argc; i++)
        if (!read_option(&run->options, argv[i])) {
            free(run);
            return fprintf(stderr, "coincidence: cannot use %s\n", argv[i]), 2;
        }
    run->renderer =
        csgcast_renderer_create(&(struct csgcast_renderer_params){.backend = run->options.backend});
    run->reference = csgcast_renderer_create(
        &(struct csgcast_renderer_params){.backend = CSGCAST_BACKEND_REFERENCE});
    run->got = picture_create(run->options.size, run->options.size);
    run->expected = picture_create(run->options.size, run->options.size);
    bool ok = run->renderer && run->reference;
    if (ok) {
        check_all(run);
        ok = print_table(run);
    }
    picture_free(&run->got);
    picture_free(&run->expected);
    csgcast_renderer_destroy(run->renderer);
    csgcast_renderer_destroy(run->reference);
    free(run);
    return !ok;
}
