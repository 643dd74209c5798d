/* SPDX-License-Identifier: MIT */
#include "plane/convex.h"

#include <stdlib.h>

#include "plane/sweep.h"

struct polygon {
    CSG_ARRAY(struct csg_vec2) points; /* counterclockwise */
};

/* The corner so many behind i, perhaps past the last one. */
static struct csg_vec2 corner(const struct csg_drawing *drawing, const struct csg_contour *contour,
                              uint32_t i)
{
    return drawing->points.data[contour->begin + i % (contour->end - contour->begin)];
}

/* How far p is to the left of the way from a to b, times the length of that. */
static double left_of(struct csg_vec2 a, struct csg_vec2 b, struct csg_vec2 p)
{
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/* It never turns to the other side, and goes to the right and back once. */
static bool is_convex(const struct csg_drawing *drawing, const struct csg_contour *contour)
{
    const double sign = csg_contour_twice_area(drawing, contour) > 0 ? 1 : -1;
    const uint32_t num = contour->end - contour->begin;
    double before = 0, first = 0;
    int turns = 0;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_vec2 a = corner(drawing, contour, i), b = corner(drawing, contour, i + 1);
        const double x = b.x - a.x;
        if (!(sign * left_of(a, b, corner(drawing, contour, i + 2)) >= 0))
            return false;
        if (x == 0)
            continue;
        turns += before * x < 0;
        first = first == 0 ? x : first;
        before = x;
    }
    return num >= 3 && turns + (before * first < 0) == 2;
}

/* Of the convex polygon that the node is; NULL: it is none, or a disc, which is kept. */
static const struct csg_contour *find_polygon(const struct csg_drawing *drawing, uint32_t node)
{
    const struct csg_draw_node *at = &drawing->nodes.data[csg_drawing_only(drawing, node)];
    if (at->op != CSG_DRAW_FIGURE)
        return NULL;
    const struct csg_figure *figure = &drawing->figures.data[at->figure];
    if (figure->end != figure->begin + 1 || figure->is_disc || figure->is_join ||
        figure->by_winding)
        return NULL;
    const struct csg_contour *contour = &drawing->contours.data[figure->begin];
    return is_convex(drawing, contour) ? contour : NULL;
}

static bool are_polygons(const struct csg_drawing *drawing, uint32_t node)
{
    const uint32_t end = drawing->nodes.data[node].end;
    uint32_t num = 0;
    if (drawing->nodes.data[node].op != CSG_DRAW_INTERSECTION)
        return false;
    for (uint32_t i = node + 1; i < end; i = drawing->nodes.data[i].end, num++)
        if (!find_polygon(drawing, i))
            return false;
    return num > 1;
}

/* What of the polygon is to the left of the way from a to b; what is nearer than noise is on it
 * (Sutherland and Hodgman 1974). */
static bool clip(struct polygon *polygon, struct csg_vec2 a, struct csg_vec2 b, double noise)
{
    const double length = hypot(b.x - a.x, b.y - a.y);
    struct polygon kept = {0};
    bool ok = true, any = length == 0;
    for (size_t i = 0; i < polygon->points.num && ok; i++) {
        const struct csg_vec2 p = polygon->points.data[i];
        const struct csg_vec2 q = polygon->points.data[(i + 1) % polygon->points.num];
        const double dp = left_of(a, b, p), dq = left_of(a, b, q), on = noise * length;
        any |= dp > on;
        if (dp >= -on)
            ok = csg_array_push(&kept.points, p);
        if ((dp < -on && dq > on) || (dp > on && dq < -on)) {
            const double t = dp / (dp - dq);
            const struct csg_vec2 at = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
            ok = ok && csg_array_push(&kept.points, at);
        }
    }
    kept.points.num = any ? kept.points.num : 0;
    free(polygon->points.data);
    *polygon = kept;
    return ok;
}

static bool clip_to(struct polygon *polygon, const struct csg_drawing *drawing,
                    const struct csg_contour *contour, double noise)
{
    const bool is_left = csg_contour_twice_area(drawing, contour) > 0;
    const uint32_t num = contour->end - contour->begin;
    bool ok = true;
    for (uint32_t i = 0; i < num && ok; i++)
        ok = clip(polygon, corner(drawing, contour, is_left ? i : i + 1),
                  corner(drawing, contour, is_left ? i + 1 : i), noise);
    return ok;
}

static bool start(struct polygon *polygon, const struct csg_drawing *drawing,
                  const struct csg_contour *contour)
{
    const bool is_left = csg_contour_twice_area(drawing, contour) > 0;
    const uint32_t num = contour->end - contour->begin;
    bool ok = true;
    for (uint32_t i = 0; i < num && ok; i++)
        ok = csg_array_push(&polygon->points, corner(drawing, contour, is_left ? i : num - 1 - i));
    return ok;
}

static double noise_of(const struct csg_drawing *drawing, uint32_t node)
{
    double size = 0;
    for (uint32_t i = node + 1; i < drawing->nodes.data[node].end; i = drawing->nodes.data[i].end) {
        const struct csg_contour *contour = find_polygon(drawing, i);
        for (uint32_t k = contour->begin; k < contour->end; k++)
            size =
                fmax(size, fmax(fabs(drawing->points.data[k].x), fabs(drawing->points.data[k].y)));
    }
    return CSG_SWEEP_NOISE * size;
}

static bool replace(struct csg_drawing *drawing, uint32_t node, const struct polygon *polygon)
{
    const uint32_t end = drawing->nodes.data[node].end;
    const double rounding = csg_drawing_rounding(drawing, node, end);
    const bool facetted = csg_drawing_is_facetted(drawing, node, end);
    csg_drawing_drop(drawing, node);
    if (!csg_drawing_add_figure(drawing, rounding))
        return false;
    drawing->figures.data[drawing->figures.num - 1].facetted = facetted;
    bool ok = polygon->points.num < 3 || csg_drawing_add_contour(drawing);
    for (size_t i = 0; i < polygon->points.num && polygon->points.num >= 3 && ok; i++)
        ok = csg_drawing_add_point(drawing, polygon->points.data[i].x, polygon->points.data[i].y);
    return ok;
}

bool csg_drawing_intersect(struct csg_drawing *drawing, uint32_t node)
{
    struct polygon polygon = {0};
    if (!are_polygons(drawing, node))
        return true;
    const double noise = noise_of(drawing, node);
    bool ok = start(&polygon, drawing, find_polygon(drawing, node + 1));
    for (uint32_t i = drawing->nodes.data[node + 1].end; i < drawing->nodes.data[node].end && ok;
         i = drawing->nodes.data[i].end)
        ok = clip_to(&polygon, drawing, find_polygon(drawing, i), noise);
    ok = ok && replace(drawing, node, &polygon);
    free(polygon.points.data);
    return ok;
}
