/* SPDX-License-Identifier: MIT */

/* Random edits of random scenes. */

#include <string.h>

#include "bench.h"

/* Many edits of one scene, each leaf also far away, large or gone for a while, every few of them
 * drawn by the next variant. */
void check_series(struct bench *bench, uint64_t seed)
{
    static struct model model;
    size_t name = 0;
    model_init(&model, seed, 24);
    for (int i = 0; i < model.num_leaves; i++)
        model.leaves[i].color[0] = -1;
    model_print(&model, bench->text);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    for (int i = 0; i < 8 * NUM_EDITS; i++) {
        const size_t leaf = (size_t)model_random(&model, 0, model.num_leaves);
        struct model_leaf *own = &model.leaves[leaf];
        model_random_matrix(&model, own->matrix);
        own->matrix[3] += i % 7 == 3 ? 300 : 0;
        for (int j = 0; j < 3 && i % 7 == 5; j++)
            own->matrix[5 * j] *= 20;
        CHECK(csgcast_scene_set_matrix(scene, leaf, own->matrix), "%s", bench_last_message);
        if (i % 4)
            continue;
        bench_forced = bench_next_variant(&name);
        bench_compare(bench, scene, &model, bench_forced ? bench_forced : "auto", true);
    }
    bench_forced = NULL;
    csgcast_scene_destroy(scene);
}

/* One random change, made in the model and in the scene. */
static const char *edit_one(struct model *model, struct csgcast_scene *scene, size_t leaf)
{
    struct model_leaf *own = &model->leaves[leaf];
    switch ((int)model_random(model, 0, 3)) {
    case 0:
        model_random_matrix(model, own->matrix);
        CHECK(csgcast_scene_set_matrix(scene, leaf, own->matrix), "%s", bench_last_message);
        return "matrix";
    case 1:
        model_random_parameters(model, own->kind, own->parameters);
        CHECK(csgcast_scene_set_parameters(scene, leaf, own->parameters), "%s", bench_last_message);
        return "parameters";
    default:
        model_random_color(model, own->color);
        CHECK(csgcast_scene_set_color(scene, leaf, own->color), "%s", bench_last_message);
        return "colour";
    }
}

static size_t random_leaf(struct model *model)
{
    return (size_t)model_random(model, 0, model->num_leaves);
}

void check_random(struct bench *bench, uint64_t seed, int max_leaves)
{
    static struct model model;
    model_init(&model, seed, max_leaves);
    model_print(&model, bench->text);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    bench_compare(bench, scene, &model, "before", true);
    for (int i = 0; i < NUM_EDITS; i++) {
        const char *what = edit_one(&model, scene, random_leaf(&model));
        bench_compare(bench, scene, &model, what, true);
    }
    csgcast_scene_destroy(scene);
}

/* Solids that come and go, of all structures, in one view. */
void check_programs(struct bench *bench, uint64_t seed, int max_leaves)
{
    static struct model model;
    const struct csgcast_camera camera = {.kind = CSGCAST_CAMERA_GIMBAL,
                                          .translate = {3, 3, 3},
                                          .rotate = {58, 7, 23},
                                          .distance = 120};
    const float orange[4] = {1, 0.5f, 0, 1};
    model_init(&model, seed, max_leaves);
    for (int i = 0; i < model.num_leaves; i++)
        model.leaves[i].color[0] = -1;
    model_print(&model, bench->text);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    bench_draw_edited(bench, scene, &camera);
    for (int i = 0; i < 4 * NUM_EDITS; i++) {
        const size_t leaf = random_leaf(&model);
        model_random_matrix(&model, model.leaves[leaf].matrix);
        model_random_parameters(&model, model.leaves[leaf].kind, model.leaves[leaf].parameters);
        const struct csgcast_edit edit = {.leaf = leaf,
                                          .matrix = model.leaves[leaf].matrix,
                                          .parameters = model.leaves[leaf].parameters,
                                          .color = orange};
        CHECK(csgcast_scene_edit(scene, &edit, 1), "%s", bench_last_message);
        bench_draw_edited(bench, scene, &camera);
    }
    csgcast_scene_destroy(scene);
}

/* Many leaves in one call, one of them twice. */
void check_batch(struct bench *bench)
{
    static struct model model;
    struct csgcast_edit edits[5] = {{0}};
    double matrices[5][16];
    model_init(&model, 11, 20);
    model_print(&model, bench->text);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    for (size_t i = 0; i < 5; i++) {
        model_random_matrix(&model, matrices[i]);
        edits[i] = (struct csgcast_edit){.leaf = i < 4 ? i : 0, .matrix = matrices[i]};
        memcpy(model.leaves[edits[i].leaf].matrix, matrices[i], sizeof matrices[i]);
    }
    CHECK(csgcast_scene_edit(scene, edits, 5), "%s", bench_last_message);
    bench_compare(bench, scene, &model, "batch", true);
    csgcast_scene_destroy(scene);
}

/* By turns all leaves in one call, and one of them. */
void check_all(struct bench *bench)
{
    static struct model model;
    static struct csgcast_edit edits[MODEL_MAX_LEAVES];
    model_init(&model, 12, 40);
    model_print(&model, bench->text);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    bench_compare(bench, scene, &model, "before", true);
    for (int i = 0; i < 4 * NUM_EDITS; i++) {
        const int num = i % 3 == 2 ? 1 : model.num_leaves;
        for (int j = 0; j < num; j++) {
            struct model_leaf *leaf = &model.leaves[num == 1 ? (size_t)i : (size_t)j];
            model_random_matrix(&model, leaf->matrix);
            edits[j] = (struct csgcast_edit){.leaf = (size_t)(leaf - model.leaves),
                                             .matrix = leaf->matrix};
        }
        CHECK(csgcast_scene_edit(scene, edits, (size_t)num), "%s", bench_last_message);
        bench_compare(bench, scene, &model, num == 1 ? "one of all" : "all at once", true);
    }
    csgcast_scene_destroy(scene);
}
