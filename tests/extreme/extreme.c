/* SPDX-License-Identifier: MIT */

/*
 * Stiff and extreme scenes: the shader, in float and where the scene asks for it in double, and the
 * double-precision reference, against a ray caster in long double that knows only the construction
 * (tests/ideal). Prints a table, or CSV.
 *
 *     extreme [--backend=egl|osmesa|reference] [--shots=N] [--size=PIXELS] [--seed=S]
 *             [--sweep=NAME] [--value=X] [--variant=NAME] [--csv] [--full] [--shots-too]
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crowds.h"
#include "ideal/options.h"
#include "measure.h"
#include "sweeps.h"

/* The bars. */
#define MAX_WRONG_SHARE 2e-5
#define MAX_DEPTH 2e-6  /* relative, at QUANTILE */
#define MAX_NORMAL 0.05 /* degrees, at QUANTILE */
#define QUANTILE 0.999

/* One ray in each variant, which in a small run is more than that share. */
#define FEW_RAYS 6

/* Where solids touch in a point or line, what is left there can be too small for any pixel to tell
 * that it is near a silhouette. */
#define MAX_CONTACT_SHARE 3e-4

struct options {
    enum csgcast_backend backend;
    int shots, size;
    unsigned long long seed;
    const char *sweep, *variant;
    double value; /* 0: all */
    bool csv, full, shots_too;
};

struct run {
    struct options options;
    struct csgcast_renderer *renderer, *reference;
    struct picture picture;
    int num_reported;
};

enum { MAX_REPORTED = 24 };

static void save(const struct shot *shot, const char *name)
{
    char path[160];
    snprintf(path, sizeof path, "%s.csg", name);
    FILE *file = fopen(path, "w");
    if (!file)
        return;
    const struct csgcast_camera *c = &shot->view.camera;
    fprintf(file, "// eye %.17g %.17g %.17g center %.17g %.17g %.17g fov %.17g%s\n", c->eye[0],
            c->eye[1], c->eye[2], c->center[0], c->center[1], c->center[2], c->fov,
            c->projection == CSGCAST_ORTHOGRAPHIC ? " orthographic" : "");
    fputs(shot->text.data, file);
    fclose(file);
}

static size_t num_bad(const struct measure *measure)
{
    return measure->outside + measure->other + measure->nan;
}

static void report(struct run *run, const struct shot *shot, const char *name, const char *who,
                   const struct measure *measure, const struct measure *before)
{
    if (num_bad(measure) == num_bad(before) || run->num_reported++ >= MAX_REPORTED)
        return;
    fprintf(stderr, "%s: %s: %zu wrong, %zu on another surface, %zu not finite, last %d,%d\n", name,
            who, measure->outside - before->outside, measure->other - before->other,
            measure->nan - before->nan, measure->x, measure->y);
    save(shot, name);
}

/* One line a shot, for those who look for the one that is wrong. */
static void print_shot(const struct run *run, const struct csgcast_renderer *renderer,
                       const struct shot *shot, const char *name, const struct measure *m,
                       const struct measure *before)
{
    struct csgcast_stats stats;
    csgcast_renderer_get_stats(renderer, &stats);
    double depth = 0, normal = 0;
    for (size_t i = before->depth.num; i < m->depth.num; i++) {
        depth = fmax(depth, m->depth.data[i]);
        normal = fmax(normal, m->normal.data[i]);
    }
    if (run->options.shots_too)
        fprintf(stderr, "%s: %s: wrong %zu off %.2g outside %zu other %zu depth %.2g normal %.2g\n",
                name, stats.variants, m->misses - before->misses, m->displaced,
                m->outside - before->outside, m->other - before->other, depth, normal);
    if (run->options.shots_too &&
        (m->misses > before->misses || depth > MAX_DEPTH || normal > MAX_NORMAL))
        save(shot, name);
}

static bool shoot(struct run *run, struct csgcast_renderer *renderer, const char *variant,
                  const struct csgcast_scene *scene, struct shot *shot,
                  const struct ideal_view *view, const char *name, struct measure *measure)
{
    const struct measure before = *measure;
    shot->view.variant = variant;
    if (!picture_render(renderer, scene, &shot->view, &run->picture))
        return false;
    measure_add(measure, &run->picture, view, shot->extent);
    print_shot(run, renderer, shot, name, measure, &before);
    report(run, shot, name, variant ? variant : "reference", measure, &before);
    return true;
}

/* By the reference, and by each variant. */
static bool shoot_all(struct run *run, const struct csgcast_scene *scene, struct shot *shot,
                      const char *name, struct measure *shader, struct measure *reference)
{
    struct csgcast_frustum frustum;
    if (!csgcast_view_resolve(scene, &shot->view, &frustum))
        return false;
    struct ideal_view view =
        ideal_view_create(&shot->ideal, &frustum, run->options.size, run->options.size);
    bool ok = shoot(run, run->reference, NULL, scene, shot, &view, name, reference);
    for (size_t i = 0; ok && csgcast_variant_name(i); i++)
        if (run->options.variant ? strcmp(run->options.variant, csgcast_variant_name(i)) == 0
                                 : strcmp(csgcast_variant_name(i), "textbook") != 0)
            ok = shoot(run, run->renderer, csgcast_variant_name(i), scene, shot, &view, name,
                       shader);
    ideal_view_free(&view);
    return ok;
}

static bool run_shot(struct run *run, const struct sweep *sweep, double value, int index,
                     struct dice *dice, struct measure *shader, struct measure *reference)
{
    struct shot shot;
    char name[100];
    snprintf(name, sizeof name, "%.20s-%g-%d-%llx", sweep->name, value, index,
             (unsigned long long)dice->state);
    sweep->make(&shot, dice, value, index);
    shot.view.width = shot.view.height = run->options.size;
    const struct csgcast_scene_params params = {.name = name};
    struct csgcast_scene *scene = csgcast_scene_parse(shot.text.data, shot.text.num, &params);
    const bool ok = scene && shoot_all(run, scene, &shot, name, shader, reference);
    if (!ok) {
        fprintf(stderr, "%s: not rendered\n", name);
        save(&shot, name);
    }
    csgcast_scene_destroy(scene);
    text_free(&shot.text);
    return ok;
}

static bool is_good(struct measure *measure, const struct sweep *sweep)
{
    const double rays = (double)measure->rays, lost = (double)(measure->outside + measure->other);
    const double wrong_share = sweep->contacts ? MAX_CONTACT_SHARE : MAX_WRONG_SHARE;
    return measure->nan == 0 && lost <= (sweep->contacts ? MAX_CONTACT_SHARE * rays : 0) &&
           (double)measure->misses <= wrong_share * rays + FEW_RAYS &&
           errors_quantile(&measure->depth, QUANTILE) <= MAX_DEPTH &&
           errors_quantile(&measure->normal, QUANTILE) <= MAX_NORMAL;
}

static void print_row(const struct run *run, const struct sweep *sweep, double value,
                      const char *who, struct measure *m, bool good)
{
    const char *format =
        run->options.csv
            ? "%s,%g,%s,%zu,%zu,%.3g,%zu,%zu,%zu,%.3g,%.3g,%.3g,%.3g,%s\n"
            : "| %s | %g | %s | %zu | %zu | %.2g | %zu | %zu | %zu | %.2g | %.2g | %.2g "
              "| %.2g | %s |\n";
    printf(format, sweep->name, value, who, m->rays, m->misses, m->displaced, m->outside, m->other,
           m->nan, errors_quantile(&m->depth, QUANTILE), errors_quantile(&m->depth, 1),
           errors_quantile(&m->normal, QUANTILE), errors_quantile(&m->normal, 1),
           good ? "ok" : "FAIL");
    fflush(stdout);
}

static bool run_value(struct run *run, const struct sweep *sweep, double value, struct dice *dice)
{
    struct measure shader = {0}, reference = {0};
    bool ok = true;
    /* A stride through the different shots, so that a few show all kinds over the values. */
    const int start = dice_pick(dice, sweep->num_shots);
    for (int i = 0; i < run->options.shots && ok; i++) {
        struct dice own = {dice->state};
        ok = run_shot(run, sweep, value, (start + 5 * i) % sweep->num_shots, &own, &shader,
                      &reference);
        dice_between(dice, 0, 1);
    }
    const bool shader_good = is_good(&shader, sweep);
    const bool reference_good = is_good(&reference, sweep);
    print_row(run, sweep, value, "shader", &shader, shader_good);
    print_row(run, sweep, value, "reference", &reference, reference_good);
    measure_free(&shader);
    measure_free(&reference);
    return ok && shader_good && reference_good;
}

static bool run_sweeps(struct run *run)
{
    static const char *const heads[] = {
        "sweep",
        "value",
        "of",
        "rays",
        "wrong",
        "pixels off",
        "outside a pixel",
        "other surface",
        "not finite",
        "depth p99.9",
        "depth max",
        "normal p99.9",
        "normal max",
        "verdict",
    };
    bool ok = true;
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++)
        printf(run->options.csv ? (i ? ",%s" : "%s") : "| %s ", heads[i]);
    printf(run->options.csv ? "\n" : "|\n");
    for (size_t i = 0; i < sizeof heads / sizeof *heads && !run->options.csv; i++)
        printf("| --- ");
    printf(run->options.csv ? "" : "|\n");
    for (int i = 0; i < num_sweeps; i++) {
        struct dice dice = {run->options.seed + (unsigned long long)i * 1000003};
        if (run->options.sweep && strcmp(run->options.sweep, sweeps[i].name) != 0)
            continue;
        for (int j = 0; j < sweeps[i].num_values; j++) {
            if (run->options.value != 0 && run->options.value != sweeps[i].values[j])
                continue;
            ok &= run_value(run, &sweeps[i], sweeps[i].values[j], &dice);
        }
    }
    if (!run->options.sweep || strcmp(run->options.sweep, "crowds") == 0)
        ok &= crowds_check(run->renderer, run->options.full, run->options.csv);
    return ok;
}

static bool read_option(struct options *options, const char *arg)
{
    const char *value;
    if (option_text(arg, "--value=", &value))
        options->value = atof(value);
    else if (strcmp(arg, "--shots-too") == 0)
        options->shots_too = true;
    else if (strcmp(arg, "--csv") == 0)
        options->csv = true;
    else if (strcmp(arg, "--full") == 0)
        options->shots = 112, options->size = 96, options->full = true;
    else if (!option_int(arg, "--shots=", &options->shots) &&
             !option_int(arg, "--size=", &options->size) && !option_seed(arg, &options->seed) &&
             !option_text(arg, "--sweep=", &options->sweep) &&
             !option_text(arg, "--variant=", &options->variant) &&
             !option_backend(arg, &options->backend))
        return false;
    return options->shots > 0 && options->size > 0;
}

int main(int argc, char **argv)
{
    struct run run = {
        .options = {.backend = CSGCAST_BACKEND_EGL, .shots = 3, .size = 64, .seed = 1}};
    for (int i = 1; i < argc; i++)
        if (!read_option(&run.options, argv[i]))
            return fprintf(stderr, "extreme: cannot use %s\n", argv[i]), 2;
    run.renderer =
        csgcast_renderer_create(&(struct csgcast_renderer_params){.backend = run.options.backend});
    run.reference = csgcast_renderer_create(
        &(struct csgcast_renderer_params){.backend = CSGCAST_BACKEND_REFERENCE});
    run.picture = picture_create(run.options.size, run.options.size);
    const bool ok = run.renderer && run.reference && run_sweeps(&run);
    if (!run.options.csv)
        printf("%s\n", ok ? "ok" : "FAIL");
    picture_free(&run.picture);
    csgcast_renderer_destroy(run.renderer);
    csgcast_renderer_destroy(run.reference);
    return !ok;
}
