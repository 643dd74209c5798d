/* SPDX-License-Identifier: MIT */
#include "plane/sweep.h"

#include <stdlib.h>

#include "common/order.h"
#include "plane/membership.h"

/* An edge's place in the order of a slab. */
struct key {
    double x; /* in the middle of the slab */
    uint32_t edge;
};

struct slabs {
    struct csg_sweep *sweep;
    struct csg_membership membership;
    CSG_ARRAY(struct key) active;
};

void csg_sweep_finish(struct csg_sweep *sweep)
{
    free(sweep->edges.data);
    free(sweep->levels.data);
    free(sweep->spans.data);
    *sweep = (struct csg_sweep){0};
}

static double x_at(const struct csg_sweep_edge *edge, double y)
{
    const double t = (y - edge->low.y) / (edge->high.y - edge->low.y);
    return edge->low.x + t * (edge->high.x - edge->low.x);
}

double csg_sweep_x(const struct csg_sweep *sweep, uint32_t index, uint32_t level)
{
    const struct csg_sweep_edge *edge = &sweep->edges.data[index];
    if (level == edge->begin)
        return edge->low.x;
    return level == edge->end ? edge->high.x : x_at(edge, sweep->levels.data[level]);
}

/* ---- edges -------------------------------------------------------------------------------- */

static bool add_edge(struct csg_sweep *sweep, struct csg_vec2 a, struct csg_vec2 b, uint32_t figure)
{
    const bool up = a.y <= b.y;
    const struct csg_sweep_edge edge = {
        .low = up ? a : b, .high = up ? b : a, .figure = figure, .is_down = !up};
    sweep->size = fmax(sweep->size, fmax(fabs(a.x), fabs(a.y)));
    if (a.y == b.y)
        return true;
    return csg_array_push(&sweep->edges, edge) && csg_array_push(&sweep->levels, a.y) &&
           csg_array_push(&sweep->levels, b.y);
}

static bool add_edges(struct csg_sweep *sweep, const struct csg_drawing *drawing, uint32_t node)
{
    bool ok = true;
    for (uint32_t i = node; i < drawing->nodes.data[node].end; i++) {
        if (drawing->nodes.data[i].op != CSG_DRAW_FIGURE)
            continue;
        const uint32_t index = drawing->nodes.data[i].figure;
        const struct csg_figure *figure = &drawing->figures.data[index];
        if (figure->is_join)
            continue;
        for (uint32_t j = figure->begin; j < figure->end && ok; j++) {
            const struct csg_contour contour = drawing->contours.data[j];
            for (uint32_t k = contour.begin; k < contour.end && ok; k++)
                ok = add_edge(sweep, drawing->points.data[k],
                              drawing->points.data[k + 1 < contour.end ? k + 1 : contour.begin],
                              index);
        }
    }
    return ok;
}

/* ---- crossings ---------------------------------------------------------------------------- */

/* Where the order of the two edges changes, if it does: the height there. */
static bool cross(const struct csg_sweep_edge *a, const struct csg_sweep_edge *b, double noise,
                  double *y)
{
    const double low = fmax(a->low.y, b->low.y), high = fmin(a->high.y, b->high.y);
    if (fmin(a->low.x, a->high.x) > fmax(b->low.x, b->high.x) ||
        fmax(a->low.x, a->high.x) < fmin(b->low.x, b->high.x) || high - low <= noise)
        return false;
    const double below = x_at(a, low) - x_at(b, low), above = x_at(a, high) - x_at(b, high);
    if (fabs(below) <= noise || fabs(above) <= noise || (below < 0) == (above < 0))
        return false;
    *y = low + (high - low) * (below / (below - above));
    return true;
}

/* An edge from end to end along an axis, in one of the strips along it that the edge passes. */
struct extent {
    double lo, hi;
    uint32_t edge, strip;
};

struct extents {
    CSG_ARRAY(struct extent) list;
};

static int compare_extents(const void *a, const void *b)
{
    const struct extent *x = a, *y = b;
    if (x->strip != y->strip)
        return x->strip < y->strip ? -1 : 1;
    return csg_compare_doubles(&x->lo, &y->lo);
}

static struct extent extent_of(const struct csg_sweep *sweep, uint32_t i, bool along_x)
{
    const struct csg_sweep_edge *edge = &sweep->edges.data[i];
    return along_x ? (struct extent){fmin(edge->low.x, edge->high.x),
                                     fmax(edge->low.x, edge->high.x), i, 0}
                   : (struct extent){edge->low.y, edge->high.y, i, 0};
}

/* All edges along an axis. */
struct crowd {
    double lo, hi;
    double edges; /* how many a line across the axis cuts, on average */
};

static struct crowd crowd_of(const struct csg_sweep *sweep, bool along_x)
{
    struct crowd crowd = {INFINITY, -INFINITY, 0};
    double sum = 0;
    for (uint32_t i = 0; i < sweep->edges.num; i++) {
        const struct extent extent = extent_of(sweep, i, along_x);
        crowd.lo = fmin(crowd.lo, extent.lo);
        crowd.hi = fmax(crowd.hi, extent.hi);
        sum += extent.hi - extent.lo;
    }
    crowd.edges = crowd.hi > crowd.lo ? sum / (crowd.hi - crowd.lo) : 0;
    return crowd;
}

/* The edges by strips, about as wide as edges are, so that each is in two or so. */
static bool fill_extents(const struct csg_sweep *sweep, bool along_x, const struct crowd *across,
                         struct extents *extents)
{
    const double num = (double)sweep->edges.num, size = across->hi - across->lo;
    const double num_strips = across->edges > 0 ? fmin(num / across->edges, num) : 1;
    const double scale = size > 0 ? num_strips / size : 0;
    for (uint32_t i = 0; i < sweep->edges.num; i++) {
        const struct extent other = extent_of(sweep, i, !along_x);
        struct extent extent = extent_of(sweep, i, along_x);
        const uint32_t end = (uint32_t)((other.hi - across->lo) * scale);
        extent.strip = (uint32_t)((other.lo - across->lo) * scale);
        for (; extent.strip <= end; extent.strip++)
            if (!csg_array_push(&extents->list, extent))
                return false;
    }
    return true;
}

/* Of all pairs that overlap along the axis, of the two the one with fewer, and share a strip. What
 * pairs share several gives the same level several times. */
static bool add_crossings(struct csg_sweep *sweep, double noise)
{
    const struct crowd x = crowd_of(sweep, true), y = crowd_of(sweep, false);
    const bool along_x = x.edges < y.edges;
    struct extents extents = {0};
    bool ok = fill_extents(sweep, along_x, along_x ? &y : &x, &extents);
    const struct extent *list = extents.list.data;
    const size_t num = extents.list.num;
    if (ok && num)
        qsort(extents.list.data, num, sizeof *list, compare_extents);
    for (size_t i = 0; i < num && ok; i++)
        for (size_t j = i + 1;
             j < num && ok && list[j].strip == list[i].strip && list[j].lo < list[i].hi; j++) {
            double level;
            if (cross(&sweep->edges.data[list[i].edge], &sweep->edges.data[list[j].edge], noise,
                      &level))
                ok = csg_array_push(&sweep->levels, level);
        }
    free(extents.list.data);
    return ok;
}

/* ---- levels ------------------------------------------------------------------------------- */

/* A level stands for the heights up to noise above it. */
static void merge_levels(struct csg_sweep *sweep, double noise)
{
    size_t num = 0;
    double *levels = sweep->levels.data;
    if (sweep->levels.num)
        qsort(levels, sweep->levels.num, sizeof *levels, csg_compare_doubles);
    for (size_t i = 0; i < sweep->levels.num; i++)
        if (num == 0 || levels[i] - levels[num - 1] > noise)
            levels[num++] = levels[i];
    sweep->levels.num = num;
}

size_t csg_sweep_last_up_to(const double *values, size_t num, double limit)
{
    size_t low = 0, high = num;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (values[middle] <= limit)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* The last level that is not above y. */
static uint32_t find_level(const struct csg_sweep *sweep, double y)
{
    return (uint32_t)csg_sweep_last_up_to(sweep->levels.data, sweep->levels.num, y);
}

/* Edges within one level are horizontal after all. */
static void assign_levels(struct csg_sweep *sweep)
{
    size_t num = 0;
    for (size_t i = 0; i < sweep->edges.num; i++) {
        struct csg_sweep_edge edge = sweep->edges.data[i];
        edge.begin = find_level(sweep, edge.low.y);
        edge.end = find_level(sweep, edge.high.y);
        if (edge.begin < edge.end)
            sweep->edges.data[num++] = edge;
    }
    sweep->edges.num = num;
}

/* ---- slabs -------------------------------------------------------------------------------- */

static int compare_keys(const void *a, const void *b)
{
    const struct key *x = a, *y = b;
    if (x->x != y->x)
        return x->x < y->x ? -1 : 1;
    return x->edge < y->edge ? -1 : x->edge > y->edge;
}

/* The active edges are nearly in order already, from the slab below. */
static void sort_keys(struct key *keys, size_t num)
{
    size_t moves = 0;
    for (size_t i = 1; i < num; i++) {
        const struct key key = keys[i];
        size_t j = i;
        for (; j > 0 && compare_keys(&keys[j - 1], &key) > 0; j--, moves++)
            keys[j] = keys[j - 1];
        keys[j] = key;
        if (moves > 16 * num) {
            qsort(keys, num, sizeof *keys, compare_keys);
            return;
        }
    }
}

static bool update_active(struct slabs *slabs, uint32_t level, size_t *next)
{
    const struct csg_sweep *sweep = slabs->sweep;
    const double middle = 0.5 * (sweep->levels.data[level] + sweep->levels.data[level + 1]);
    size_t num = 0;
    for (size_t i = 0; i < slabs->active.num; i++)
        if (sweep->edges.data[slabs->active.data[i].edge].end > level)
            slabs->active.data[num++] = slabs->active.data[i];
    slabs->active.num = num;
    for (; *next < sweep->edges.num && sweep->edges.data[*next].begin == level; (*next)++)
        if (!csg_array_push(&slabs->active, ((struct key){0, (uint32_t)*next})))
            return false;
    for (size_t i = 0; i < slabs->active.num; i++) {
        const struct csg_sweep_edge *edge = &sweep->edges.data[slabs->active.data[i].edge];
        slabs->active.data[i].x = x_at(edge, middle);
    }
    sort_keys(slabs->active.data, slabs->active.num);
    return true;
}

/* Edges at the same place are stepped over together: what touches is one. */
static bool fill_slab(struct slabs *slabs, uint32_t level, double noise)
{
    struct csg_sweep *sweep = slabs->sweep;
    struct csg_sweep_span span = {.level = level};
    bool inside = false;
    for (size_t i = 0; i < slabs->active.num;) {
        const struct key first = slabs->active.data[i];
        for (; i < slabs->active.num && slabs->active.data[i].x - first.x <= noise; i++) {
            const struct csg_sweep_edge *edge = &sweep->edges.data[slabs->active.data[i].edge];
            csg_membership_step(&slabs->membership, edge->figure, edge->is_down);
        }
        const bool was_inside = inside;
        inside = csg_membership_is_inside(&slabs->membership);
        if (inside && !was_inside)
            span.left = first.edge;
        span.right = first.edge;
        if (was_inside && !inside && !csg_array_push(&sweep->spans, span))
            return false;
    }
    return true;
}

static int compare_low(const void *a, const void *b)
{
    const struct csg_sweep_edge *x = a, *y = b;
    if (x->low.y != y->low.y)
        return x->low.y < y->low.y ? -1 : 1;
    return x->low.x < y->low.x ? -1 : x->low.x > y->low.x;
}

static int compare_begin(const void *a, const void *b)
{
    const struct csg_sweep_edge *x = a, *y = b;
    if (x->begin != y->begin)
        return x->begin < y->begin ? -1 : 1;
    return compare_low(a, b);
}

static enum csg_sweep_result fill_slabs(struct slabs *slabs, double noise)
{
    struct csg_sweep *sweep = slabs->sweep;
    size_t next = 0;
    if (sweep->edges.num)
        qsort(sweep->edges.data, sweep->edges.num, sizeof *sweep->edges.data, compare_begin);
    for (uint32_t level = 0; level + 1 < sweep->levels.num; level++) {
        if (!update_active(slabs, level, &next) || !fill_slab(slabs, level, noise))
            return CSG_SWEEP_NO_MEMORY;
        if (sweep->spans.num > CSG_SWEEP_MAX_SPANS)
            return CSG_SWEEP_TOO_LARGE;
    }
    return CSG_SWEEP_DONE;
}

enum csg_sweep_result csg_sweep(struct csg_sweep *sweep, const struct csg_drawing *drawing,
                                uint32_t node)
{
    struct slabs slabs = {.sweep = sweep};
    enum csg_sweep_result result = CSG_SWEEP_NO_MEMORY;
    if (!add_edges(sweep, drawing, node))
        return result;
    if (sweep->edges.num > CSG_SWEEP_MAX_EDGES || !(sweep->size < CSG_SWEEP_MAX_SIZE))
        return CSG_SWEEP_TOO_LARGE;
    const double noise = CSG_SWEEP_NOISE * sweep->size;
    if (!add_crossings(sweep, noise))
        return result;
    merge_levels(sweep, noise);
    assign_levels(sweep);
    if (csg_membership_init(&slabs.membership, drawing, node))
        result = fill_slabs(&slabs, noise);
    csg_membership_finish(&slabs.membership);
    free(slabs.active.data);
    return result;
}
