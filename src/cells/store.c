/* SPDX-License-Identifier: MIT */
#include "cells/store.h"

#include <pthread.h>
#include <stdlib.h>

#include "cells/kept.h"

/* Frames for which an answer holds, if their area does not change by more than a quarter. */
#define MEMORY 8

struct entry {
    struct csg_cells *cells;
    struct csg_kept *before; /* of the cells before an edit */
    double answer, area; /* of csg_cells_remember */
    int num_left;        /* frames for which that holds */
    double spared;       /* tests, if they had been there */
    bool asked;
};

struct csg_cells_store {
    pthread_mutex_t mutex; /* several renderers may draw one scene */
    struct entry *entries; /* by object */
    size_t num;
};

struct csg_cells_store *csg_cells_store_create(const struct csgcast_scene *scene)
{
    struct csg_cells_store *store = calloc(1, sizeof *store);
    if (!store)
        return NULL;
    store->num = scene->objects->num;
    store->entries = calloc(store->num + 1, sizeof *store->entries);
    if (store->entries && pthread_mutex_init(&store->mutex, NULL) == 0)
        return store;
    free(store->entries);
    free(store);
    return NULL;
}

void csg_cells_store_destroy(struct csg_cells_store *store)
{
    if (!store)
        return;
    for (size_t i = 0; i < store->num; i++) {
        csg_cells_destroy(store->entries[i].cells);
        csg_kept_destroy(store->entries[i].before);
    }
    free(store->entries);
    pthread_mutex_destroy(&store->mutex);
    free(store);
}

void csg_cells_store_inherit(struct csg_cells_store *store, struct csg_cells_store *before)
{
    for (size_t i = 0; i < store->num && i < before->num; i++) {
        struct entry *from = &before->entries[i];
        struct csg_kept **kept = from->cells ? &from->cells->kept : &from->before;
        store->entries[i].before = *kept;
        store->entries[i].answer = from->answer;
        store->entries[i].area = from->area;
        store->entries[i].num_left = from->num_left;
        *kept = NULL;
    }
}

const struct csg_cells *csg_cells_of(const struct csgcast_scene *scene, uint32_t object,
                                     double spared, int num_threads)
{
    struct csg_cells_store *store = scene->cells;
    struct entry *entry = &store->entries[object];
    const struct csg_object *of = &scene->objects->data[object];
    pthread_mutex_lock(&store->mutex);
    entry->spared += spared;
    if (!entry->asked && entry->spared >= csg_cells_cost(scene, of)) {
        entry->asked = true;
        if (csg_cells_can_hold(scene, of))
            entry->cells = csg_cells_create(scene, of, entry->before, num_threads);
        csg_kept_destroy(entry->before);
        entry->before = NULL;
    }
    const struct csg_cells *cells = entry->cells;
    pthread_mutex_unlock(&store->mutex);
    return cells;
}

bool csg_cells_recall(const struct csgcast_scene *scene, uint32_t object, double area,
                      double *spared)
{
    struct csg_cells_store *store = scene->cells;
    struct entry *entry = &store->entries[object];
    pthread_mutex_lock(&store->mutex);
    const bool holds =
        entry->num_left > 0 && area < 1.25 * entry->area && entry->area < 1.25 * area;
    entry->num_left -= holds;
    *spared = entry->answer;
    pthread_mutex_unlock(&store->mutex);
    return holds;
}

void csg_cells_remember(const struct csgcast_scene *scene, uint32_t object, double area,
                        double spared)
{
    struct csg_cells_store *store = scene->cells;
    struct entry *entry = &store->entries[object];
    pthread_mutex_lock(&store->mutex);
    entry->answer = spared;
    entry->area = area;
    entry->num_left = MEMORY - 1;
    pthread_mutex_unlock(&store->mutex);
}
