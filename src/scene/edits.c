/* SPDX-License-Identifier: MIT */
#include "scene/edits.h"

#include <stdlib.h>
#include <string.h>

#include "cells/store.h"
#include "common/clock.h"
#include "nodes/text.h"
#include "prepare/follow.h"
#include "prepare/scene.h"
#include "scene/load.h"

void csg_edits_destroy(struct csg_edits *edits)
{
    if (!edits)
        return;
    csg_origins_finish(&edits->origins);
    csg_node_texts_finish(&edits->texts);
    csg_text_finish(&edits->text);
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++) {
        free(edits->whole[layer].data);
        free(edits->trees[layer].data);
    }
    free(edits->patches);
    free(edits);
}

/* The trees as the text has them change hands; copies are without what no edit brings back. */
static bool take_trees(struct csg_edits *edits, struct csgcast_scene *raw)
{
    bool ok = true;
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++) {
        ok = ok && csg_tree_copy(&raw->trees[layer], &edits->trees[layer]) &&
             csg_tree_simplify(&edits->trees[layer], NULL);
        edits->whole[layer] = raw->trees[layer];
        raw->trees[layer] = (struct csg_tree){0};
    }
    edits->num_dropped = raw->info.num_dropped;
    return ok;
}

struct csg_edits *csg_edits_of(struct csgcast_scene *scene)
{
    if (scene->edits)
        return scene->edits;
    if (scene->source->params.fixed) {
        csg_log_error(&scene->log, CSGCAST_MESSAGE_ARGUMENT,
                      "%s: the scene was read as a fixed one (csgcast_scene_params), whose leaves "
                      "are neither told nor edited",
                      scene->name);
        return NULL;
    }
    struct csg_edits *edits = calloc(1, sizeof *edits);
    uint32_t *patches = calloc(scene->num_leaves + 1, sizeof *patches);
    struct csg_document document = {0};
    struct csgcast_scene *raw =
        edits && patches ? csg_scene_reread(scene, &edits->origins, &document) : NULL;
    if (!raw || raw->num_leaves != scene->num_leaves || !take_trees(edits, raw) ||
        !csg_node_texts_init(&edits->texts, &document)) {
        csg_log_memory(&scene->log);
        free(patches);
        csg_document_finish(&document);
        csg_edits_destroy(edits);
        csgcast_scene_destroy(raw);
        return NULL;
    }
    csgcast_scene_destroy(raw);
    edits->patches = patches;
    scene->edits = edits;
    return edits;
}

static bool copy_trees(struct csgcast_scene *scene, const struct csg_edits *edits)
{
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++)
        if (!csg_tree_copy(&edits->trees[layer], &scene->trees[layer]))
            return false;
    return true;
}

bool csg_edits_remake(struct csgcast_scene *scene, const struct csg_before *before)
{
    struct csgcast_scene next = *scene;
    next.follower = NULL;
    next.is_distributed = false;
    next.objects = NULL;
    next.carriers = NULL;
    next.crowd = NULL;
    next.cells = NULL;
    next.plan = NULL;
    next.sharpness = NULL;
    next.ways = (struct csg_scene_ways){0};
    memset(next.trees, 0, sizeof next.trees);
    next.info = (struct csgcast_scene_info){.num_dropped = scene->edits->num_dropped,
                                            .num_rounded = scene->info.num_rounded};
    if (!copy_trees(&next, scene->edits) || !csg_scene_finish(&next, before)) {
        csg_scene_drop_derived(&next);
        return csg_log_memory(&scene->log);
    }
    if (before)
        csg_cells_store_inherit(next.cells, scene->cells);
    csg_scene_drop_derived(scene);
    *scene = next;
    scene->info.kinds = scene->kinds;
    return true;
}

bool csg_edits_refinish(struct csgcast_scene *scene, const struct csg_shape *const *shapes,
                        const uint32_t *leaves, size_t num, bool regroups)
{
    const struct csg_before before = {.scene = scene,
                                      .changed = scene->edits->patches,
                                      .shapes = shapes,
                                      .leaves = leaves,
                                      .num = num,
                                      .trees = scene->edits->trees};
    const double start = csg_clock_ms();
    if (regroups || !csg_follow(scene, &before))
        return csg_edits_remake(scene, &before);
    scene->csg_ms = csg_clock_ms() - start;
    return true;
}
