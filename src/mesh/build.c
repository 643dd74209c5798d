/* SPDX-License-Identifier: MIT */
/*
 * The hierarchy of boxes: cut where the surface area heuristic, over bins of centres, is least
 * (Wald 2007), from the top down with a stack of its own.
 */
#include <stdlib.h>
#include <string.h>

#include "mesh/surface.h"
#include "solids/shape.h"

enum { num_bins = 16, max_leaf = 4 };

/* More triangles than that are cut along the longest side of their centres' box, as the best cut
 * nearly always is. */
enum { max_compared = 1024 };

struct task {
    uint32_t first, num;
};

/* What building needs of a triangle. */
struct item {
    struct csg_box box;
    struct csg_vec3 center;
    uint32_t triangle;
};

struct build {
    struct csg_surface *surface;
    struct item *items;
    CSG_ARRAY(struct task) tasks;
};

struct bin {
    struct csg_box box;
    uint32_t num;
};

static int bin_of(double x, double lo, double scale)
{
    const double bin = (x - lo) * scale;
    return bin >= num_bins ? num_bins - 1 : bin > 0 ? (int)bin : 0;
}

/* The cheapest of the cuts between bins along axis: items of bins below *cut go first. */
static double best_cut(const struct item *items, uint32_t num, int axis, double lo, double scale,
                       int *cut)
{
    struct bin bins[num_bins];
    double after[num_bins];
    for (int i = 0; i < num_bins; i++)
        bins[i] = (struct bin){csg_box_empty, 0};
    for (uint32_t i = 0; i < num; i++) {
        struct bin *bin = &bins[bin_of(csg_vec3_component(items[i].center, axis), lo, scale)];
        bin->box = csg_box_union(&bin->box, &items[i].box);
        bin->num++;
    }
    struct bin sum = {csg_box_empty, 0};
    for (int i = num_bins; i-- > 1;) {
        sum.box = csg_box_union(&sum.box, &bins[i].box);
        sum.num += bins[i].num;
        after[i] = sum.num ? csg_box_half_area(&sum.box) * sum.num : INFINITY;
    }
    double least = INFINITY;
    sum = (struct bin){csg_box_empty, 0};
    for (int i = 1; i < num_bins; i++) {
        sum.box = csg_box_union(&sum.box, &bins[i - 1].box);
        sum.num += bins[i - 1].num;
        const double cost = sum.num ? csg_box_half_area(&sum.box) * sum.num + after[i] : INFINITY;
        if (cost < least) {
            least = cost;
            *cut = i;
        }
    }
    return least;
}

/* Sorts the items into two runs; returns the length of the first. Where all centres are at one
 * place, or areas overflow, any two halves do. */
static uint32_t split(struct item *items, uint32_t num, const struct csg_box *centers)
{
    const struct csg_vec3 sizes = csg_sub(centers->hi, centers->lo);
    const double longest = fmax(sizes.x, fmax(sizes.y, sizes.z));
    double least = INFINITY;
    int axis = -1, cut = 0;
    for (int i = 0; i < 3; i++) {
        const double lo = csg_vec3_component(centers->lo, i), size = csg_vec3_component(sizes, i);
        if (num > max_compared && size < longest)
            continue;
        int at = 0;
        const double cost = size > 0 ? best_cut(items, num, i, lo, num_bins / size, &at) : INFINITY;
        if (cost < least) {
            least = cost;
            axis = i;
            cut = at;
        }
    }
    if (axis < 0)
        return num / 2;
    const double lo = csg_vec3_component(centers->lo, axis);
    const double scale = num_bins / (csg_vec3_component(centers->hi, axis) - lo);
    uint32_t first = 0;
    for (uint32_t i = 0; i < num; i++) {
        if (bin_of(csg_vec3_component(items[i].center, axis), lo, scale) >= cut)
            continue;
        const struct item item = items[i];
        items[i] = items[first];
        items[first++] = item;
    }
    return first > 0 && first < num ? first : num / 2;
}

static bool visit(struct build *build, struct task task)
{
    struct csg_surface *surface = build->surface;
    struct item *items = build->items + task.first;
    struct csg_box box = csg_box_empty, centers = csg_box_empty;
    for (uint32_t i = 0; i < task.num; i++) {
        box = csg_box_union(&box, &items[i].box);
        csg_box_extend(&centers, items[i].center);
    }
    const bool is_leaf = task.num <= max_leaf;
    const struct csg_box_node node = {box, 0, task.first, is_leaf ? task.num : 0};
    if (!csg_array_push(&surface->nodes, node))
        return false;
    if (is_leaf)
        return true;
    const uint32_t first = split(items, task.num, &centers);
    const struct task left = {task.first, first}, right = {task.first + first, task.num - first};
    return csg_array_push(&build->tasks, right) && csg_array_push(&build->tasks, left);
}

/* Ends of subtrees, from the back: a leaf's is the next node, an inner node's that of its second
 * child, which begins where its first child ends. */
static void fill_ends(struct csg_surface *surface)
{
    struct csg_box_node *nodes = surface->nodes.data;
    for (size_t i = surface->nodes.num; i-- > 0;)
        nodes[i].end = nodes[i].num ? (uint32_t)i + 1 : nodes[nodes[i + 1].end].end;
}

static void fill_items(struct build *build)
{
    const struct csg_surface *surface = build->surface;
    for (size_t i = 0; i < surface->triangles.num; i++) {
        struct item *item = &build->items[i];
        *item = (struct item){.box = csg_box_empty, .triangle = (uint32_t)i};
        for (int j = 0; j < 3; j++)
            csg_box_extend(&item->box, surface->points.data[surface->triangles.data[i].points[j]]);
        item->center = csg_add(csg_scale(0.5, item->box.lo), csg_scale(0.5, item->box.hi));
    }
}

static bool reorder(struct build *build)
{
    struct csg_surface *surface = build->surface;
    const size_t num = surface->triangles.num;
    struct csg_triangle *old = malloc(num * sizeof *old);
    if (!old)
        return false;
    memcpy(old, surface->triangles.data, num * sizeof *old);
    for (size_t i = 0; i < num; i++)
        surface->triangles.data[i] = old[build->items[i].triangle];
    free(old);
    return true;
}

bool csg_surface_build(struct csg_surface *surface)
{
    struct build build = {.surface = surface};
    surface->nodes.num = 0;
    if (surface->triangles.num == 0)
        return true;
    build.items = malloc(surface->triangles.num * sizeof *build.items);
    const struct task all = {0, (uint32_t)surface->triangles.num};
    bool ok = build.items && csg_array_push(&build.tasks, all);
    if (ok)
        fill_items(&build);
    while (ok && build.tasks.num)
        ok = visit(&build, build.tasks.data[--build.tasks.num]);
    ok = ok && reorder(&build);
    if (ok)
        fill_ends(surface);
    csg_array_trim(&surface->nodes);
    free(build.items);
    free(build.tasks.data);
    return ok;
}
