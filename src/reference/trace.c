/* SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "csg/object.h"
#include "reference/bounds.h"
#include "reference/crossings.h"

/* One operand's crossings: a run of the pool. */
struct list {
    size_t begin;
    bool inside; /* at -inf */
};

/* A crossing on its way up, with the operand it comes from. */
struct event {
    struct csg_crossing crossing;
    uint32_t operand;
};

/* A node that the ray asks, or a subtree that it misses. */
struct visit {
    uint32_t node;
    bool is_missed;
    size_t num; /* children that are visited, too */
};

struct csg_ray_scratch {
    const struct csg_tree_bounds *bounds; /* may be NULL */
    CSG_ARRAY(struct visit) visits;
    CSG_ARRAY(uint32_t) nodes;      /* to visit, the next one last */
    struct csg_box_tree_list found; /* children of a node */
    CSG_ARRAY(struct csg_crossing) pool;
    CSG_ARRAY(struct list) lists; /* of the operands that wait for their node */
    CSG_ARRAY(struct event) events;
    CSG_ARRAY(bool) inside; /* per operand */
    struct csg_surface_crossings surface;
};

struct csg_ray_scratch *csg_ray_scratch_create(const struct csg_tree_bounds *bounds)
{
    struct csg_ray_scratch *scratch = calloc(1, sizeof *scratch);
    if (scratch)
        scratch->bounds = bounds;
    return scratch;
}

void csg_ray_scratch_destroy(struct csg_ray_scratch *scratch)
{
    if (!scratch)
        return;
    free(scratch->visits.data);
    free(scratch->nodes.data);
    free(scratch->found.data);
    free(scratch->pool.data);
    free(scratch->lists.data);
    free(scratch->events.data);
    free(scratch->inside.data);
    free(scratch->surface.data);
    free(scratch->surface.meetings.data);
    free(scratch);
}

/* Inside is where the surface's turns so far do not cancel. Behind a gap in it they never do. */
static bool push_surface(struct csg_ray_scratch *scratch, const struct csgcast_scene *scene,
                         const struct csg_node *node, const struct csg_ray *ray)
{
    const struct list list = {scratch->pool.num, node->negated};
    struct csg_surface_crossings *surface = &scratch->surface;
    int turns = 0;
    bool inside = false;
    if (!csg_cross_surface(scene, node->leaf, ray, surface))
        return false;
    for (size_t i = 0, j; i < surface->num; i = j) {
        for (j = i; j < surface->num && surface->data[j].t == surface->data[i].t; j++)
            turns += surface->data[j].turns;
        if ((turns != 0) == inside)
            continue;
        inside = !inside;
        const struct csg_crossing crossing = {surface->data[i].t, node->leaf, node->negated};
        if (!csg_array_push(&scratch->pool, crossing))
            return false;
    }
    return csg_array_push(&scratch->lists, list);
}

static bool push_leaf(struct csg_ray_scratch *scratch, const struct csgcast_scene *scene,
                      const struct csg_node *node, const struct csg_ray *ray)
{
    struct csg_leaf_crossings leaf = {.num = 0};
    if (scene->leaves[node->leaf].shape.surface && !node->spare)
        return push_surface(scratch, scene, node, ray);
    if (!node->spare)
        leaf = csg_cross_leaf(scene, node->leaf, ray);
    const struct list list = {scratch->pool.num, leaf.inside != node->negated};
    for (int i = 0; i < leaf.num; i++) {
        const struct csg_crossing crossing = {leaf.t[i], node->leaf, node->negated};
        if (!csg_array_push(&scratch->pool, crossing))
            return false;
    }
    return csg_array_push(&scratch->lists, list);
}

static int compare_events(const void *a, const void *b)
{
    const struct event *x = a, *y = b;
    return x->crossing.t < y->crossing.t ? -1 : x->crossing.t > y->crossing.t;
}

/* Takes the last num lists off the stack as events in order of t. */
static bool gather(struct csg_ray_scratch *scratch, size_t num, size_t *num_inside)
{
    const size_t first = scratch->lists.num - num;
    size_t end = scratch->pool.num;
    scratch->events.num = scratch->inside.num = 0;
    *num_inside = 0;
    if (!csg_array_reserve(&scratch->inside, num))
        return false;
    for (size_t i = num; i-- > 0;) {
        const struct list *list = &scratch->lists.data[first + i];
        scratch->inside.data[i] = list->inside;
        *num_inside += list->inside;
        for (size_t j = list->begin; j < end; j++)
            if (!csg_array_push(&scratch->events,
                                ((struct event){scratch->pool.data[j], (uint32_t)i})))
                return false;
        end = list->begin;
    }
    scratch->pool.num = end;
    scratch->lists.num = first;
    if (scratch->events.num > 1)
        qsort(scratch->events.data, scratch->events.num, sizeof *scratch->events.data,
              compare_events);
    return true;
}

static bool precedes(const struct csg_crossing *a, const struct csg_crossing *b)
{
    return a->cut != b->cut ? b->cut : a->leaf < b->leaf;
}

/* Toggles the operands of the events at one t; the best of those that turn to `towards`. */
static const struct csg_crossing *pass_batch(struct csg_ray_scratch *scratch, size_t begin,
                                             size_t end, bool towards, size_t *num_inside)
{
    const struct csg_crossing *best = NULL;
    for (size_t i = begin; i < end; i++) {
        const struct event *event = &scratch->events.data[i];
        bool *inside = &scratch->inside.data[event->operand];
        *inside = !*inside;
        *num_inside += *inside ? 1 : (size_t)-1;
        if (*inside == towards && (!best || precedes(&event->crossing, best)))
            best = &event->crossing;
    }
    return best;
}

/* Replaces the lists of a node's num operands by the node's own. */
static bool merge(struct csg_ray_scratch *scratch, bool all, size_t num)
{
    size_t num_inside;
    if (!gather(scratch, num, &num_inside))
        return false;
    const size_t needed = all ? num : 1;
    bool inside = num_inside >= needed;
    const struct list list = {scratch->pool.num, inside};
    for (size_t i = 0; i < scratch->events.num;) {
        size_t end = i + 1;
        while (end < scratch->events.num &&
               scratch->events.data[end].crossing.t == scratch->events.data[i].crossing.t)
            end++;
        const struct csg_crossing *best = pass_batch(scratch, i, end, !inside, &num_inside);
        if ((num_inside >= needed) != inside) {
            inside = !inside;
            if (!csg_array_push(&scratch->pool, *best))
                return false;
        }
        i = end;
    }
    return csg_array_push(&scratch->lists, list);
}

/* A ray, prepared for boxes. */
struct slab_ray {
    double org[3], inverse[3];
    double from; /* what of it counts; -INFINITY: the whole line */
};

static struct slab_ray slab_ray(const struct csg_ray *ray, double from)
{
    return (struct slab_ray){{ray->org.x, ray->org.y, ray->org.z},
                             {1 / ray->dir.x, 1 / ray->dir.y, 1 / ray->dir.z},
                             from};
}

/* Widened a little: rounding here must not lose a grazing hit. */
static bool meets_box(const struct csg_box *box, const void *what)
{
    const struct slab_ray *ray = what;
    const double lo[3] = {box->lo.x, box->lo.y, box->lo.z},
                 hi[3] = {box->hi.x, box->hi.y, box->hi.z};
    double tnear = ray->from, tfar = INFINITY;
    for (int i = 0; i < 3; i++) {
        const double margin = 1e-9 * (fabs(lo[i]) + fabs(hi[i]) + fabs(ray->org[i]));
        const double a = (lo[i] - margin - ray->org[i]) * ray->inverse[i],
                     b = (hi[i] + margin - ray->org[i]) * ray->inverse[i];
        if (isinf(ray->inverse[i]) || isnan(a) || isnan(b))
            continue;
        tnear = csg_most(tnear, csg_least(a, b));
        tfar = csg_least(tfar, csg_most(a, b));
    }
    return tnear <= tfar * (tfar > 0 ? 1 + 1e-12 : 1 - 1e-12);
}

static int compare_descending(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return x > y ? -1 : x < y;
}

/* All children, the first one last. */
static bool push_children(struct csg_ray_scratch *scratch, const struct csg_node *nodes,
                          uint32_t node)
{
    const size_t first = scratch->nodes.num;
    bool ok = true;
    for (uint32_t child = node + 1; child < nodes[node].end && ok; child = nodes[child].end)
        ok = csg_array_push(&scratch->nodes, child);
    for (size_t i = first, j = scratch->nodes.num; ok && i + 1 < j; i++) {
        const uint32_t child = scratch->nodes.data[--j];
        scratch->nodes.data[j] = scratch->nodes.data[i];
        scratch->nodes.data[i] = child;
    }
    return ok;
}

/* The same of a crowd, without those that the line misses and that do not matter then. */
static bool push_crowd(struct csg_ray_scratch *scratch, const struct csg_child_crowd *crowd,
                       const struct slab_ray *line)
{
    struct csg_box_tree_list *found = &scratch->found;
    const size_t first = scratch->nodes.num;
    found->num = 0;
    bool ok = csg_box_tree_visit(&crowd->tree, meets_box, line, found);
    for (size_t i = 0; i < found->num && ok; i++)
        ok = csg_array_push(&scratch->nodes, crowd->children[found->data[i]]);
    for (size_t i = 0; i < crowd->num_others && ok; i++)
        ok = csg_array_push(&scratch->nodes, crowd->children[crowd->num + i]);
    const size_t num = scratch->nodes.num - first;
    if (ok && num > 1)
        qsort(scratch->nodes.data + first, num, sizeof *scratch->nodes.data, compare_descending);
    return ok;
}

/* The nodes that the line of the ray meets, in their order, each before what is below it. */
static bool find_visits(const struct csg_object *object, const struct csg_node *nodes,
                        const struct csg_ray *ray, struct csg_ray_scratch *scratch)
{
    const struct csg_tree_bounds *all = scratch->bounds;
    const struct csg_node_bounds *bounds = all ? all->nodes[object->layer] : NULL;
    const struct slab_ray line = slab_ray(ray, -INFINITY);
    scratch->visits.num = scratch->nodes.num = 0;
    bool ok = object->begin == object->end || csg_array_push(&scratch->nodes, object->begin);
    while (scratch->nodes.num > 0 && ok) {
        const uint32_t i = scratch->nodes.data[--scratch->nodes.num];
        const size_t num = scratch->nodes.num;
        const struct csg_box *box = bounds ? &bounds[i].box : NULL;
        const bool is_missed = box && (csg_box_is_empty(box) || !meets_box(box, &line));
        if (!is_missed && nodes[i].op != CSG_LEAF)
            ok = bounds && bounds[i].crowd
                     ? push_crowd(scratch, &all->crowds.data[bounds[i].crowd - 1], &line)
                     : push_children(scratch, nodes, i);
        ok = ok && csg_array_push(&scratch->visits,
                                  ((struct visit){i, is_missed, scratch->nodes.num - num}));
    }
    return ok;
}

static bool push_missed(struct csg_ray_scratch *scratch, uint8_t layer, uint32_t node)
{
    const struct list list = {scratch->pool.num, scratch->bounds->nodes[layer][node].inside};
    return csg_array_push(&scratch->lists, list);
}

static bool evaluate(const struct csgcast_scene *scene, const struct csg_object *object,
                     const struct csg_ray *ray, struct csg_ray_scratch *scratch)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    bool ok = find_visits(object, nodes, ray, scratch);
    scratch->pool.num = scratch->lists.num = 0;
    for (size_t i = scratch->visits.num; ok && i-- > 0;) {
        const struct visit visit = scratch->visits.data[i];
        if (visit.is_missed)
            ok = push_missed(scratch, object->layer, visit.node);
        else if (nodes[visit.node].op == CSG_LEAF)
            ok = push_leaf(scratch, scene, &nodes[visit.node], ray);
        else
            ok = merge(scratch, nodes[visit.node].op == CSG_AND, visit.num);
    }
    return ok;
}

/* The object's first change after tnear: its place in the pool, and whether the ray enters. */
static size_t first_crossing(const struct csg_ray_scratch *scratch, double tnear, bool *enters)
{
    size_t i = 0;
    *enters = !scratch->lists.data[0].inside;
    for (; i < scratch->pool.num && !(scratch->pool.data[i].t > tnear); i++)
        *enters = !*enters;
    return i;
}

struct best {
    struct csg_crossing crossing;
    bool found, enters;
    bool inside; /* the ray starts inside an object */
};

static bool try_object(const struct csgcast_scene *scene, const struct csg_object *object,
                       const struct csg_ray *ray, struct csg_ray_scratch *scratch,
                       struct best *best)
{
    const struct slab_ray line = slab_ray(ray, ray->tnear);
    if (!meets_box(&object->box, &line))
        return true;
    if (!evaluate(scene, object, ray, scratch))
        return false;
    bool enters;
    const size_t first = first_crossing(scratch, ray->tnear, &enters);
    best->inside |= !enters;
    if (first < scratch->pool.num &&
        (!best->found || scratch->pool.data[first].t < best->crossing.t)) {
        best->crossing = scratch->pool.data[first];
        best->enters = enters;
        best->found = true;
    }
    return true;
}

/* From inside an object the ray looks for the end of the union: all objects are one then. */
static bool trace_layer(const struct csgcast_scene *scene, uint8_t layer, const struct csg_ray *ray,
                        struct csg_ray_scratch *scratch, struct best *best)
{
    for (size_t i = 0; i < scene->objects->num; i++) {
        const struct csg_object *object = &scene->objects->data[i];
        if (object->layer == layer && !try_object(scene, object, ray, scratch, best))
            return false;
    }
    if (!best->inside)
        return true;
    const struct csg_object all = {layer,      layer, false, 0, (uint32_t)scene->trees[layer].num,
                                   csg_box_all};
    *best = (struct best){.found = false};
    return try_object(scene, &all, ray, scratch, best);
}

bool csg_reference_trace(const struct csgcast_scene *scene, uint8_t layer,
                         const struct csg_ray *ray, struct csg_ray_scratch *scratch,
                         struct csg_hit *hit, bool *failed)
{
    struct best best = {.found = false};
    if (!trace_layer(scene, layer, ray, scratch, &best)) {
        *failed = true;
        return false;
    }
    if (!best.found)
        return false;
    const struct csg_crossing *crossing = &best.crossing;
    *hit = (struct csg_hit){crossing->t, crossing->leaf, crossing->cut, layer, {0, 0, 0}};
    const bool enters = best.enters != crossing->cut;
    const struct csg_vec3 normal =
        scene->leaves[crossing->leaf].shape.surface
            ? csg_surface_normal(scene, crossing->leaf, ray, crossing->t, enters, &scratch->surface)
            : csg_leaf_normal(scene, crossing->leaf, ray, crossing->t, enters);
    hit->normal = crossing->cut ? csg_scale(-1, normal) : normal;
    return true;
}
