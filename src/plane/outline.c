/* SPDX-License-Identifier: MIT */
#include "plane/outline.h"

#include <stdlib.h>

#include "common/order.h"

/*
 * The sides of the spans, and of each level what is inside only above or only below it, are the
 * outline. Its corners are named by level and place in it, so chaining them compares no numbers.
 */

struct segment {
    uint32_t from, to; /* corners; the inside is to the left */
    bool is_used;
};

/* A span's corners. */
struct ends {
    uint32_t low[2], high[2]; /* left and right */
};

struct tracer {
    struct csg_sweep sweep;
    double noise;
    CSG_ARRAY(struct csg_vec2) corners;
    CSG_ARRAY(struct segment) segments;
    CSG_ARRAY(double) xs; /* of the corners of the level at hand */
    struct ends *ends;    /* of each span */
    uint32_t *first;      /* by corner: its first segment, in the order of from */
};

/* Corners turn by more than this, as a sine, */
#define STRAIGHT 1e-12

/* and stand further from the way between their neighbours than this share of the largest
 * coordinate. An edge is cut at each level, where rounding moves it aside by some units of its last
 * digit, which turns short pieces by any angle. */
#define ROUNDING 2e-15

/* Spans [begin, end) of one slab. */
struct slab {
    size_t begin, end;
};

static bool collect(struct tracer *tracer, struct slab slab, uint32_t level)
{
    bool ok = true;
    for (size_t i = slab.begin; i < slab.end && ok; i++) {
        const struct csg_sweep_span *span = &tracer->sweep.spans.data[i];
        ok = csg_array_push(&tracer->xs, csg_sweep_x(&tracer->sweep, span->left, level)) &&
             csg_array_push(&tracer->xs, csg_sweep_x(&tracer->sweep, span->right, level));
    }
    return ok;
}

/* The corners of a level, from left to right. */
static bool make_corners(struct tracer *tracer, struct slab below, struct slab above,
                         uint32_t level)
{
    size_t num = 0;
    bool ok = true;
    tracer->xs.num = 0;
    if (!collect(tracer, below, level) || !collect(tracer, above, level))
        return false;
    if (tracer->xs.num)
        qsort(tracer->xs.data, tracer->xs.num, sizeof *tracer->xs.data, csg_compare_doubles);
    for (size_t i = 0; i < tracer->xs.num; i++)
        if (num == 0 || tracer->xs.data[i] - tracer->xs.data[num - 1] > tracer->noise)
            tracer->xs.data[num++] = tracer->xs.data[i];
    tracer->xs.num = num;
    for (size_t i = 0; i < num && ok; i++)
        ok = csg_array_push(
            &tracer->corners,
            ((struct csg_vec2){tracer->xs.data[i], tracer->sweep.levels.data[level]}));
    return ok;
}

static uint32_t find_corner(const struct tracer *tracer, uint32_t edge, uint32_t level)
{
    const double x = csg_sweep_x(&tracer->sweep, edge, level);
    const size_t low = csg_sweep_last_up_to(tracer->xs.data, tracer->xs.num, x);
    return (uint32_t)(tracer->corners.num - tracer->xs.num + low);
}

static bool add_segment(struct tracer *tracer, uint32_t from, uint32_t to)
{
    return from == to || csg_array_push(&tracer->segments, ((struct segment){from, to, false}));
}

/* Counts over the gaps between the corners of the level: +1 for a span above, -1 for one below. */
static bool add_horizontal(struct tracer *tracer, struct slab below, struct slab above)
{
    const uint32_t first = (uint32_t)(tracer->corners.num - tracer->xs.num);
    int *gaps = calloc(tracer->xs.num + 1, sizeof *gaps);
    bool ok = gaps != NULL;
    for (size_t i = above.begin; i < above.end && ok; i++)
        for (uint32_t k = tracer->ends[i].low[0]; k < tracer->ends[i].low[1]; k++)
            gaps[k - first]++;
    for (size_t i = below.begin; i < below.end && ok; i++)
        for (uint32_t k = tracer->ends[i].high[0]; k < tracer->ends[i].high[1]; k++)
            gaps[k - first]--;
    for (uint32_t k = 0; k + 1 < tracer->xs.num && ok; k++)
        if (gaps[k] > 0)
            ok = add_segment(tracer, first + k, first + k + 1);
        else if (gaps[k] < 0)
            ok = add_segment(tracer, first + k + 1, first + k);
    free(gaps);
    return ok;
}

static bool trace_level(struct tracer *tracer, struct slab below, struct slab above, uint32_t level)
{
    const struct csg_sweep_span *spans = tracer->sweep.spans.data;
    if (!make_corners(tracer, below, above, level))
        return false;
    for (size_t i = below.begin; i < below.end; i++) {
        struct ends *ends = &tracer->ends[i];
        ends->high[0] = find_corner(tracer, spans[i].left, level);
        ends->high[1] = find_corner(tracer, spans[i].right, level);
        if (!add_segment(tracer, ends->high[0], ends->low[0]) ||
            !add_segment(tracer, ends->low[1], ends->high[1]))
            return false;
    }
    for (size_t i = above.begin; i < above.end; i++) {
        tracer->ends[i].low[0] = find_corner(tracer, spans[i].left, level);
        tracer->ends[i].low[1] = find_corner(tracer, spans[i].right, level);
    }
    return add_horizontal(tracer, below, above);
}

static bool trace_levels(struct tracer *tracer)
{
    const size_t num = tracer->sweep.spans.num;
    struct slab below = {0, 0};
    bool ok = true;
    for (uint32_t level = 0; level < tracer->sweep.levels.num && ok; level++) {
        struct slab above = {below.end, below.end};
        while (above.end < num && tracer->sweep.spans.data[above.end].level == level)
            above.end++;
        ok = trace_level(tracer, below, above, level);
        below = above;
    }
    return ok;
}

/* ---- chains ------------------------------------------------------------------------------- */

static int compare_from(const void *a, const void *b)
{
    const struct segment *x = a, *y = b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    return x->to < y->to ? -1 : x->to > y->to;
}

static bool sort_segments(struct tracer *tracer)
{
    const size_t num = tracer->corners.num;
    tracer->first = malloc((num + 2) * sizeof *tracer->first);
    if (!tracer->first)
        return false;
    if (tracer->segments.num)
        qsort(tracer->segments.data, tracer->segments.num, sizeof *tracer->segments.data,
              compare_from);
    size_t k = 0;
    for (uint32_t i = 0; i <= num; i++) {
        while (k < tracer->segments.num && tracer->segments.data[k].from < i)
            k++;
        tracer->first[i] = (uint32_t)k;
    }
    return true;
}

/* The angle by which the way from a over b to c turns to the left. */
static double turn(const struct tracer *tracer, uint32_t a, uint32_t b, uint32_t c)
{
    const struct csg_vec2 *p = tracer->corners.data;
    const double x0 = p[b].x - p[a].x, y0 = p[b].y - p[a].y;
    const double x1 = p[c].x - p[b].x, y1 = p[c].y - p[b].y;
    return atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1);
}

/* Where several ways go on, the one furthest to the left keeps to the same piece of the inside. */
static struct segment *next_segment(struct tracer *tracer, const struct segment *segment)
{
    struct segment *best = NULL;
    double best_turn = -INFINITY;
    for (uint32_t k = tracer->first[segment->to]; k < tracer->first[segment->to + 1]; k++) {
        struct segment *next = &tracer->segments.data[k];
        const double angle = turn(tracer, segment->from, segment->to, next->to);
        if (!next->is_used && angle > best_turn) {
            best_turn = angle;
            best = next;
        }
    }
    return best;
}

static bool is_straight(const struct csg_vec2 *a, const struct csg_vec2 *b,
                        const struct csg_vec2 *c, double rounding)
{
    const double x0 = b->x - a->x, y0 = b->y - a->y, x1 = c->x - b->x, y1 = c->y - b->y;
    const double area = fabs(x0 * y1 - y0 * x1);
    return area <= STRAIGHT * hypot(x0, y0) * hypot(x1, y1) ||
           (x0 * x1 + y0 * y1 > 0 && area <= rounding * hypot(x0 + x1, y0 + y1));
}

static void drop_contour(struct csg_drawing *drawing)
{
    drawing->points.num = drawing->contours.data[--drawing->contours.num].begin;
    drawing->figures.data[drawing->figures.num - 1].end--;
}

/* Leaves out the corners of the last contour where it goes straight on, and all of it where none
 * are left around an area. */
static void straighten(struct csg_drawing *drawing, double rounding)
{
    struct csg_contour *contour = &drawing->contours.data[drawing->contours.num - 1];
    struct csg_vec2 *p = &drawing->points.data[contour->begin];
    const uint32_t num = contour->end - contour->begin;
    uint32_t kept = 0;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_vec2 before = kept ? p[kept - 1] : p[num - 1];
        const struct csg_vec2 after = p[(i + 1) % num], at = p[i];
        if (!is_straight(&before, &at, &after, rounding))
            p[kept++] = at;
    }
    contour->end = contour->begin + kept;
    drawing->points.num = contour->end;
    if (kept < 3)
        drop_contour(drawing);
}

static bool add_contour(struct tracer *tracer, struct csg_drawing *drawing, struct segment *first)
{
    bool ok = csg_drawing_add_contour(drawing);
    for (struct segment *at = first; ok && at; at = next_segment(tracer, at)) {
        const struct csg_vec2 corner = tracer->corners.data[at->from];
        at->is_used = true;
        ok = csg_drawing_add_point(drawing, corner.x, corner.y);
    }
    if (ok)
        straighten(drawing, ROUNDING * tracer->sweep.size);
    return ok;
}

static bool trace(struct tracer *tracer, struct csg_drawing *drawing, double rounding)
{
    tracer->noise = 4 * CSG_SWEEP_NOISE * tracer->sweep.size;
    tracer->ends = calloc(tracer->sweep.spans.num + 1, sizeof *tracer->ends);
    bool ok = tracer->ends && trace_levels(tracer) && sort_segments(tracer) &&
              csg_drawing_add_figure(drawing, rounding);
    for (size_t i = 0; i < tracer->segments.num && ok; i++)
        if (!tracer->segments.data[i].is_used)
            ok = add_contour(tracer, drawing, &tracer->segments.data[i]);
    return ok;
}

/* Whether the subtree is one already, perhaps as the only child of only children. */
static bool is_outline(struct csg_drawing *drawing, uint32_t node)
{
    const struct csg_draw_node *nodes = drawing->nodes.data;
    const uint32_t i = csg_drawing_only(drawing, node);
    if (nodes[i].op != CSG_DRAW_FIGURE || !drawing->figures.data[nodes[i].figure].is_outline)
        return false;
    drawing->nodes.data[node] = nodes[i];
    drawing->nodes.data[node].end = node + 1;
    csg_drawing_cut(drawing, node + 1);
    return true;
}

enum csg_sweep_result csg_drawing_evaluate(struct csg_drawing *drawing, uint32_t node)
{
    struct tracer tracer = {0};
    if (is_outline(drawing, node))
        return CSG_SWEEP_DONE;
    const uint32_t end = drawing->nodes.data[node].end;
    const double rounding = csg_drawing_rounding(drawing, node, end);
    const bool facetted = csg_drawing_is_facetted(drawing, node, end);
    enum csg_sweep_result result = csg_sweep(&tracer.sweep, drawing, node);
    if (result == CSG_SWEEP_DONE) {
        csg_drawing_drop(drawing, node);
        if (trace(&tracer, drawing, rounding)) {
            drawing->figures.data[drawing->figures.num - 1].facetted = facetted;
            drawing->figures.data[drawing->figures.num - 1].is_outline = true;
        } else {
            result = CSG_SWEEP_NO_MEMORY;
        }
    }
    csg_sweep_finish(&tracer.sweep);
    free(tracer.corners.data);
    free(tracer.segments.data);
    free(tracer.xs.data);
    free(tracer.ends);
    free(tracer.first);
    return result;
}
