/* SPDX-License-Identifier: MIT */
#include "cells/store.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "cells/kept.h"

/* Frames for which an answer holds, if their area does not change by more than a quarter. */
#define MEMORY 8

struct entry {
    uint32_t object;
    struct csg_cells *cells;
    struct csg_kept *before; /* of the cells before an edit */
    double answer, area;     /* of csg_cells_remember */
    int num_left;            /* frames for which that holds */
    double spared;           /* tests, if they had been there */
    bool asked;
};

/* Most objects are never asked for. */
struct csg_cells_store {
    pthread_mutex_t mutex;           /* several renderers may draw one scene */
    CSG_ARRAY(struct entry) entries; /* in the order of their objects */
    size_t num_objects;
};

struct csg_cells_store *csg_cells_store_create(const struct csgcast_scene *scene)
{
    struct csg_cells_store *store = calloc(1, sizeof *store);
    if (!store)
        return NULL;
    store->num_objects = scene->objects->num;
    if (pthread_mutex_init(&store->mutex, NULL) == 0)
        return store;
    free(store);
    return NULL;
}

void csg_cells_store_destroy(struct csg_cells_store *store)
{
    if (!store)
        return;
    for (size_t i = 0; i < store->entries.num; i++) {
        csg_cells_destroy(store->entries.data[i].cells);
        csg_kept_destroy(store->entries.data[i].before);
    }
    free(store->entries.data);
    pthread_mutex_destroy(&store->mutex);
    free(store);
}

/* Where the object's entry is, or would be. Frames ask for one object after the other. */
static size_t find_place(const struct csg_cells_store *store, uint32_t object)
{
    size_t begin = 0, end = store->entries.num;
    if (end > 0 && store->entries.data[end - 1].object < object)
        return end;
    while (begin < end) {
        const size_t middle = begin + (end - begin) / 2;
        if (store->entries.data[middle].object < object)
            begin = middle + 1;
        else
            end = middle;
    }
    return begin;
}

/* The object's entry, a new one if there is none yet. NULL: out of memory. */
static struct entry *entry_of(struct csg_cells_store *store, uint32_t object)
{
    const size_t at = find_place(store, object), num = store->entries.num;
    if (at < num && store->entries.data[at].object == object)
        return &store->entries.data[at];
    if (!csg_array_reserve(&store->entries, 1))
        return NULL;
    struct entry *entry = &store->entries.data[at];
    memmove(entry + 1, entry, (num - at) * sizeof *entry);
    *entry = (struct entry){.object = object};
    store->entries.num++;
    return entry;
}

void csg_cells_store_inherit(struct csg_cells_store *store, struct csg_cells_store *before)
{
    for (size_t i = 0; i < before->entries.num; i++) {
        struct entry *from = &before->entries.data[i];
        struct entry *to = from->object < store->num_objects ? entry_of(store, from->object) : NULL;
        if (!to)
            continue;
        struct csg_kept **kept = from->cells ? &from->cells->kept : &from->before;
        to->before = *kept;
        to->answer = from->answer;
        to->area = from->area;
        to->num_left = from->num_left;
        *kept = NULL;
    }
}

void csg_cells_store_renew(struct csg_cells_store *store, uint32_t object)
{
    const size_t at = find_place(store, object);
    struct entry *entry = &store->entries.data[at];
    if (at == store->entries.num || entry->object != object)
        return;
    if (entry->cells) {
        entry->before = entry->cells->kept;
        entry->cells->kept = NULL;
        csg_cells_destroy(entry->cells);
    }
    entry->cells = NULL;
    entry->spared = 0;
    entry->asked = false;
}

/* With the store's lock. */
static void make_cells(const struct csgcast_scene *scene, struct entry *entry, int num_threads)
{
    const struct csg_object *of = &scene->objects->data[entry->object];
    if (entry->asked || entry->spared < csg_cells_cost(scene, of))
        return;
    entry->asked = true;
    if (csg_cells_can_hold(scene, of))
        entry->cells = csg_cells_create(scene, of, entry->before, num_threads);
    csg_kept_destroy(entry->before);
    entry->before = NULL;
}

const struct csg_cells *csg_cells_of(const struct csgcast_scene *scene, uint32_t object,
                                     double spared, int num_threads)
{
    struct csg_cells_store *store = scene->cells;
    pthread_mutex_lock(&store->mutex);
    struct entry *entry = entry_of(store, object);
    if (entry) {
        entry->spared += spared;
        make_cells(scene, entry, num_threads);
    }
    const struct csg_cells *cells = entry ? entry->cells : NULL;
    pthread_mutex_unlock(&store->mutex);
    return cells;
}

bool csg_cells_recall(const struct csgcast_scene *scene, uint32_t object, double area,
                      double *spared)
{
    struct csg_cells_store *store = scene->cells;
    bool holds = false;
    pthread_mutex_lock(&store->mutex);
    struct entry *entry = entry_of(store, object);
    if (entry) {
        holds = entry->num_left > 0 && area < 1.25 * entry->area && entry->area < 1.25 * area;
        entry->num_left -= holds;
        *spared = entry->answer;
    }
    pthread_mutex_unlock(&store->mutex);
    return holds;
}

void csg_cells_remember(const struct csgcast_scene *scene, uint32_t object, double area,
                        double spared)
{
    struct csg_cells_store *store = scene->cells;
    pthread_mutex_lock(&store->mutex);
    struct entry *entry = entry_of(store, object);
    if (entry) {
        entry->answer = spared;
        entry->area = area;
        entry->num_left = MEMORY - 1;
    }
    pthread_mutex_unlock(&store->mutex);
}
