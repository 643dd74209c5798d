/* SPDX-License-Identifier: MIT */
#include "carrier/remote.h"

#include <stdatomic.h>
#include <stdlib.h>

#include "carrier/box_tree.h"
#include "carrier/builder.h"
#include "common/parallel.h"
#include "csg/object.h"
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

/* Another leaf, seen from the space of the surface. */
struct other {
    const struct csg_surface *surface; /* its triangles; NULL: it is no surface */
    struct csg_map enter;              /* takes the surface's space to the other's */
    struct csg_box box;                /* all of it, and what lies within reach of it */
    double reach;
};

static struct other other_of(const struct csgcast_scene *scene, const struct csg_map *frame,
                             const struct csg_map *inverse, uint32_t leaf, double reach)
{
    const struct csg_shape *shape = &scene->leaves[leaf].shape;
    const struct csg_map map = csg_map_multiply(inverse, &shape->frame);
    const struct csg_box box = csg_box_map(&map, &shape->bounds);
    struct csg_map back;
    struct other other = {.reach = reach * csg_map_stretch(inverse)};
    other.box = csg_box_grown(&box, other.reach);
    if (shape->surface && csg_map_invert(&shape->frame, &back)) {
        other.surface = shape->surface;
        other.enter = csg_map_multiply(&back, frame);
    }
    return other;
}

/* Whether some triangle of the other one may come near the box. */
static bool comes_near(const struct other *other, const struct csg_box *box)
{
    const struct csg_box around = csg_box_grown(box, other->reach);
    const struct csg_box there = csg_box_map(&other->enter, &around);
    const struct csg_box_node *nodes = other->surface->nodes.data;
    for (size_t i = 0; i < other->surface->nodes.num;) {
        const bool meets = csg_box_overlaps(&nodes[i].box, &there);
        if (meets && nodes[i].num > 0)
            return true;
        i = meets ? i + 1 : nodes[i].end;
    }
    return false;
}

/* Marks the planes of triangles that the other one may meet. */
static bool mark(const struct csg_surface *surface, const struct other *other, uint8_t *near)
{
    const struct csg_box_node *nodes = surface->nodes.data;
    bool is_any = false;
    for (size_t i = 0; i < surface->nodes.num;) {
        if (!csg_box_overlaps(&nodes[i].box, &other->box) ||
            (nodes[i].num && other->surface && !comes_near(other, &nodes[i].box))) {
            i = nodes[i].end;
            continue;
        }
        for (uint32_t j = 0; j < nodes[i].num; j++)
            near[surface->own[surface->triangles.data[nodes[i].first + j].plane].plane] = 1;
        is_any |= nodes[i].num > 0;
        i++;
    }
    return is_any;
}

/* NULL: none, or out of memory. */
static uint8_t *mark_near(struct search *search, uint32_t leaf, double reach,
                          const struct csg_box_tree_list *others)
{
    const struct csg_shape *shape = &search->scene->leaves[leaf].shape;
    const struct csg_surface *surface = shape->surface;
    uint8_t *near = calloc(surface->planes.num + 1, sizeof *near);
    struct csg_map inverse = csg_map_identity;
    bool is_any = false;
    csg_map_invert(&shape->frame, &inverse);
    if (!near)
        atomic_store(&search->is_out_of_memory, true);
    for (size_t i = 0; near && i < others->num; i++) {
        const struct other other =
            other_of(search->scene, &shape->frame, &inverse, others->data[i], reach);
        is_any |= others->data[i] != leaf && mark(surface, &other, near);
    }
    for (uint32_t i = 0; is_any && i < surface->planes.num; i++)
        near[i] = near[surface->own[i].plane];
    if (is_any)
        return near;
    free(near);
    return NULL;
}

/* How far from each other faces may be that coincide. */
static double reach_of(const struct csgcast_scene *scene, double rounding, uint32_t leaf)
{
    const struct csg_box box = scene->leaves[leaf].box;
    const double radius = csg_length(csg_sub(box.hi, box.lo));
    const struct csg_leaf_extent extent = {box.lo, radius, radius,
                                           scene->leaves[leaf].shape.rounding};
    return csg_carrier_tolerance(&extent, rounding);
}

struct csg_box csg_remote_around(const struct csgcast_scene *scene, double rounding, uint32_t leaf)
{
    const struct csg_box own = scene->leaves[leaf].box;
    return csg_box_grown(&own, reach_of(scene, rounding, leaf));
}

/* others: with the surface itself. */
static uint8_t *look_at(struct search *search, uint32_t leaf,
                        const struct csg_box_tree_list *others)
{
    const double reach = reach_of(search->scene, search->rounding, leaf);
    return others->num > 1 ? mark_near(search, leaf, reach, others) : NULL;
}

static void look_at_chunk(void *user, size_t task)
{
    struct search *search = user;
    const size_t end = (task + 1) * CHUNK, num = search->scene->num_leaves;
    struct csg_box_tree_list others = {0};
    for (uint32_t i = (uint32_t)task * CHUNK; i < end && i < num; i++) {
        if (!search->wanted[i] || !search->scene->leaves[i].shape.surface)
            continue;
        const struct csg_box around = csg_remote_around(search->scene, search->rounding, i);
        others.num = 0;
        if (csg_box_tree_find(&search->tree, &around, &others))
            search->remote->near[i] = look_at(search, i, &others);
        else
            atomic_store(&search->is_out_of_memory, true);
    }
    free(others.data);
}

/* One by one, as no tree is planted for a single surface. */
static bool find_others(const struct search *search, uint32_t leaf,
                        struct csg_box_tree_list *others)
{
    const struct csg_box around = csg_remote_around(search->scene, search->rounding, leaf);
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
    *near = ok ? look_at(&search, leaf, &others) : NULL;
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
