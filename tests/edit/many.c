/* SPDX-License-Identifier: MIT */

/* Random edits in a row of scenes of many objects. */

#include <stdio.h>
#include <string.h>

#include "bench.h"

enum { NUM_OBJECTS = 200, NUM_IN_A_ROW = 60 };

/* Somewhere near its place; at times out of view, or over many others. */
static void move(struct model *model, struct model_leaf *leaf)
{
    model_random_matrix(model, leaf->matrix);
    for (int k = 0; k < 3; k++)
        leaf->matrix[4 * k + 3] += leaf->place[k];
    switch ((int)model_random(model, 0, 12)) {
    case 0:
        leaf->matrix[3] += 300;
        break;
    case 1:
        for (int k = 0; k < 3; k++)
            leaf->matrix[5 * k] *= 4;
        break;
    default:
        break;
    }
}

static const char *change(struct model *model, struct csgcast_scene *scene, size_t index)
{
    struct model_leaf *leaf = &model->leaves[index];
    struct csgcast_edit edit = {.leaf = index};
    const int what = (int)model_random(model, 0, 8);
    if (what < 4 || leaf->is_rendered || !model_has_parameters(leaf))
        move(model, leaf);
    else if (what < 6)
        model_random_parameters(model, leaf->kind, leaf->parameters);
    else if (what == 6 && index % 4 == 0 && strcmp(leaf->kind, "sphere") == 0)
        snprintf(leaf->parameters, sizeof leaf->parameters, "r = 0");
    else
        model_random_color(model, leaf->color);
    edit.matrix = leaf->matrix;
    edit.parameters = model_has_parameters(leaf) ? leaf->parameters : NULL;
    edit.color = leaf->color[0] >= 0 ? leaf->color : NULL;
    CHECK(csgcast_scene_edit(scene, &edit, 1), "%s", bench_last_message);
    return what < 4 ? "move" : what < 6 ? "parameters" : "look";
}

/* Fresh scenes give what is empty no number. */
static bool has_empty(const struct model *model)
{
    for (int i = 0; i < model->num_leaves; i++)
        if (strcmp(model->leaves[i].parameters, "r = 0") == 0)
            return true;
    return false;
}

/* Every few of them are compared with a fresh scene. */
void check_many(struct bench *bench, uint64_t seed, bool marked, bool has_surfaces)
{
    static struct model model;
    size_t name = 0;
    model_init_many(&model, seed, NUM_OBJECTS, marked, has_surfaces);
    model_print(&model, bench->text);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    for (int i = 0; i < NUM_IN_A_ROW; i++) {
        const char *what = change(&model, scene, (size_t)model_random(&model, 0, model.num_leaves));
        if (i % 3)
            continue;
        bench_forced = bench_next_variant(&name);
        bench_compare(bench, scene, &model, what, !has_empty(&model));
    }
    bench_forced = NULL;
    csgcast_scene_destroy(scene);
}

/* Of the frame after an edit only rows of 4 kB that have changed go to the driver; textures of
 * scenes that are edited are copied for that. */
void check_upload(struct bench *bench)
{
    static struct model model;
    const float red[4] = {1, 0, 0, 1};
    const struct csgcast_camera camera = {
        .kind = CSGCAST_CAMERA_GIMBAL, .translate = {15, 15, 15}, .distance = 120};
    struct csgcast_stats stats;
    model_init_many(&model, 7, NUM_OBJECTS, false, false);
    for (int i = 0; i < model.num_leaves; i++)
        model.leaves[i].color[0] = -1;
    model_print(&model, bench->text);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    for (int i = 0; i < 2; i++) {
        bench_draw_edited(bench, scene, &camera);
        CHECK(csgcast_scene_set_color(scene, 17, red), "%s", bench_last_message);
    }
    bench_draw_edited(bench, scene, &camera);
    csgcast_renderer_get_stats(bench->edited, &stats);
    CHECK(4 * stats.bytes_uploaded <= stats.texture_bytes, "a colour: %zu bytes of %zu",
          stats.bytes_uploaded, stats.texture_bytes);
    bench_draw_edited(bench, scene, &camera);
    csgcast_renderer_get_stats(bench->edited, &stats);
    CHECK(stats.bytes_uploaded == 0, "nothing: %zu bytes", stats.bytes_uploaded);
    csgcast_scene_destroy(scene);
}
