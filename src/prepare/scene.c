/* SPDX-License-Identifier: MIT */
#include "prepare/scene.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "carrier/edit.h"
#include "cells/store.h"
#include "common/clock.h"
#include "common/parallel.h"
#include "crowd/crowd.h"
#include "csg/object.h"
#include "csg/program.h"
#include "csg/prune.h"
#include "csg/wholes.h"
#include "mesh/surface.h"
#include "prepare/distribute.h"
#include "prepare/follow.h"
#include "prepare/framing.h"
#include "prepare/gather.h"
#include "prepare/surfaces.h"
#include "prepare/ways.h"
#include "sharpness/sharpness.h"

/* Of this process so far. */
static atomic_ulong num_scenes;

struct csgcast_scene *csg_scene_create(const struct csg_log *log, const char *name)
{
    struct csgcast_scene *scene = calloc(1, sizeof *scene);
    const size_t size = strlen(name) + 1;
    char *copy = malloc(size);
    if (!scene || !copy) {
        free(scene);
        free(copy);
        csg_log_memory(log);
        return NULL;
    }
    memcpy(copy, name, size);
    scene->log = *log;
    scene->name = copy;
    scene->number = atomic_fetch_add(&num_scenes, 1) + 1;
    return scene;
}

void csg_scene_drop_derived(struct csgcast_scene *scene)
{
    csg_follower_destroy(scene->follower);
    csg_sharpness_destroy(scene->sharpness);
    free(scene->ways.data);
    csg_cells_store_destroy(scene->cells);
    csg_crowd_destroy(scene->crowd);
    csg_plan_destroy(scene->plan);
    csg_carriers_destroy(scene->carriers);
    if (scene->objects)
        free(scene->objects->data);
    free(scene->objects);
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++)
        free(scene->trees[layer].data);
}

void csg_scene_destroy(struct csgcast_scene *scene)
{
    csg_scene_drop_derived(scene);
    for (size_t i = 0; i < scene->num_leaves; i++)
        csg_shape_finish(&scene->leaves[i].shape);
    free(scene->leaves);
    free(scene->handed_off.data);
    free(scene->wholes.data);
    free(scene->name);
    free(scene);
}

/* A line meets each triangle of a surface once. */
static size_t leaf_crossings(const struct csg_shape *shape)
{
    if (shape->surface)
        return shape->surface->triangles.num;
    return shape->has_quadric && !shape->convex ? 4 : 2;
}

static void count_leaves(struct csgcast_scene *scene, size_t *num_drawn)
{
    size_t counts[CSG_NUM_LEAF_KINDS] = {0};
    struct csgcast_scene_info *info = &scene->info;
    *num_drawn = 0;
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++) {
        const struct csg_tree *tree = &scene->trees[layer];
        for (size_t i = 0; i < tree->num; i++) {
            if (tree->data[i].op != CSG_LEAF)
                continue;
            const struct csg_leaf *leaf = &scene->leaves[tree->data[i].leaf];
            info->num_highlighted += layer == CSG_LAYER_HIGHLIGHT;
            info->num_background += layer == CSG_LAYER_BACKGROUND;
            if (layer == CSG_LAYER_HIGHLIGHT)
                continue; /* drawn a second time, or counted as dropped */
            counts[leaf->kind]++;
            (*num_drawn)++;
            info->num_facetted += leaf->shape.facetted;
            info->num_exact += leaf->shape.has_quadric;
            info->sagitta = fmax(info->sagitta, leaf->shape.sagitta);
            info->num_triangles += leaf->shape.surface ? leaf->shape.surface->triangles.num : 0;
            info->max_crossings += leaf_crossings(&leaf->shape);
        }
    }
    for (size_t kind = 0; kind < CSG_NUM_LEAF_KINDS; kind++)
        if (counts[kind])
            scene->kinds[info->num_kinds++] =
                (struct csgcast_kind_count){csg_kind_name((enum csg_kind)kind), counts[kind]};
    info->kinds = scene->kinds;
}

static bool fill_tree_info(struct csgcast_scene *scene)
{
    struct csgcast_scene_info *info = &scene->info;
    size_t num_drawn;
    bool out_of_memory = false;
    count_leaves(scene, &num_drawn);
    info->num_leaves = num_drawn;
    info->num_dropped += scene->num_leaves > num_drawn ? scene->num_leaves - num_drawn : 0;
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++) {
        const struct csg_tree *tree = &scene->trees[layer];
        info->num_objects += csg_tree_count_operands(tree);
        for (size_t i = 0; i < tree->num; i++)
            info->num_nodes += tree->data[i].op != CSG_LEAF;
    }
    info->depth = csg_tree_depth(&scene->trees[CSG_LAYER_MODEL], &out_of_memory);
    return !out_of_memory;
}

void csg_scene_fill_carrier_info(struct csgcast_scene *scene)
{
    const struct csg_carriers *carriers = scene->carriers;
    scene->info.num_planes = carriers->num_planes - carriers->num_unused_planes + carriers->num_own;
    scene->info.num_quadrics = carriers->num_quadrics - carriers->num_unused_quadrics;
    scene->info.num_shared = scene->carriers->num_shared;
}

static bool add_tree_box(const struct csgcast_scene *scene, const struct csg_tree *tree,
                         struct csg_box *box)
{
    struct csg_boxes room = {0};
    bool ok = true;
    for (uint32_t i = csg_tree_first_operand(tree); i < tree->num && ok; i = tree->data[i].end) {
        struct csg_box own;
        ok = csg_operand_box(scene, tree, i, &room, &own);
        *box = ok ? csg_box_union(box, &own) : *box;
    }
    free(room.data);
    return ok;
}

static bool fill_boxes(struct csgcast_scene *scene)
{
    const struct csg_tree *trees = scene->trees;
    scene->box = csg_box_empty;
    if (!add_tree_box(scene, &trees[CSG_LAYER_MODEL], &scene->box))
        return false;
    scene->drawn = scene->box;
    return add_tree_box(scene, &trees[CSG_LAYER_BACKGROUND], &scene->drawn) &&
           add_tree_box(scene, &trees[CSG_LAYER_HIGHLIGHT], &scene->drawn);
}

/* What the trees say of the scene, whatever of their structure is kept besides. */
static bool fill_from_trees(struct csgcast_scene *scene)
{
    csg_framing_start(scene);
    return fill_boxes(scene) && fill_tree_info(scene);
}

/* Takes what does not show out of the trees; kept, where structure is kept, is the model's before
 * that. */
static bool prune(struct csgcast_scene *scene, struct csg_tree *kept)
{
    bool ok = !scene->keeps_structure || csg_tree_copy(&scene->trees[CSG_LAYER_MODEL], kept);
    for (int layer = 0; layer < CSG_NUM_LAYERS && ok; layer++)
        ok = csg_tree_prune(scene, &scene->trees[layer]);
    return ok;
}

static bool keep_structure(struct csgcast_scene *scene, struct csg_tree *kept)
{
    struct csg_tree *tree = &scene->trees[CSG_LAYER_MODEL];
    const struct csg_tree pruned = *tree;
    const bool ok = csg_tree_keep_structure(scene, kept, &pruned);
    *tree = *kept;
    free(pruned.data);
    return ok && csg_gather_nodes(scene);
}

/* What is subtracted is closed, or it would take away all that is seen through its gaps. */
static bool close_subtracted(struct csgcast_scene *scene, const struct csg_tree *tree)
{
    for (size_t i = 0; i < tree->num; i++) {
        const struct csg_node *node = &tree->data[i];
        struct csg_shape *shape = node->op == CSG_LEAF ? &scene->leaves[node->leaf].shape : NULL;
        if (!shape || !node->negated || !shape->surface || !shape->surface->open)
            continue;
        struct csg_surface *closed = csg_surface_closed(shape->surface);
        if (!closed)
            return false;
        csg_surface_destroy(shape->surface);
        shape->surface = closed;
    }
    return true;
}

static bool build_surfaces(struct csgcast_scene *scene)
{
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++)
        if (!close_subtracted(scene, &scene->trees[layer]))
            return false;
    return csg_surfaces_build(scene);
}

/* Leaves that one core looks at, at a time. */
enum { CHUNK = 4096 };

void csg_leaf_fill_box(struct csg_leaf *leaf)
{
    leaf->box =
        leaf->is_empty ? csg_box_empty : csg_box_map(&leaf->shape.frame, &leaf->shape.bounds);
}

static void fill_boxes_of_leaves(void *user, size_t chunk)
{
    struct csgcast_scene *scene = user;
    for (size_t i = CHUNK * chunk; i < CHUNK * (chunk + 1) && i < scene->num_leaves; i++)
        csg_leaf_fill_box(&scene->leaves[i]);
}

/* Everything that follows asks for them, again and again. */
static void fill_leaf_boxes(struct csgcast_scene *scene, const struct csg_before *before)
{
    for (size_t i = 0; before && i < before->num; i++)
        csg_leaf_fill_box(&scene->leaves[before->leaves[i]]);
    if (before)
        return;
    csg_parallel(scene->num_threads, (scene->num_leaves + CHUNK - 1) / CHUNK, fill_boxes_of_leaves,
                 scene);
}

static bool finish(struct csgcast_scene *scene, const struct csg_before *before)
{
    fill_leaf_boxes(scene, before);
    csg_sort_wholes(scene);
    struct csg_tree kept = {0};
    bool ok = true;
    for (int layer = 0; layer < CSG_NUM_LAYERS && ok && !before; layer++)
        ok = csg_tree_simplify(&scene->trees[layer], NULL);
    ok = ok && prune(scene, &kept) && csg_gather_nodes(scene) && fill_from_trees(scene) &&
         csg_ways_fill(scene);
    if (ok && scene->keeps_structure)
        ok = keep_structure(scene, &kept);
    else
        free(kept.data);
    if (!ok || !build_surfaces(scene))
        return false;
    scene->objects = calloc(1, sizeof *scene->objects);
    if (!scene->objects || !csg_objects_split(scene, scene->objects))
        return false;
    scene->carriers = before ? csg_carriers_edit(scene, before) : csg_carriers_create(scene, false);
    if (!scene->carriers || !csg_framing_finish(scene) || !csg_distribute(scene))
        return false;
    scene->plan = csg_plan_create(scene);
    scene->sharpness = csg_sharpness_create(scene, before);
    if (!scene->sharpness || !scene->plan)
        return false;
    scene->crowd = csg_crowd_create(scene);
    scene->cells = csg_cells_store_create(scene);
    if (!scene->crowd || !scene->cells)
        return false;
    csg_scene_fill_carrier_info(scene);
    return true;
}

bool csg_scene_finish(struct csgcast_scene *scene, const struct csg_before *before)
{
    const double start = csg_clock_ms();
    const bool ok = finish(scene, before) || csg_log_memory(&scene->log);
    scene->csg_ms = csg_clock_ms() - start;
    return ok;
}

void csgcast_scene_get_info(const struct csgcast_scene *scene, struct csgcast_scene_info *info)
{
    *info = scene ? scene->info : (struct csgcast_scene_info){0};
}

bool csgcast_scene_get_bounds(const struct csgcast_scene *scene, double lo[3], double hi[3])
{
    const struct csg_box *box = scene ? &scene->box : &csg_box_empty;
    if (csg_box_is_empty(box))
        return false;
    lo[0] = box->lo.x, lo[1] = box->lo.y, lo[2] = box->lo.z;
    hi[0] = box->hi.x, hi[1] = box->hi.y, hi[2] = box->hi.z;
    return true;
}
