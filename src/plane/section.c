/* SPDX-License-Identifier: MIT */
/*
 * Where a closed surface of triangles meets z = 0: of each triangle with corners on both sides a
 * segment, from one of its edges to another, the solid to its left. Two triangles that share an
 * edge share its crossing to the last bit, so that the segments make loops, whatever is rounded.
 */
#include "plane/section.h"

#include <stdlib.h>

#include "mesh/surface.h"

struct segment {
    uint64_t from, to; /* edges that cross the plane, see edge_of */
    struct csg_vec2 start;
    bool is_used;
};

struct cutter {
    const struct csg_surface *surface;
    const struct csg_map *map;
    struct csg_drawing *drawing;
    double near;
    bool is_mirrored; /* by map */
    CSG_ARRAY(struct segment) segments;
    CSG_ARRAY(struct csg_vec2) loop;
};

/* The same for both directions. */
static uint64_t edge_of(uint32_t a, uint32_t b)
{
    return a < b ? (uint64_t)a << 32 | b : (uint64_t)b << 32 | a;
}

static struct csg_vec2 crossing_of(const struct cutter *cutter, uint64_t edge)
{
    const struct csg_vec3 a = cutter->surface->points.data[edge >> 32];
    const struct csg_vec3 b = cutter->surface->points.data[edge & UINT32_MAX];
    double t = a.z / (a.z - b.z);
    if (fabs(a.z) <= cutter->near)
        t = 0;
    else if (fabs(b.z) <= cutter->near)
        t = 1;
    const struct csg_vec3 p = csg_add(a, csg_scale(t, csg_sub(b, a)));
    const struct csg_vec3 at = csg_map_point(cutter->map, csg_vec3(p.x, p.y, 0));
    return (struct csg_vec2){at.x, at.y};
}

/* level: the least z that is above the plane. */
static bool add_segment(struct cutter *cutter, const struct csg_triangle *triangle, double level)
{
    struct segment segment = {.is_used = false};
    bool is_cut = false;
    for (int i = 0; i < 3; i++) {
        const uint32_t a = triangle->points[i], b = triangle->points[(i + 1) % 3];
        const bool from_above = cutter->surface->points.data[a].z >= level;
        const bool to_above = cutter->surface->points.data[b].z >= level;
        if (from_above && !to_above)
            segment.from = edge_of(a, b);
        else if (to_above && !from_above)
            segment.to = edge_of(a, b);
        is_cut |= from_above != to_above;
    }
    if (is_cut)
        segment.start = crossing_of(cutter, segment.from);
    return !is_cut || csg_array_push(&cutter->segments, segment);
}

static int compare_segments(const void *a, const void *b)
{
    const struct segment *x = a, *y = b;
    return (x->from > y->from) - (x->from < y->from);
}

static struct segment *next_of(struct cutter *cutter, const struct segment *at)
{
    struct segment *segments = cutter->segments.data;
    size_t lo = 0, hi = cutter->segments.num;
    while (lo < hi) {
        const size_t middle = lo + (hi - lo) / 2;
        if (segments[middle].from < at->to)
            lo = middle + 1;
        else
            hi = middle;
    }
    for (; lo < cutter->segments.num && segments[lo].from == at->to; lo++)
        if (!segments[lo].is_used)
            return &segments[lo];
    return NULL;
}

static bool add_to_loop(struct cutter *cutter, struct csg_vec2 p)
{
    const size_t num = cutter->loop.num;
    const struct csg_vec2 *last = num > 0 ? &cutter->loop.data[num - 1] : NULL;
    return (last && last->x == p.x && last->y == p.y) || csg_array_push(&cutter->loop, p);
}

static bool add_contour(struct cutter *cutter)
{
    const size_t num = cutter->loop.num;
    if (num < 3)
        return true;
    bool ok = csg_drawing_add_contour(cutter->drawing);
    for (size_t i = 0; i < num && ok; i++) {
        const struct csg_vec2 p = cutter->loop.data[cutter->is_mirrored ? num - 1 - i : i];
        ok = csg_drawing_add_point(cutter->drawing, p.x, p.y);
    }
    return ok;
}

static bool add_loops(struct cutter *cutter)
{
    bool ok = true;
    if (cutter->segments.num > 0)
        qsort(cutter->segments.data, cutter->segments.num, sizeof *cutter->segments.data,
              compare_segments);
    for (size_t i = 0; i < cutter->segments.num && ok; i++) {
        cutter->loop.num = 0;
        for (struct segment *at = &cutter->segments.data[i]; at && !at->is_used && ok;
             at = next_of(cutter, at)) {
            at->is_used = true;
            ok = add_to_loop(cutter, at->start);
        }
        ok = ok && add_contour(cutter);
    }
    return ok;
}

static bool add_figure(struct cutter *cutter, double level, double rounding)
{
    const struct csg_surface *surface = cutter->surface;
    bool ok = csg_drawing_add_figure(cutter->drawing, rounding);
    cutter->segments.num = 0;
    for (size_t i = 0; i < surface->triangles.num && ok; i++)
        ok = add_segment(cutter, &surface->triangles.data[i], level);
    if (ok)
        cutter->drawing->figures.data[cutter->drawing->figures.num - 1].by_winding = true;
    return ok && add_loops(cutter);
}

static bool touches(const struct csg_surface *surface, double near)
{
    for (size_t i = 0; i < surface->points.num; i++)
        if (fabs(surface->points.data[i].z) <= near)
            return true;
    return false;
}

/* Just below the plane and, where that may be different, just above it. */
bool csg_surface_section(const struct csg_surface *surface, const struct csg_map *map,
                         double rounding, struct csg_drawing *drawing)
{
    const double near = CSG_SECTION_ON_PLANE * surface->size;
    struct cutter cutter = {surface, map, drawing, near, csg_map_determinant(map) < 0, {0}, {0}};
    const uint32_t draw = (uint32_t)drawing->nodes.num;
    bool ok = csg_drawing_open(drawing, CSG_DRAW_UNION) && add_figure(&cutter, -near, rounding);
    if (ok && touches(surface, near))
        ok = add_figure(&cutter, nextafter(near, INFINITY), rounding);
    if (ok)
        csg_drawing_close(drawing, draw);
    free(cutter.segments.data);
    free(cutter.loop.data);
    return ok;
}
