/* SPDX-License-Identifier: MIT */
#include "bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int num_failed;
static size_t num_messages;
const char *bench_forced;
char bench_last_message[512];

static void count_message(void *user, enum csgcast_log_level level, enum csgcast_message id,
                          const char *text)
{
    (void)user, (void)level, (void)id;
    num_messages++;
    snprintf(bench_last_message, sizeof bench_last_message, "%s", text);
}

static struct csgcast_scene *parse(const char *text, bool fixed)
{
    const struct csgcast_scene_params params = {
        .name = "model", .fixed = fixed, .log = count_message};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    if (!scene) {
        fprintf(stderr, "%s\n%s", bench_last_message, text);
        exit(1);
    }
    return scene;
}

struct csgcast_scene *bench_parse(const char *text)
{
    return parse(text, true);
}

void bench_draw(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                const struct csgcast_camera *camera, struct picture *picture)
{
    const struct csgcast_view view = {.width = SIZE,
                                      .height = SIZE,
                                      .camera = camera ? *camera : (struct csgcast_camera){0},
                                      .variant = bench_forced};
    const struct csgcast_image image = {
        .rgba = picture->rgba, .z = picture->z, .normal = picture->normal, .id = picture->id};
    CHECK(csgcast_render(renderer, scene, &view, &image), "the scene does not render");
}

struct csgcast_renderer *bench_create_renderer(const struct bench *bench)
{
    struct csgcast_renderer *renderer =
        csgcast_renderer_create(&(struct csgcast_renderer_params){.backend = bench->backend});
    if (!renderer)
        exit(1);
    return renderer;
}

struct csgcast_scene *bench_begin(struct bench *bench, const char *text)
{
    csgcast_renderer_destroy(bench->edited);
    bench->edited = bench_create_renderer(bench);
    bench->num_drawn = 0;
    return parse(text, false);
}

void bench_draw_edited(struct bench *bench, const struct csgcast_scene *scene,
                       const struct csgcast_camera *camera)
{
    struct csgcast_stats before, after;
    csgcast_renderer_get_stats(bench->edited, &before);
    bench_draw(bench->edited, scene, camera, &bench->got);
    csgcast_renderer_get_stats(bench->edited, &after);
    CHECK(bench_forced || bench->num_drawn == 0 || after.programs == before.programs,
          "an edit compiled: %zu programs became %zu (%s; numerics %s)\n%.4000s", before.programs,
          after.programs, after.variants, after.numerics, bench->text);
    bench->num_drawn++;
}

const char *bench_next_variant(size_t *name)
{
    const char *next = *name % 2 ? csgcast_variant_name(*name / 2) : NULL;
    const bool is_last = *name % 2 && !next;
    *name = is_last ? 0 : *name + 1;
    return next && strcmp(next, "textbook") != 0 ? next : NULL;
}

void bench_compare_pictures(const struct bench *bench, const char *what, bool with_id)
{
    size_t rgba = 0, z = 0, normal = 0, id = 0;
    for (int i = 0; i < PIXELS; i++) {
        rgba += memcmp(bench->got.rgba + 4 * i, bench->expected.rgba + 4 * i, 16) != 0;
        z += memcmp(&bench->got.z[i], &bench->expected.z[i], 4) != 0;
        normal += memcmp(bench->got.normal + 3 * i, bench->expected.normal + 3 * i, 12) != 0;
        id += with_id && bench->got.id[i] != bench->expected.id[i];
    }
    CHECK(rgba + z + normal + id == 0,
          "%s: pixels differ, rgba %zu z %zu normal %zu id %zu\n%.4000s", what, rgba, z, normal, id,
          bench->text);
}

void bench_compare_info(const struct csgcast_scene *a, const struct csgcast_scene *b,
                        const char *what)
{
    struct csgcast_scene_info x, y;
    double box[2][6] = {{0}};
    csgcast_scene_get_info(a, &x);
    csgcast_scene_get_info(b, &y);
    CHECK(x.num_leaves == y.num_leaves && x.num_nodes == y.num_nodes && x.depth == y.depth &&
              x.num_objects == y.num_objects && x.num_planes == y.num_planes &&
              x.num_quadrics == y.num_quadrics && x.num_shared == y.num_shared &&
              x.num_dropped == y.num_dropped && x.max_crossings == y.max_crossings &&
              x.num_kinds == y.num_kinds,
          "%s: counts differ: leaves %zu/%zu nodes %zu/%zu objects %zu/%zu planes %zu/%zu shared "
          "%zu/%zu dropped %zu/%zu",
          what, x.num_leaves, y.num_leaves, x.num_nodes, y.num_nodes, x.num_objects, y.num_objects,
          x.num_planes, y.num_planes, x.num_shared, y.num_shared, x.num_dropped, y.num_dropped);
    CHECK(csgcast_scene_get_bounds(a, box[0], box[0] + 3) ==
                  csgcast_scene_get_bounds(b, box[1], box[1] + 3) &&
              memcmp(box[0], box[1], sizeof box[0]) == 0,
          "%s: bounds differ", what);
}

void bench_compare_text(struct bench *bench, const struct csgcast_scene *scene, const char *what,
                        bool with_id)
{
    struct csgcast_scene *fresh = bench_parse(bench->text);
    bench_draw_edited(bench, scene, NULL);
    bench_draw(bench->fresh, fresh, NULL, &bench->expected);
    bench_compare_pictures(bench, what, with_id);
    if (with_id)
        bench_compare_info(scene, fresh, what);
    csgcast_scene_destroy(fresh);
}

void bench_compare(struct bench *bench, const struct csgcast_scene *scene,
                   const struct model *model, const char *what, bool with_id)
{
    model_print(model, bench->text);
    bench_compare_text(bench, scene, what, with_id);
}
