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

/* A surface in its place. */
struct placed {
    const struct csg_surface *surface;
    const struct csg_map *frame;
    struct csg_map inverse;
    double stretch; /* of the frame */
};

/* Another leaf, seen from the space of the surface. */
struct other {
    const struct csg_surface *surface; /* its triangles; NULL: it is no surface */
    struct csg_map enter;              /* takes the surface's space to the other's */
    struct csg_box box;                /* all of it, and what lies within reach of it */
    double reach;
    /* Of a leaf that has bounds and is no surface, in the world: its shape, how large it is, and how
     * far its faces and the surface's may be from each other where they share a carrier. */
    const struct csg_shape *bounded;
    double radius, distance;
};

/* How far from each other faces may be that coincide. */
static double reach_of(const struct csgcast_scene *scene, double rounding, uint32_t leaf)
{
    const struct csg_box box = scene->leaves[leaf].box;
    const double radius = csg_length(csg_sub(box.hi, box.lo));
    const struct csg_leaf_extent extent = {box.lo, radius, radius,
                                           scene->leaves[leaf].shape.rounding};
    return csg_carrier_tolerance(&extent, rounding);
}

static struct other other_of(const struct search *search, const struct placed *placed,
                             uint32_t leaf, double reach)
{
    const struct csg_leaf *there = &search->scene->leaves[leaf];
    const struct csg_shape *shape = &there->shape;
    const struct csg_map map = csg_map_multiply(&placed->inverse, &shape->frame);
    const struct csg_box box = csg_box_map(&map, &shape->bounds);
    struct csg_map back;
    struct other other = {.reach = reach * csg_map_stretch(&placed->inverse)};
    other.box = csg_box_grown(&box, other.reach);
    if (shape->surface && csg_map_invert(&shape->frame, &back)) {
        other.surface = shape->surface;
        other.enter = csg_map_multiply(&back, placed->frame);
    } else if (!shape->surface && csg_box_is_finite(&there->box)) {
        other.bounded = shape;
        other.radius = 0.5 * csg_length(csg_sub(there->box.hi, there->box.lo));
        other.distance = reach + reach_of(search->scene, search->rounding, leaf);
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

/* A plane of the other leaf. Heights above it are those in the world. */
struct side {
    struct csg_vec3 normal;
    double offset;
};

static struct side side_of(const struct placed *placed, const struct csg_plane *plane)
{
    const struct csg_vec3 middle = csg_map_column(placed->frame, 3);
    return (struct side){csg_map_transposed(placed->frame, plane->normal),
                         plane->offset - csg_dot(plane->normal, middle)};
}

static bool passes_box(const struct side *side, const struct csg_box *box, double distance)
{
    const struct csg_vec3 n = side->normal, half = csg_scale(0.5, csg_sub(box->hi, box->lo));
    const double height = csg_dot(n, csg_box_middle(box)) - side->offset;
    const double reach = fabs(n.x) * half.x + fabs(n.y) * half.y + fabs(n.z) * half.z;
    return fabs(height) - reach <= distance;
}

/*
 * Whether a face on that side of the other leaf may share the triangle's carrier where they meet.
 * Then they are within the distance of each other all over the smaller of them: with r its radius,
 * the sine of the angle between them is at most distance / r. The triangle is at most twice as wide
 * as the radius of its face, so over it heights differ by at most that sine times twice this.
 */
static bool may_share(const struct placed *placed, const struct csg_triangle *triangle,
                      const struct other *other, const struct side *side)
{
    const double radius = placed->surface->extents[triangle->plane].radius * placed->stretch;
    double lo = INFINITY, hi = -INFINITY;
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 point = placed->surface->points.data[triangle->points[i]];
        const double height = csg_dot(side->normal, point) - side->offset;
        lo = csg_least(lo, height);
        hi = csg_most(hi, height);
    }
    return lo <= other->distance && hi >= -other->distance &&
           !((hi - lo) * csg_least(radius, other->radius) > 2 * other->distance * radius);
}

/* Marks the planes of triangles that faces of one side of the other one may coincide with. */
static bool mark_side(const struct placed *placed, const struct other *other,
                      const struct csg_plane *plane, uint8_t *near)
{
    const struct csg_surface *surface = placed->surface;
    const struct csg_box_node *nodes = surface->nodes.data;
    const struct side side = side_of(placed, plane);
    bool is_any = false;
    for (size_t i = 0; i < surface->nodes.num;) {
        if (!csg_box_overlaps(&nodes[i].box, &other->box) ||
            !passes_box(&side, &nodes[i].box, other->distance)) {
            i = nodes[i].end;
            continue;
        }
        for (uint32_t j = 0; j < nodes[i].num; j++) {
            const struct csg_triangle *triangle = &surface->triangles.data[nodes[i].first + j];
            if (!may_share(placed, triangle, other, &side))
                continue;
            near[surface->own[triangle->plane].plane] = 1;
            is_any = true;
        }
        i++;
    }
    return is_any;
}

static bool mark_sides(const struct placed *placed, const struct other *other, uint8_t *near)
{
    bool is_any = false;
    for (uint32_t i = 0; i < other->bounded->num_planes; i++)
        is_any |= mark_side(placed, other, &other->bounded->planes[i], near);
    return is_any;
}

/* Marks the planes of triangles that the other one may meet. */
static bool mark(const struct placed *placed, const struct other *other, uint8_t *near)
{
    const struct csg_surface *surface = placed->surface;
    const struct csg_box_node *nodes = surface->nodes.data;
    bool is_any = false;
    if (other->bounded)
        return mark_sides(placed, other, near);
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
    struct placed placed = {surface, &shape->frame, csg_map_identity, 0};
    uint8_t *near = calloc(surface->planes.num + 1, sizeof *near);
    bool is_any = false;
    csg_map_invert(&shape->frame, &placed.inverse);
    placed.stretch = csg_map_stretch(&shape->frame);
    if (!near)
        atomic_store(&search->is_out_of_memory, true);
    for (size_t i = 0; near && i < others->num; i++) {
        const struct other other = other_of(search, &placed, others->data[i], reach);
        is_any |= others->data[i] != leaf && mark(&placed, &other, near);
    }
    for (uint32_t i = 0; is_any && i < surface->planes.num; i++)
        near[i] = near[surface->own[i].plane];
    if (is_any)
        return near;
    free(near);
    return NULL;
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
