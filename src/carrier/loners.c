/* SPDX-License-Identifier: MIT */
#include "carrier/loners.h"

#include <stdatomic.h>
#include <stdlib.h>

#include "carrier/builder.h"
#include "carrier/own_faces.h"
#include "common/parallel.h"
#include "common/prefetch.h"

/* Scenes of fewer faces are through before threads have started. */
enum { MIN_FACES = 20000, NUM_TASKS = 32 };

/* Two bits for each of so many places a face: a key's place is another one's by chance, too. Fewer
 * where that would take more memory than what they spare. */
enum { PLACES_A_FACE = 64, PLACES_A_WORD = 16, MAX_PLACES = 1 << 28 };

/* Faces whose places are on their way from memory at a time. */
enum { BATCH = 16 };

/* Planes a cell, were all of them parallel and spread evenly: beyond it hardly any is alone. */
#define MAX_DENSITY 3.0

struct search {
    const struct csgcast_scene *scene;
    const struct csg_carrier_builder *builder;
    struct csg_loners *loners;
    struct csg_directions *directions; /* by task; the first one's are all of them in the end */
    atomic_uint *words; /* of a place: whether a key has come there, and whether a second one has */
    uint64_t mask;      /* of places; their number is a power of two */
    bool is_dense;      /* planes of one normal are not looked at */
};

/* Planes of one leaf. */
struct planes {
    const struct csg_surface *surface; /* NULL: the planes are in data */
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
    *plane =
        planes->surface ? csg_own_plane(planes->surface, i, &planes->inverse) : planes->data[i];
    return true;
}

/* ---- directions --------------------------------------------------------------------------- */

static void note_leaf(struct search *search, uint32_t leaf, size_t task)
{
    const struct planes planes = planes_of(search, leaf);
    struct csg_plane plane;
    for (uint32_t i = 0; i < planes.num; i++)
        if (plane_at(&planes, i, &plane))
            csg_directions_add(&search->directions[task], plane.normal);
}

static void note_task(void *user, size_t task)
{
    struct search *search = user;
    const size_t num = search->scene->num_leaves;
    for (size_t i = num * task / NUM_TASKS; i < num * (task + 1) / NUM_TASKS; i++)
        if (search->builder->wanted[i])
            note_leaf(search, (uint32_t)i, task);
}

/* ---- keys --------------------------------------------------------------------------------- */

static uint64_t place_of(const struct search *search, uint64_t key)
{
    return key >> 8 & search->mask;
}

/* The keys of one face, as the index has them: those of its own cells, and those of the cells that
 * are looked at besides. */
struct keys {
    uint64_t own[CSG_MAX_WIDTHS], beside[8 * CSG_MAX_WIDTHS];
    int num_own, num_beside;
};

/* A face whose own keys meet by chance is none: that only costs time. */
static void enter(const struct search *search, const struct keys *keys)
{
    for (int i = 0; i < keys->num_own; i++) {
        const uint64_t place = place_of(search, keys->own[i]);
        const unsigned first = 1u << 2 * (place % PLACES_A_WORD);
        atomic_uint *word = &search->words[place / PLACES_A_WORD];
        if (atomic_fetch_or_explicit(word, first, memory_order_relaxed) & first)
            atomic_fetch_or_explicit(word, first << 1, memory_order_relaxed);
    }
}

/* Whether so many keys, 1 or 2, or more have come to the place of a key. */
static bool has_come(const struct search *search, uint64_t key, unsigned num)
{
    const uint64_t place = place_of(search, key);
    const unsigned word =
        atomic_load_explicit(&search->words[place / PLACES_A_WORD], memory_order_relaxed);
    return word >> 2 * (place % PLACES_A_WORD) & num;
}

static bool is_alone(const struct search *search, const struct keys *keys)
{
    for (int i = 0; i < keys->num_own; i++)
        if (has_come(search, keys->own[i], 2))
            return false;
    for (int i = 0; i < keys->num_beside; i++)
        if (has_come(search, keys->beside[i], 1))
            return false;
    return keys->num_own > 0;
}

/* Faces of a task that wait. */
struct batch {
    const struct search *search;
    size_t num;
    struct {
        uint8_t *alone; /* gets whether it is; NULL: its own keys are entered */
        struct keys keys;
    } faces[BATCH];
};

static void flush(struct batch *batch)
{
    for (size_t i = 0; i < batch->num; i++) {
        const struct keys *keys = &batch->faces[i].keys;
        if (batch->faces[i].alone)
            *batch->faces[i].alone = is_alone(batch->search, keys);
        else
            enter(batch->search, keys);
    }
    batch->num = 0;
}

static void fetch(const struct search *search, const uint64_t *keys, int num)
{
    for (int i = 0; i < num; i++)
        csg_prefetch(&search->words[place_of(search, keys[i]) / PLACES_A_WORD]);
}

/* The keys are in the batch already. */
static void add_face(struct batch *batch, uint8_t *alone)
{
    const struct keys *keys = &batch->faces[batch->num].keys;
    batch->faces[batch->num].alone = alone;
    fetch(batch->search, keys->own, keys->num_own);
    fetch(batch->search, keys->beside, keys->num_beside);
    if (++batch->num == BATCH)
        flush(batch);
}

/* Keys around a face, of which the first is its own cell's. */
static void take_keys(struct keys *keys, const uint64_t around[8], int num)
{
    keys->own[keys->num_own++] = around[0];
    for (int i = 1; i < num; i++)
        keys->beside[keys->num_beside++] = around[i];
}

/* A plane is looked for under other normals where these nearly agree: so are then those that it may
 * coincide with. In which width depends on the other face, too; what is alone in one is alone in
 * narrower ones. judged: with the cells beside its own. */
static void find_plane_keys(const struct search *search, const struct csg_plane *plane, bool judged,
                            struct keys *keys)
{
    const struct csg_carrier_space *space = &search->builder->index.space;
    uint64_t around[8];
    keys->num_own = keys->num_beside = 0;
    if (!csg_directions_are_shared(search->directions, plane->normal)) {
        if (!search->is_dense)
            take_keys(keys, around, csg_parallel_keys(space, plane, around));
        return;
    }
    for (int i = 0; i < space->num_widths; i++) {
        if (i > 0 && csg_carrier_has_spread(&space->widths[i - 1], &space->widths[i].spread))
            continue;
        if (judged)
            take_keys(keys, around, csg_normal_keys(space, i, plane, around));
        else
            keys->own[keys->num_own++] = csg_normal_key(space, i, plane);
    }
}

static void find_quadric_keys(const struct search *search, const struct csg_quadric *quadric,
                              struct keys *keys)
{
    uint64_t around[8];
    keys->num_own = keys->num_beside = 0;
    take_keys(keys, around,
              csg_quadric_keys(&search->builder->index.space, quadric, around, (uint16_t[3]){0}));
}

/* Enters a leaf's keys, or with judged asks whether its faces are alone. */
static void add_leaf(struct batch *batch, uint32_t leaf, bool judged)
{
    const struct search *search = batch->search;
    const struct csg_shape *shape = &search->scene->leaves[leaf].shape;
    const struct planes planes = planes_of(search, leaf);
    uint8_t *faces = search->loners->planes + search->builder->carriers->face_begin[leaf];
    struct csg_plane plane;
    for (uint32_t i = 0; i < planes.num; i++)
        if (plane_at(&planes, i, &plane)) {
            find_plane_keys(search, &plane, judged, &batch->faces[batch->num].keys);
            add_face(batch, judged ? &faces[i] : NULL);
        }
    if (!shape->has_quadric)
        return;
    find_quadric_keys(search, &shape->quadric, &batch->faces[batch->num].keys);
    add_face(batch, judged ? &search->loners->quadrics[leaf] : NULL);
}

static void add_leaves(struct search *search, size_t task, bool judged)
{
    const size_t num = search->scene->num_leaves;
    struct batch batch = {.search = search};
    for (size_t i = num * task / NUM_TASKS; i < num * (task + 1) / NUM_TASKS; i++)
        if (search->builder->wanted[i])
            add_leaf(&batch, (uint32_t)i, judged);
    flush(&batch);
}

static void enter_task(void *user, size_t task)
{
    add_leaves(user, task, false);
}

static void judge_task(void *user, size_t task)
{
    add_leaves(user, task, true);
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
    const struct csg_carrier_space *space = &builder->index.space;
    const size_t num_planes = builder->carriers->face_begin[scene->num_leaves];
    const size_t num_faces = num_planes + scene->num_leaves;
    struct search search = {
        .scene = scene, .builder = builder, .loners = loners, .mask = PLACES_A_WORD - 1};
    search.is_dense = (double)num_planes * space->fine > MAX_DENSITY * space->radius;
    if (num_faces < MIN_FACES)
        return true;
    while (search.mask < PLACES_A_FACE * num_faces && search.mask < MAX_PLACES - 1)
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
