/* SPDX-License-Identifier: MIT */

/* Pictures of bytes alone have no shading pass where few solids hide others. That is asked of
 * views; frames after an edit keep to it, as they compile nothing. */

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "bench.h"

enum { NUM_WALLS = 8 };

static const struct csgcast_camera front = {
    .kind = CSGCAST_CAMERA_GIMBAL, .rotate = {90, 0, 0}, .distance = 300};
static const struct csgcast_camera side = {
    .kind = CSGCAST_CAMERA_GIMBAL, .rotate = {90, 0, 90}, .distance = 300};

/* Walls with holes: from the front each hides the next, from the side they stand in a row. */
static void print_walls(double height, double alpha, char *text)
{
    for (int i = 0; i < NUM_WALLS; i++)
        text += sprintf(text,
                        "color([1, 0.5, 0, %g]) "
                        "multmatrix([[1,0,0,0],[0,1,0,%d],[0,0,1,0],[0,0,0,1]]) difference() {"
                        " cube(size = [90, 4, %g], center = true);"
                        " sphere(r = 15); sphere(r = %d); }\n",
                        i == 2 ? alpha : 1, 12 * i - 42, i == 2 ? height : 60, 16 + i);
}

static void draw_bytes(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                       const struct csgcast_camera *camera, uint8_t *bytes)
{
    const struct csgcast_view view = {.width = SIZE, .height = SIZE, .camera = *camera};
    const struct csgcast_image image = {.rgba8 = bytes};
    CHECK(csgcast_render(renderer, scene, &view, &image), "the scene does not render");
}

static size_t count_programs(const struct bench *bench)
{
    struct csgcast_stats stats;
    csgcast_renderer_get_stats(bench->edited, &stats);
    return stats.programs;
}

/* The frame after an edit: no program, and the picture of the text as it is now. */
static void check_frame(struct bench *bench, const struct csgcast_scene *scene,
                        const struct csgcast_camera *camera, const char *what)
{
    static uint8_t got[4 * PIXELS], expected[4 * PIXELS];
    const size_t before = count_programs(bench);
    draw_bytes(bench->edited, scene, camera, got);
    CHECK(count_programs(bench) == before, "an edit compiled: %s", what);
    struct csgcast_scene *fresh = bench_parse(bench->text);
    draw_bytes(bench->fresh, fresh, camera, expected);
    CHECK(memcmp(got, expected, sizeof got) == 0, "an edit, another picture: %s", what);
    csgcast_scene_destroy(fresh);
}

static void set_height(struct bench *bench, struct csgcast_scene *scene, double height)
{
    char parameters[64];
    sprintf(parameters, "size = [90, 4, %g], center = true", height);
    CHECK(csgcast_scene_set_parameters(scene, 6, parameters), "%s", bench_last_message);
    print_walls(height, 1, bench->text);
}

static void check_height(struct bench *bench, struct csgcast_scene *scene, double height,
                         const struct csgcast_camera *camera)
{
    set_height(bench, scene, height);
    check_frame(bench, scene, camera, "a wall's height");
}

static void check_views(struct bench *bench)
{
    static uint8_t bytes[4 * PIXELS];
    print_walls(60, 1, bench->text);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    draw_bytes(bench->edited, scene, &front, bytes);
    check_height(bench, scene, 50, &front);
    check_height(bench, scene, 40, &side);
    const size_t before = count_programs(bench);
    draw_bytes(bench->edited, scene, &side, bytes);
    CHECK(bench->backend == CSGCAST_BACKEND_REFERENCE || count_programs(bench) > before,
          "a view that needs no shading pass has one");
    check_height(bench, scene, 55, &side);
    check_height(bench, scene, 45, &front);
    csgcast_scene_destroy(scene);
}

/* What is translucent in the first frame has a shading pass in any case. */
static void check_opaque(struct bench *bench, const struct csgcast_camera *camera)
{
    static uint8_t bytes[4 * PIXELS];
    const float opaque[4] = {1, 0.5F, 0, 1};
    const struct csgcast_edit edits[3] = {
        {.leaf = 6, .color = opaque}, {.leaf = 7, .color = opaque}, {.leaf = 8, .color = opaque}};
    print_walls(60, 0.5, bench->text);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    draw_bytes(bench->edited, scene, camera, bytes);
    CHECK(csgcast_scene_edit(scene, edits, 3), "%s", bench_last_message);
    print_walls(60, 1, bench->text);
    check_frame(bench, scene, camera, "opaque");
    check_height(bench, scene, 50, camera);
    csgcast_scene_destroy(scene);
}

/* A frame after an edit may be asked for other channels than those before: colours for a preview,
 * owners for what a pointer picks. */
static void check_channels(struct bench *bench)
{
    static uint8_t bytes[4 * PIXELS];
    print_walls(60, 1, bench->text);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    draw_bytes(bench->edited, scene, &front, bytes);
    const size_t before = count_programs(bench);
    set_height(bench, scene, 50);
    bench_compare_text(bench, scene, "all channels after bytes", true);
    CHECK(count_programs(bench) == before, "other channels compiled");
    csgcast_scene_destroy(scene);

    print_walls(60, 1, bench->text);
    scene = bench_begin(bench, bench->text);
    bench_draw_edited(bench, scene, &front);
    check_height(bench, scene, 50, &front);
    csgcast_scene_destroy(scene);
}

void check_shading(struct bench *bench)
{
    check_channels(bench);
    check_views(bench);
    check_opaque(bench, &front);
    check_opaque(bench, &side);
}
