/* SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "csg/object.h"
#include "reference/crossings.h"
#include "reference/bounds.h"

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
};

struct csg_ray_scratch {
    const struct csg_tree_bounds *bounds; /* may be NULL */
    CSG_ARRAY(struct visit) visits;
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

/* The ray from there on; -INFINITY: the whole line. Widened a little: rounding here must not lose a
 * grazing hit. */
static bool meets_box(const struct csg_box *box, const struct csg_ray *ray, double from)
{
    const double lo[3] = {box->lo.x, box->lo.y, box->lo.z},
                 hi[3] = {box->hi.x, box->hi.y, box->hi.z};
    const double org[3] = {ray->org.x, ray->org.y, ray->org.z};
    const double dir[3] = {ray->dir.x, ray->dir.y, ray->dir.z};
    double tnear = from, tfar = INFINITY;
    for (int i = 0; i < 3; i++) {
        const double margin = 1e-9 * (fabs(lo[i]) + fabs(hi[i]) + fabs(org[i]));
        const double a = (lo[i] - margin - org[i]) / dir[i], b = (hi[i] + margin - org[i]) / dir[i];
        if (dir[i] == 0 || isnan(a) || isnan(b))
            continue;
        tnear = fmax(tnear, fmin(a, b));
        tfar = fmin(tfar, fmax(a, b));
    }
    return tnear <= tfar * (tfar > 0 ? 1 + 1e-12 : 1 - 1e-12);
}

/* The nodes that the line of the ray meets, in their order, each before what is below it. */
static bool find_visits(const struct csg_object *object, const struct csg_node *nodes,
                        const struct csg_ray *ray, struct csg_ray_scratch *scratch)
{
    const struct csg_tree_bounds *all = scratch->bounds;
    const struct csg_node_bounds *bounds = all ? all->nodes[object->layer] : NULL;
    bool ok = true;
    scratch->visits.num = 0;
    for (uint32_t i = object->begin; i < object->end && ok;) {
        const struct csg_box *box = bounds ? &bounds[i].box : NULL;
        const bool is_missed = box && (csg_box_is_empty(box) || !meets_box(box, ray, -INFINITY));
        ok = csg_array_push(&scratch->visits, ((struct visit){i, is_missed}));
        i = is_missed ? nodes[i].end : i + 1;
    }
    return ok;
}

static bool push_missed(struct csg_ray_scratch *scratch, uint8_t layer, uint32_t node)
{
    const struct list list = {scratch->pool.num, scratch->bounds->nodes[layer][node].inside};
    return csg_array_push(&scratch->lists, list);
}

static bool merge_children(struct csg_ray_scratch *scratch, const struct csg_node *nodes,
                           uint32_t node)
{
    size_t num = 0;
    for (uint32_t child = node + 1; child < nodes[node].end; child = nodes[child].end)
        num++;
    return merge(scratch, nodes[node].op == CSG_AND, num);
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
            ok = merge_children(scratch, nodes, visit.node);
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
    if (!meets_box(&object->box, ray, ray->tnear))
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
    const struct csg_object all = {
        layer, layer, false, false, 0, (uint32_t)scene->trees[layer].num, csg_box_all};
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
