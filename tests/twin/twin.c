/* SPDX-License-Identifier: MIT */

/*
 * Shader against reference, ray by ray: leaf, depth and normal of scenes given as files, or of
 * seeded random trees, for every variant and backend. Colours alone, which may be drawn without a
 * shading pass, must be those beside the depths to the last bit.
 *
 *     twin [--random=N] [--seed=S] [--size=PIXELS] [--backend=egl|osmesa] [FILE...]
 */

#include <csgcast/csgcast.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ideal/options.h"
#include "random_scene.h"

/* Float bounds that every pixel off an edge must hold. */
#define MAX_DEPTH_ERROR 4e-6 /* relative */
#define MAX_NORMAL_ERROR 0.1 /* degrees */
#define MAX_EDGE_SHARE 2e-3  /* share of the pixels that may differ within a pixel of an edge */

/* The same for the textbook's float, with the eye a few radii away. */
#define MAX_TEXTBOOK_DEPTH 5e-5
#define MAX_TEXTBOOK_SHARE 1e-2

struct options {
    int num_random, size;
    unsigned long long seed;
    enum csgcast_backend backend;
    const char *variant; /* NULL: all */
};

struct picture {
    float *z, *normal, *id;
    uint8_t *colors; /* rgba */
};

struct result {
    size_t pixels, edge, wrong;
    double depth, angle;
};

static struct picture make_picture(size_t pixels)
{
    struct picture picture = {malloc(pixels * sizeof(float)), malloc(3 * pixels * sizeof(float)),
                              malloc(pixels * sizeof(float)), malloc(4 * pixels)};
    if (!picture.z || !picture.normal || !picture.id || !picture.colors)
        abort();
    return picture;
}

static void free_picture(struct picture *picture)
{
    free(picture->z);
    free(picture->normal);
    free(picture->id);
    free(picture->colors);
}

static double angle_between(const float *a, const float *b)
{
    const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2],
                 z = a[0] * b[1] - a[1] * b[0];
    const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return atan2(sqrt(x * x + y * y + z * z), dot) * 180 / 3.14159265358979323846;
}

/* Whether another surface shows within a pixel: another leaf, a crease, or a step in depth. */
static bool is_edge(const struct picture *p, int size, int x, int y)
{
    const int here = y * size + x;
    for (int v = y > 0 ? y - 1 : 0; v <= y + 1 && v < size; v++)
        for (int u = x > 0 ? x - 1 : 0; u <= x + 1 && u < size; u++) {
            const int there = v * size + u;
            if (p->id[there] != p->id[here] || isnan(p->z[there]))
                return true;
            if (p->id[here] >= 0 &&
                (angle_between(p->normal + 3 * there, p->normal + 3 * here) > 20 ||
                 fabsf(p->z[there] - p->z[here]) > 0.02f * fabsf(p->z[here])))
                return true;
        }
    return false;
}

static bool is_wrong(const struct picture *a, const struct picture *b, int i, double max_depth,
                     double *depth, double *angle)
{
    if (isnan(b->z[i]) || isnan(b->normal[3 * i]) || a->id[i] != b->id[i])
        return true;
    if (a->id[i] < 0)
        return false;
    *depth = fabs(b->z[i] / (double)a->z[i] - 1);
    *angle = angle_between(a->normal + 3 * i, b->normal + 3 * i);
    return *depth > max_depth || *angle > MAX_NORMAL_ERROR;
}

static struct result compare(const struct picture *expected, const struct picture *got, int size,
                             double max_depth)
{
    struct result result = {.pixels = (size_t)size * (size_t)size};
    for (int y = 0; y < size; y++)
        for (int x = 0; x < size; x++) {
            double depth = 0, angle = 0;
            const bool wrong = is_wrong(expected, got, y * size + x, max_depth, &depth, &angle);
            if (wrong && is_edge(expected, size, x, y)) {
                result.edge++;
                continue;
            }
            if (wrong && !result.wrong)
                printf("  first wrong pixel %d,%d: leaf %g/%g depth %.9g/%.9g normal %.3g deg\n", x,
                       y, (double)expected->id[y * size + x], (double)got->id[y * size + x],
                       (double)expected->z[y * size + x], (double)got->z[y * size + x], angle);
            result.wrong += wrong;
            result.depth = fmax(result.depth, depth);
            result.angle = fmax(result.angle, angle);
        }
    return result;
}

static bool render(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                   const struct csgcast_view *view, const struct picture *picture)
{
    const struct csgcast_image image = {
        .z = picture->z, .normal = picture->normal, .id = picture->id, .rgba8 = picture->colors};
    return csgcast_render(renderer, scene, view, &image);
}

/* Whether colours alone are those of a picture with depths. Where leaves are asked for as well,
 * more objects may be drawn in double. */
static bool has_same_colors(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                            const struct csgcast_view *view, const struct picture *scratch)
{
    const size_t size = 4 * (size_t)view->width * (size_t)view->height;
    uint8_t *colors = malloc(size);
    const struct csgcast_image alone = {.rgba8 = colors};
    const struct csgcast_image beside = {.rgba8 = scratch->colors, .z = scratch->z};
    const bool same = colors && csgcast_render(renderer, scene, view, &alone) &&
                      csgcast_render(renderer, scene, view, &beside) &&
                      memcmp(colors, scratch->colors, size) == 0;
    free(colors);
    return same;
}

static bool check_view(struct csgcast_renderer *reference, struct csgcast_renderer *renderer,
                       const struct csgcast_scene *scene, const char *name,
                       struct csgcast_view *view, const struct options *options)
{
    const size_t pixels = (size_t)view->width * (size_t)view->height;
    struct picture expected = make_picture(pixels), got = make_picture(pixels);
    bool ok = render(reference, scene, view, &expected);
    for (size_t i = 0; csgcast_variant_name(i) && ok; i++) {
        const char *variant = csgcast_variant_name(i);
        /* The textbook's float is only looked at when asked for. */
        const bool textbook = strcmp(variant, "textbook") == 0;
        if (options->variant ? strcmp(options->variant, variant) != 0 : textbook)
            continue;
        view->variant = variant;
        if (!render(renderer, scene, view, &got)) {
            ok = false;
            break;
        }
        const struct result r =
            compare(&expected, &got, view->width, textbook ? MAX_TEXTBOOK_DEPTH : MAX_DEPTH_ERROR);
        const double share = textbook ? MAX_TEXTBOOK_SHARE : MAX_EDGE_SHARE;
        if (r.wrong || (double)r.edge > share * (double)r.pixels + 2) {
            printf("FAIL %s %s: %zu wrong, %zu at edges of %zu; depth %.2g, normal %.2g deg\n",
                   name, variant, r.wrong, r.edge, r.pixels, r.depth, r.angle);
            ok = false;
        }
        if (!has_same_colors(renderer, scene, view, &got)) {
            printf("FAIL %s %s: colours alone differ\n", name, variant);
            ok = false;
        }
    }
    view->variant = NULL;
    free_picture(&expected);
    free_picture(&got);
    return ok;
}

/* The default view, an orthographic one from elsewhere, and one from inside the scene's box. */
static bool check_scene(struct csgcast_renderer *reference, struct csgcast_renderer *renderer,
                        const struct csgcast_scene *scene, const char *name,
                        const struct options *options)
{
    struct csgcast_view view = {.width = options->size, .height = options->size};
    bool ok = check_view(reference, renderer, scene, name, &view, options);
    view.camera = (struct csgcast_camera){.kind = CSGCAST_CAMERA_GIMBAL,
                                          .rotate = {110, 20, 200},
                                          .projection = CSGCAST_ORTHOGRAPHIC,
                                          .viewall = true,
                                          .autocenter = true};
    ok &= check_view(reference, renderer, scene, name, &view, options);
    view.camera = (struct csgcast_camera){
        .kind = CSGCAST_CAMERA_VECTOR, .eye = {1.3, -2.1, 0.7}, .center = {5, 4, 3}, .fov = 70};
    /* The textbook knows no eye inside of a solid. */
    if (!options->variant || strcmp(options->variant, "textbook") != 0)
        ok &= check_view(reference, renderer, scene, name, &view, options);
    return ok;
}

static int check_random(struct csgcast_renderer *reference, struct csgcast_renderer *renderer,
                        const struct options *options)
{
    struct random_state random = {options->seed};
    int failed = 0;
    for (int i = 0; i < options->num_random; i++) {
        const struct random_params params = {1 + i % 8, 1 + i * 7 % 64, i % 2 ? 1 : 0, i % 3 == 0};
        char *text = random_scene(&random, &params), name[64];
        snprintf(name, sizeof name, "random-%llu-%d", (unsigned long long)options->seed, i);
        const struct csgcast_scene_params scene_params = {.name = name};
        struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &scene_params);
        const bool ok = scene && check_scene(reference, renderer, scene, name, options);
        if (!ok) {
            char path[80];
            snprintf(path, sizeof path, "%s.csg", name);
            FILE *file = fopen(path, "w");
            if (file) {
                fputs(text, file);
                fclose(file);
            }
            failed++;
        }
        csgcast_scene_destroy(scene);
        free(text);
    }
    printf("%s: %d random scenes, %d failed\n", failed ? "FAIL" : "ok", options->num_random,
           failed);
    return failed;
}

static int check_files(struct csgcast_renderer *reference, struct csgcast_renderer *renderer,
                       const struct options *options, int num, char **paths)
{
    int failed = 0;
    for (int i = 0; i < num; i++) {
        struct csgcast_scene *scene = csgcast_scene_load(paths[i], NULL);
        const bool ok = scene && check_scene(reference, renderer, scene, paths[i], options);
        printf("%s %s\n", ok ? "ok" : "FAIL", paths[i]);
        failed += !ok;
        csgcast_scene_destroy(scene);
    }
    return failed;
}

int main(int argc, char **argv)
{
    struct options options = {.size = 128, .seed = 1, .backend = CSGCAST_BACKEND_EGL};
    int first = 1;
    for (; first < argc && argv[first][0] == '-'; first++)
        if (!option_int(argv[first], "--random=", &options.num_random) &&
            !option_int(argv[first], "--size=", &options.size) &&
            !option_seed(argv[first], &options.seed) &&
            !option_text(argv[first], "--variant=", &options.variant) &&
            !option_backend(argv[first], &options.backend))
            return fprintf(stderr, "twin: cannot use %s\n", argv[first]), 2;
    struct csgcast_renderer *reference = csgcast_renderer_create(
        &(struct csgcast_renderer_params){.backend = CSGCAST_BACKEND_REFERENCE});
    struct csgcast_renderer *renderer =
        csgcast_renderer_create(&(struct csgcast_renderer_params){.backend = options.backend});
    if (!reference || !renderer)
        return 1;
    const int failed = check_random(reference, renderer, &options) +
                       check_files(reference, renderer, &options, argc - first, argv + first);
    csgcast_renderer_destroy(renderer);
    csgcast_renderer_destroy(reference);
    return failed != 0;
}
