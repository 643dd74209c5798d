/* SPDX-License-Identifier: MIT */
#include "csg/loners.h"

#include <stdatomic.h>
#include <stdlib.h>

#include "common/parallel.h"
#include "csg/carrier_builder.h"
#include "csg/own_faces.h"

/* Scenes of fewer faces are through before threads have started. */
enum { MIN_FACES = 20000, NUM_TASKS = 32 };

/* Two bits for each of so many places a face: a key's place is another one's by chance, too. */
enum { PLACES_A_FACE = 16, PLACES_A_WORD = 16 };

/* Planes a cell, were all of them parallel and spread evenly: beyond it hardly any is alone. */
#define MAX_DENSITY 3.0

struct search {
    const struct csgcast_scene *scene;
    const struct csg_carrier_builder *builder;
    struct csg_loners *loners;
    struct csg_directions *directions; /* by task; the first one's are all of them in the end */
    atomic_uint *words; /* of a place: whether a key has come there, and whether a second one has */
    uint64_t mask;      /* of places; their number is a power of two */
    bool is_dense;      /* planes are not looked at */
};

/* Planes of one leaf. */
struct planes {
    const struct csg_surface *surface; /* NULL: data are they */
    const uint8_t *near;
    struct csg_map inverse;
    const struct csg_plane *data;
    size_t num;
};

static struct planes planes_of(const struct search *search, uint32_t leaf)
{
    const struct csg_shape *shape = &search->scene->leaves[leaf].shape;
    struct planes planes = {.data = shape->planes, .num = shape->num_planes};
    if (!shape->surface)
        return planes;
    planes.near = search->builder->remote.near[leaf];
    planes.surface = shape->surface;
    planes.num = planes.near ? shape->surface->planes.num : 0;
    planes.inverse = csg_map_identity;
    csg_map_invert(&shape->frame, &planes.inverse);
    return planes;
}

/* false: a remote face of a surface. */
static bool plane_at(const struct planes *planes, uint32_t i, struct csg_plane *plane)
{
    if (planes->surface && !planes->near[i])
        return false;
    *plane = planes->surface ? csg_own_plane(planes->surface, i, &planes->inverse)
                             : planes->data[i];
    return true;
}

typedef void visit_fn(struct search *search, uint32_t leaf, size_t task);

/* The leaves of one task. */
static void visit_leaves(struct search *search, size_t task, visit_fn *visit)
{
    const size_t num = search->scene->num_leaves;
    for (size_t i = num * task / NUM_TASKS; i < num * (task + 1) / NUM_TASKS; i++)
        if (search->builder->wanted[i])
            visit(search, (uint32_t)i, task);
}

/* ---- directions --------------------------------------------------------------------------- */

static void note_leaf(struct search *search, uint32_t leaf, size_t task)
{
    const struct planes planes = planes_of(search, leaf);
    struct csg_plane plane;
    for (uint32_t i = 0; i < planes.num; i++)
        if (plane_at(&planes, i, &plane))
            csg_directions_add(&search->directions[task], &plane);
}

static void note_task(void *user, size_t task)
{
    visit_leaves(user, task, note_leaf);
}

/* ---- keys --------------------------------------------------------------------------------- */

/* A face whose own keys meet by chance is none: that only costs time. */
static void enter(struct search *search, const uint64_t *keys, int num)
{
    for (int i = 0; i < num; i++) {
        const uint64_t place = keys[i] >> 8 & search->mask;
        const unsigned first = 1u << 2 * (place % PLACES_A_WORD);
        atomic_uint *word = &search->words[place / PLACES_A_WORD];
        if (atomic_fetch_or_explicit(word, first, memory_order_relaxed) & first)
            atomic_fetch_or_explicit(word, first << 1, memory_order_relaxed);
    }
}

static bool is_alone(const struct search *search, const uint64_t *keys, int num)
{
    for (int i = 0; i < num; i++) {
        const uint64_t place = keys[i] >> 8 & search->mask;
        const unsigned second = 2u << 2 * (place % PLACES_A_WORD);
        if (atomic_load_explicit(&search->words[place / PLACES_A_WORD], memory_order_relaxed) &
            second)
            return false;
    }
    return num > 0;
}

/* None for a plane that is looked for under other normals, too: it is no loner. */
static int plane_keys(const struct search *search, const struct csg_plane *plane, uint64_t keys[8])
{
    if (search->is_dense || csg_directions_are_shared(search->directions, plane))
        return 0;
    return csg_index_plane_keys(&search->builder->index, plane, keys);
}

static void enter_leaf(struct search *search, uint32_t leaf, size_t task)
{
    const struct csg_shape *shape = &search->scene->leaves[leaf].shape;
    const struct planes planes = planes_of(search, leaf);
    struct csg_plane plane;
    uint64_t keys[8];
    (void)task;
    for (uint32_t i = 0; i < planes.num; i++)
        if (plane_at(&planes, i, &plane))
            enter(search, keys, plane_keys(search, &plane, keys));
    if (shape->has_quadric)
        enter(search, keys,
              csg_index_quadric_keys(&search->builder->index, &shape->quadric, keys));
}

static void enter_task(void *user, size_t task)
{
    visit_leaves(user, task, enter_leaf);
}

static void judge_leaf(struct search *search, uint32_t leaf, size_t task)
{
    const struct csg_shape *shape = &search->scene->leaves[leaf].shape;
    const struct planes planes = planes_of(search, leaf);
    uint8_t *faces = search->loners->planes + search->builder->carriers->face_begin[leaf];
    struct csg_plane plane;
    uint64_t keys[8];
    (void)task;
    for (uint32_t i = 0; i < planes.num; i++)
        faces[i] = plane_at(&planes, i, &plane) &&
                   is_alone(search, keys, plane_keys(search, &plane, keys));
    if (shape->has_quadric)
        search->loners->quadrics[leaf] =
            is_alone(search, keys,
                     csg_index_quadric_keys(&search->builder->index, &shape->quadric, keys));
}

static void judge_task(void *user, size_t task)
{
    visit_leaves(user, task, judge_leaf);
}

/* ---- all ---------------------------------------------------------------------------------- */

static void run(struct search *search, csg_task_fn *task)
{
    csg_parallel(search->scene->num_threads, NUM_TASKS, task, search);
}

static void find(struct search *search)
{
    run(search, note_task);
    for (size_t i = 1; i < NUM_TASKS; i++)
        csg_directions_merge(&search->directions[0], &search->directions[i]);
    run(search, enter_task);
    run(search, judge_task);
}

bool csg_loners_find(struct csg_loners *loners, const struct csg_carrier_builder *builder)
{
    const struct csgcast_scene *scene = builder->scene;
    const struct csg_carrier_index *index = &builder->index;
    const size_t num_planes = builder->carriers->face_begin[scene->num_leaves];
    const size_t num_faces = num_planes + scene->num_leaves;
    struct search search = {
        .scene = scene, .builder = builder, .loners = loners, .mask = PLACES_A_WORD - 1};
    search.is_dense = (double)num_planes * index->fine > MAX_DENSITY * index->radius;
    if (num_faces < MIN_FACES)
        return true;
    while (search.mask < PLACES_A_FACE * num_faces)
        search.mask = 2 * search.mask + 1;
    loners->planes = calloc(num_planes + 1, 1);
    loners->quadrics = calloc(scene->num_leaves + 1, 1);
    search.directions = calloc(NUM_TASKS, sizeof *search.directions);
    search.words = calloc((search.mask + 1) / PLACES_A_WORD, sizeof *search.words);
    const bool ok = loners->planes && loners->quadrics && search.directions && search.words;
    if (ok)
        find(&search);
    free(search.directions);
    free(search.words);
    return ok;
}

void csg_loners_finish(struct csg_loners *loners)
{
    free(loners->planes);
    free(loners->quadrics);
    *loners = (struct csg_loners){0};
}
