/* SPDX-License-Identifier: MIT */
#include "cells/cells.h"

#include <stdlib.h>
#include <string.h>

#include "carrier/carrier.h"
#include "carrier/side.h"
#include "cells/build.h"
#include "cells/kept.h"
#include "common/hash.h"
#include "common/parallel.h"

/* The margin as a share of the object's size: far above what floats lose on the way to a cell. */
#define MARGIN 1e-4

/* Parts that are built side by side. */
#define NUM_PARTS 128

/* Branches for each leaf: boxes along the axes are told apart by fewer cuts. What costs rays most
 * is cut first. */
#define BRANCHES_PER_BOX 14
#define BRANCHES_PER_LEAF 28

/* Making one takes as long as so many tests of a solid at a pixel in tiles: up to 30 where holes go
 * through each other, 1 where they do not, as there far fewer branches are enough. */
#define TESTS_PER_BRANCH 16.0

/* For the object, at least and at most. */
#define MIN_BRANCHES 4096
#define MAX_BRANCHES ((size_t)1 << 20)

struct job {
    struct csg_cell_builder top; /* its work is what the parts start from */
    struct csg_cell_builder *parts;
    uint32_t *places;
    struct csg_cell_leaf *leaves;
    double cost; /* of all parts */
    struct csg_kept *before;
    uint64_t *keys;      /* of the parts; NULL: none are kept */
    uint64_t *leaf_keys; /* what they have of the leaves */
    int num_threads;
};

bool csg_cells_can_hold(const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    const uint32_t max_faces = (1 << CSG_CELL_FACE_BITS) - 1;
    if (!csg_box_is_finite(&object->box) || csg_box_is_empty(&object->box))
        return false;
    for (uint32_t i = object->begin; i < object->end; i++) {
        if (nodes[i].op != CSG_LEAF)
            continue;
        const struct csg_shape *shape = &scene->leaves[nodes[i].leaf].shape;
        if (shape->surface || shape->num_planes > max_faces || nodes[i].spare)
            return false;
    }
    return true;
}

static void build_part(void *user, size_t i)
{
    struct job *job = user;
    struct csg_work *work = &job->top.work.data[i];
    struct csg_cell_builder *part = &job->parts[i];
    if (job->keys) {
        job->keys[i] = csg_kept_key(&job->top, work, job->leaf_keys);
        if (csg_kept_take(job->before, job->keys[i], part))
            return;
    }
    part->scene = job->top.scene;
    part->places = job->places;
    part->leaves = job->leaves;
    part->margin = job->top.margin;
    part->bunched = job->top.bunched;
    part->bunches.quadrics = job->top.bunches.quadrics;
    part->max_branches = (size_t)((double)job->top.max_branches * work->cost / job->cost);
    csg_cell_builder_start(part, &work->box, &work->tree, work->depth);
    csg_cell_builder_cut(part, SIZE_MAX);
    csg_cell_builder_close(part);
}

/* Where the leaves' terms will be, in texels: one after the other, as pack/walk.c puts them. NULL:
 * out of memory or of places. */
static uint32_t *find_places(const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    uint32_t *places = malloc((scene->num_leaves + 1) * sizeof *places);
    uint32_t place = 0;
    for (uint32_t i = object->begin; i < object->end && places; i++) {
        if (nodes[i].op != CSG_LEAF)
            continue;
        const struct csg_shape *shape = &scene->leaves[nodes[i].leaf].shape;
        const uint32_t begin = scene->carriers->face_begin[nodes[i].leaf];
        places[nodes[i].leaf] = place;
        place += 1 + scene->carriers->face_begin[nodes[i].leaf + 1] - begin +
                 (shape->has_quadric ? CSG_QUADRIC_TEXELS : 0);
    }
    if (place < CSG_CELLS_MAX_TEXELS)
        return places;
    free(places);
    return NULL;
}

static size_t max_branches(const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    size_t num = 0;
    for (uint32_t i = object->begin; i < object->end; i++)
        if (nodes[i].op == CSG_LEAF)
            num += csg_side_is_box(scene, nodes[i].leaf) ? BRANCHES_PER_BOX : BRANCHES_PER_LEAF;
    return num < MIN_BRANCHES ? MIN_BRANCHES : num > MAX_BRANCHES ? MAX_BRANCHES : num;
}

double csg_cells_cost(const struct csgcast_scene *scene, const struct csg_object *object)
{
    return TESTS_PER_BRANCH * (double)max_branches(scene, object);
}

static bool make_keys(struct job *job, const struct csg_object *object)
{
    const struct csgcast_scene *scene = job->top.scene;
    const struct csg_node *nodes = scene->trees[object->layer].data;
    job->keys = calloc(job->top.work.num + 1, sizeof *job->keys);
    job->leaf_keys = malloc((scene->num_leaves + 1) * sizeof *job->leaf_keys);
    for (uint32_t i = object->begin; i < object->end && job->leaf_keys; i++)
        if (nodes[i].op == CSG_LEAF)
            job->leaf_keys[nodes[i].leaf] = csg_kept_leaf_key(&job->top, nodes[i].leaf);
    return job->keys && job->leaf_keys;
}

static bool build(struct job *job, const struct csgcast_scene *scene,
                  const struct csg_object *object, struct csg_cells *cells)
{
    job->places = find_places(scene, object);
    job->leaves = csg_cell_leaves_create(scene, object);
    job->top.scene = scene;
    job->top.places = job->places;
    job->top.leaves = job->leaves;
    job->top.margin = cells->margin;
    job->top.bunched = cells->bunched =
        csg_bunches_can_hold(scene, object, &job->top.bunches.quadrics);
    struct csg_tree tree = {0};
    const bool has_tree =
        job->places && job->leaves &&
        csg_tree_append(&tree, scene->trees[object->layer].data, object->begin, object->end);
    if (has_tree)
        csg_cell_builder_start(&job->top, &cells->box, &tree, 0);
    free(tree.data);
    if (!has_tree)
        return false;
    job->top.max_branches = max_branches(scene, object);
    csg_cell_builder_cut(&job->top, NUM_PARTS);
    job->parts = calloc(job->top.work.num + 1, sizeof *job->parts);
    if (job->top.failed || !job->parts || (scene->keeps_structure && !make_keys(job, object)))
        return false;
    for (size_t i = 0; i < job->top.work.num; i++) {
        job->top.branches.data[job->top.work.data[i].branch].first = (uint32_t)i;
        job->cost += job->top.work.data[i].cost;
    }
    csg_parallel(job->num_threads, job->top.work.num, build_part, job);
    cells->nested = job->top.nested;
    bool ok = true;
    for (size_t i = 0; i < job->top.work.num; i++) {
        ok &= !job->parts[i].failed;
        cells->nested |= job->parts[i].nested;
    }
    return ok;
}

/* A branch of one of the builders; open ones are the roots of the parts. */
struct place {
    const struct csg_cell_builder *builder;
    uint32_t branch;
};

static const struct csg_branch *follow(const struct job *job, struct place *place)
{
    const struct csg_branch *branch = &place->builder->branches.data[place->branch];
    if (branch->kind != CSG_BRANCH_OPEN)
        return branch;
    *place = (struct place){&job->parts[branch->first], 0};
    return &place->builder->branches.data[0];
}

#define MAX_SLABS 4

/* Cuts along the same axis become one split: its slabs from below, and the places between them. */
struct slabs {
    struct place parts[MAX_SLABS];
    double at[MAX_SLABS - 1];
    int num, axis;
};

static void insert_cut(struct slabs *slabs, int i, struct place part,
                       const struct csg_branch *branch)
{
    for (int j = slabs->num; j > i + 1; j--)
        slabs->parts[j] = slabs->parts[j - 1];
    for (int j = slabs->num - 1; j > i; j--)
        slabs->at[j] = slabs->at[j - 1];
    slabs->parts[i] = (struct place){part.builder, branch->first};
    slabs->parts[i + 1] = (struct place){part.builder, branch->first + 1};
    slabs->at[i] = branch->at;
    slabs->num++;
}

static struct slabs gather_slabs(const struct job *job, struct place root,
                                 const struct csg_branch *branch)
{
    struct slabs slabs = {.num = 1, .axis = branch->kind};
    insert_cut(&slabs, 0, root, branch);
    for (int i = 0; i < slabs.num && slabs.num < MAX_SLABS;) {
        struct place part = slabs.parts[i];
        const struct csg_branch *cut = follow(job, &part);
        if (cut->kind == slabs.axis)
            insert_cut(&slabs, i, part, cut);
        else
            i++;
    }
    return slabs;
}

struct emitter {
    const struct job *job;
    struct csg_cells *cells;
    CSG_ARRAY(struct pending {
        struct place place;
        size_t texel;
        size_t depth;
    })
    pending;
};

static bool add_texels(struct csg_cells *cells, size_t num)
{
    if (cells->texels.num / 4 + num > CSG_CELLS_MAX_TEXELS ||
        !csg_array_reserve(&cells->texels, 4 * num))
        return false;
    memset(cells->texels.data + cells->texels.num, 0, 4 * num * sizeof *cells->texels.data);
    cells->texels.num += 4 * num;
    return true;
}

static bool emit_cell(struct emitter *emitter, const struct pending *pending,
                      const struct csg_branch *branch)
{
    struct csg_cells *cells = emitter->cells;
    const size_t first = cells->texels.num / 4, num = branch->end - branch->first;
    if (!add_texels(cells, num))
        return false;
    const struct csg_cell_builder *builder = pending->place.builder;
    const float *records = builder->bunched ? builder->bunches.texels.data : builder->records.data;
    if (num)
        memcpy(cells->texels.data + 4 * first, records + 4 * (size_t)branch->first,
               4 * num * sizeof *cells->texels.data);
    float *texel = cells->texels.data + 4 * pending->texel;
    texel[0] = (float)first;
    texel[1] = (float)(first + num);
    texel[3] = CSG_BRANCH_CELL;
    return true;
}

static bool emit_split(struct emitter *emitter, const struct pending *pending,
                       const struct csg_branch *branch)
{
    struct csg_cells *cells = emitter->cells;
    const struct slabs slabs = gather_slabs(emitter->job, pending->place, branch);
    const size_t padding = (4 - cells->texels.num / 4 % 4) % 4;
    const size_t first = cells->texels.num / 4 + padding;
    const double lo = csg_vec3_component(cells->box.lo, slabs.axis);
    const double hi = csg_vec3_component(cells->box.hi, slabs.axis);
    if (!add_texels(cells, padding + (size_t)slabs.num))
        return false;
    float *texel = cells->texels.data + 4 * pending->texel;
    for (int i = 0; i < MAX_SLABS - 1; i++)
        texel[i] = i < slabs.num - 1 ? (float)(slabs.at[i] - 0.5 * (lo + hi)) : CSG_CELL_NOWHERE;
    texel[3] = (float)(first + (size_t)slabs.axis);
    const size_t depth = pending->depth + 1;
    cells->depth = depth > cells->depth ? depth : cells->depth;
    for (int i = slabs.num; i-- > 0;)
        if (!csg_array_push(&emitter->pending,
                            ((struct pending){slabs.parts[i], first + (size_t)i, depth})))
            return false;
    return true;
}

/* At most: a texel each, three that fill up to the children of a split, and the records. */
static size_t most_numbers(const struct csg_cell_builder *builder)
{
    return 16 * builder->branches.num + builder->records.num + builder->bunches.texels.num;
}

static bool emit_all(struct emitter *emitter)
{
    const struct job *job = emitter->job;
    const struct pending root = {{&job->top, 0}, 0, 0};
    size_t most = most_numbers(&job->top);
    for (size_t i = 0; i < job->top.work.num; i++)
        most += most_numbers(&job->parts[i]);
    bool ok = csg_array_reserve(&emitter->cells->texels, most) && add_texels(emitter->cells, 1) &&
              csg_array_push(&emitter->pending, root);
    while (ok && emitter->pending.num) {
        struct pending pending = emitter->pending.data[--emitter->pending.num];
        const struct csg_branch *branch = follow(emitter->job, &pending.place);
        ok = branch->kind == CSG_BRANCH_CELL ? emit_cell(emitter, &pending, branch)
                                             : emit_split(emitter, &pending, branch);
    }
    free(emitter->pending.data);
    return ok;
}

/* Two numbers a step, in four lanes, none of which waits for the others. */
static uint64_t hash_texels(const float *texels, size_t num)
{
    uint64_t lanes[4] = {num, 1, 2, 3}, hash = CSG_HASH_START;
    for (size_t i = 0; i < num / 8 * 8; i += 2) {
        uint64_t bits;
        memcpy(&bits, texels + i, sizeof bits);
        lanes[i / 2 % 4] = csg_hash_number(lanes[i / 2 % 4], bits);
    }
    for (size_t i = 0; i < 4; i++)
        hash = csg_hash_number(hash, lanes[i]);
    return csg_hash(hash, texels + num / 8 * 8, num % 8 * sizeof *texels);
}

static void finish_job(struct job *job)
{
    for (size_t i = 0; i < job->top.work.num && job->parts; i++)
        csg_cell_builder_finish(&job->parts[i]);
    free(job->parts);
    free(job->keys);
    free(job->leaf_keys);
    csg_cell_builder_finish(&job->top);
    free(job->places);
    free(job->leaves);
}

struct csg_cells *csg_cells_create(const struct csgcast_scene *scene,
                                   const struct csg_object *object, struct csg_kept *before,
                                   int num_threads)
{
    struct csg_cells *cells = calloc(1, sizeof *cells);
    struct job job = {.before = before, .num_threads = num_threads};
    if (!cells)
        return NULL;
    const double size = csg_length(csg_sub(object->box.hi, object->box.lo));
    const struct csg_vec3 room = csg_vec3(4 * MARGIN * size, 4 * MARGIN * size, 4 * MARGIN * size);
    cells->margin = MARGIN * size;
    cells->box = (struct csg_box){csg_sub(object->box.lo, room), csg_add(object->box.hi, room)};
    struct emitter emitter = {&job, cells, {0}};
    const bool ok = build(&job, scene, object, cells) && emit_all(&emitter);
    if (ok && job.keys) /* without, the next ones are made anew */
        cells->kept = csg_kept_create(job.parts, job.keys, job.top.work.num);
    finish_job(&job);
    cells->hash = hash_texels(cells->texels.data, cells->texels.num);
    if (ok)
        return cells;
    csg_cells_destroy(cells);
    return NULL;
}

void csg_cells_destroy(struct csg_cells *cells)
{
    if (!cells)
        return;
    csg_kept_destroy(cells->kept);
    free(cells->texels.data);
    free(cells);
}
