/* SPDX-License-Identifier: MIT */
#include "carrier/remote.h"

#include <stdatomic.h>
#include <stdlib.h>

#include "carrier/box_tree.h"
#include "carrier/nearness.h"
#include "common/parallel.h"
#include "mesh/surface.h"

/* Leaves that one thread looks at in a go. */
enum { CHUNK = 64 };

struct search {
    const struct csgcast_scene *scene;
    const bool *wanted;
    double rounding;
    struct csg_box_tree tree;
    struct csg_remote *remote;
    atomic_bool is_out_of_memory;
};

/* others: with the surface itself. NULL: none, or out of memory. */
static uint8_t *mark_near(struct search *search, uint32_t leaf,
                          const struct csg_box_tree_list *others)
{
    if (others->num <= 1)
        return NULL;
    const struct csg_nearness own = csg_nearness_to(search->scene, leaf, search->rounding);
    uint8_t *near = calloc(own.surface->planes.num + 1, sizeof *near);
    bool is_any = false;
    if (!near)
        atomic_store(&search->is_out_of_memory, true);
    for (size_t i = 0; near && i < others->num; i++) {
        const struct csg_neighbour other = csg_neighbour_of(search->scene, others->data[i]);
        is_any |= others->data[i] != leaf && csg_nearness_mark(&own, &other, near);
    }
    if (is_any) {
        csg_nearness_spread(own.surface, near);
        return near;
    }
    free(near);
    return NULL;
}

double csg_remote_rounding(double largest)
{
    int exponent = 0;
    frexp(largest, &exponent);
    return largest > 0 ? ldexp(1, exponent) : 0;
}

static void look_at_chunk(void *user, size_t task)
{
    struct search *search = user;
    const size_t end = (task + 1) * CHUNK, num = search->scene->num_leaves;
    struct csg_box_tree_list others = {0};
    for (uint32_t i = (uint32_t)task * CHUNK; i < end && i < num; i++) {
        if (!search->wanted[i] || !search->scene->leaves[i].shape.surface)
            continue;
        const struct csg_box around = csg_nearness_around(search->scene, i, search->rounding);
        others.num = 0;
        if (csg_box_tree_find(&search->tree, &around, &others))
            search->remote->near[i] = mark_near(search, i, &others);
        else
            atomic_store(&search->is_out_of_memory, true);
    }
    free(others.data);
}

/* One by one, as no tree is planted for a single surface. */
static bool find_others(const struct search *search, uint32_t leaf,
                        struct csg_box_tree_list *others)
{
    const struct csg_box around = csg_nearness_around(search->scene, leaf, search->rounding);
    bool ok = true;
    for (uint32_t i = 0; i < search->scene->num_leaves && ok; i++)
        if (search->wanted[i] && csg_box_overlaps(&search->scene->leaves[i].box, &around))
            ok = csg_array_push(others, i);
    return ok;
}

bool csg_remote_find_one(const struct csgcast_scene *scene, const bool *wanted, double rounding,
                         uint32_t leaf, uint8_t **near)
{
    struct search search = {.scene = scene, .wanted = wanted, .rounding = rounding};
    struct csg_box_tree_list others = {0};
    const bool ok = find_others(&search, leaf, &others);
    *near = ok ? mark_near(&search, leaf, &others) : NULL;
    free(others.data);
    return ok && !search.is_out_of_memory;
}

static bool plant(struct search *search)
{
    const size_t num = search->scene->num_leaves;
    struct csg_box *boxes = malloc((num + 1) * sizeof *boxes);
    for (size_t i = 0; boxes && i < num; i++)
        boxes[i] = search->wanted[i] ? search->scene->leaves[i].box : csg_box_empty;
    const bool ok = boxes && csg_box_tree_init(&search->tree, boxes, num);
    free(boxes);
    return ok;
}

bool csg_remote_find(struct csg_remote *remote, const struct csgcast_scene *scene,
                     const bool *wanted, double rounding)
{
    struct search search = {
        .scene = scene, .wanted = wanted, .rounding = rounding, .remote = remote};
    if (!scene->has_surfaces)
        return true;
    remote->num_leaves = scene->num_leaves;
    remote->rounding = rounding;
    remote->near = calloc(scene->num_leaves + 1, sizeof *remote->near);
    const bool ok = remote->near && plant(&search);
    if (ok)
        csg_parallel(scene->num_threads, (scene->num_leaves + CHUNK - 1) / CHUNK, look_at_chunk,
                     &search);
    csg_box_tree_finish(&search.tree);
    return ok && !search.is_out_of_memory;
}

void csg_remote_finish(struct csg_remote *remote)
{
    for (size_t i = 0; remote->near && i < remote->num_leaves; i++)
        free(remote->near[i]);
    free(remote->near);
    *remote = (struct csg_remote){0};
}
