/* SPDX-License-Identifier: MIT */
/*
 * Gaps are filled with fans. The edges that faces leave over form closed walks, as the boundary of
 * a boundary is nothing; walks are cut into loops that pass no corner twice, and a fan over each of
 * them takes back all of its edges.
 */
#include <stdlib.h>
#include <string.h>

#include "mesh/surface.h"
#include "solids/shape.h"

/* Corners of a gap that are off its plane by less than this share of the size lie on it. */
#define FLAT_SHARE 1e-12

struct edge {
    uint32_t from, to;
};

struct closer {
    struct csg_surface *surface;
    CSG_ARRAY(struct edge) edges; /* all of the triangles', then those that fans must have */
    uint32_t *roots;              /* by point: another one of its piece, see root_of */
    uint32_t *next;               /* by point: its first edge not walked yet */
    uint32_t *place;              /* by point: 1 + where it is on the walk, 0: it is not */
    CSG_ARRAY(uint32_t) walk;
};

static uint32_t root_of(struct closer *closer, uint32_t point)
{
    uint32_t *roots = closer->roots;
    while (roots[point] != point)
        point = roots[point] = roots[roots[point]];
    return point;
}

/* By their ends, whichever is first. */
static int compare_ends(const void *a, const void *b)
{
    const struct edge *x = a, *y = b;
    const uint32_t xs[2] = {x->from < x->to ? x->from : x->to, x->from < x->to ? x->to : x->from};
    const uint32_t ys[2] = {y->from < y->to ? y->from : y->to, y->from < y->to ? y->to : y->from};
    const int i = xs[0] == ys[0];
    return xs[i] < ys[i] ? -1 : xs[i] > ys[i];
}

static int compare_from(const void *a, const void *b)
{
    const struct edge *x = a, *y = b;
    if (x->from != y->from)
        return x->from < y->from ? -1 : 1;
    return x->to < y->to ? -1 : x->to > y->to;
}

static bool list_edges(struct closer *closer)
{
    const struct csg_surface *surface = closer->surface;
    for (size_t i = 0; i < surface->triangles.num; i++) {
        const uint32_t *points = surface->triangles.data[i].points;
        for (int j = 0; j < 3; j++) {
            const struct edge edge = {points[j], points[(j + 1) % 3]};
            if (edge.from != edge.to && !csg_array_push(&closer->edges, edge))
                return false;
            closer->roots[root_of(closer, edge.from)] = root_of(closer, edge.to);
        }
    }
    if (closer->edges.num > 1)
        qsort(closer->edges.data, closer->edges.num, sizeof *closer->edges.data, compare_ends);
    return true;
}

/* Of the edges between two points those that others do not take back, the other way round. */
static void keep_gaps(struct closer *closer)
{
    struct edge *edges = closer->edges.data;
    const size_t num = closer->edges.num;
    size_t kept = 0;
    for (size_t i = 0, j; i < num; i = j) {
        const struct edge first = edges[i];
        long balance = 0;
        for (j = i; j < num && compare_ends(&edges[j], &first) == 0; j++)
            balance += edges[j].from == first.from ? 1 : -1;
        const struct edge missing = balance > 0 ? (struct edge){first.to, first.from} : first;
        for (; balance != 0; balance += balance > 0 ? -1 : 1)
            edges[kept++] = missing;
    }
    closer->edges.num = kept;
}

/* A piece with more edges left over than it has triangles is a sheet, or lies about in pieces
 * whose corners do not meet: filled, nothing would be left of it. */
static bool drop_sheets(struct closer *closer)
{
    const struct csg_surface *surface = closer->surface;
    size_t *triangles = calloc(surface->points.num, sizeof *triangles);
    size_t *gaps = calloc(surface->points.num, sizeof *gaps);
    const bool ok = triangles && gaps;
    for (size_t i = 0; i < surface->triangles.num && ok; i++)
        triangles[root_of(closer, surface->triangles.data[i].points[0])]++;
    for (size_t i = 0; i < closer->edges.num && ok; i++)
        gaps[root_of(closer, closer->edges.data[i].from)]++;
    size_t kept = 0;
    for (size_t i = 0; i < closer->edges.num && ok; i++) {
        const uint32_t root = root_of(closer, closer->edges.data[i].from);
        if (gaps[root] <= triangles[root])
            closer->edges.data[kept++] = closer->edges.data[i];
    }
    closer->surface->open = kept < closer->edges.num;
    closer->edges.num = kept;
    free(triangles);
    free(gaps);
    return ok;
}

static struct csg_vec3 point_of(const struct closer *closer, uint32_t i)
{
    return closer->surface->points.data[closer->walk.data[i]];
}

/* Of the fan's triangles from corner begin on: their common plane, or their mean one (Newell). */
static struct csg_plane plane_of(const struct closer *closer, uint32_t first, uint32_t begin,
                                 uint32_t end)
{
    const struct csg_vec3 origin = point_of(closer, first);
    const struct csg_vec3 along = csg_sub(point_of(closer, begin), origin);
    struct csg_vec3 area = {0, 0, 0};
    for (uint32_t i = begin; i + 1 < end; i++)
        area = csg_add(area, csg_cross(csg_sub(point_of(closer, i), origin),
                                       csg_sub(point_of(closer, i + 1), origin)));
    struct csg_vec3 normal = csg_normalize(area);
    if (!(csg_length(normal) > 0.5)) /* without area: any plane along an edge */
        normal = csg_normalize(csg_cross(along, fabs(along.x) < fabs(along.y) ? csg_vec3(1, 0, 0)
                                                                              : csg_vec3(0, 1, 0)));
    if (!(csg_length(normal) > 0.5))
        normal = csg_vec3(0, 0, 1);
    return (struct csg_plane){normal, csg_dot(normal, origin)};
}

static bool is_flat(const struct closer *closer, const struct csg_plane *plane, uint32_t first)
{
    bool flat = true;
    for (uint32_t i = first; i < closer->walk.num; i++)
        flat &= fabs(csg_dot(plane->normal, point_of(closer, i)) - plane->offset) <=
                FLAT_SHARE * closer->surface->size;
    return flat;
}

/* A fan over the walk's corners from first on. One plane holds it where they lie on one. */
static bool fill_loop(struct closer *closer, uint32_t first)
{
    struct csg_surface *surface = closer->surface;
    const uint32_t num = (uint32_t)closer->walk.num, *walk = closer->walk.data;
    const struct csg_plane all = plane_of(closer, first, first + 1, num);
    const bool flat = is_flat(closer, &all, first);
    bool ok = true;
    for (uint32_t i = first + 1; i + 1 < num && ok; i++) {
        const struct csg_plane plane = flat ? all : plane_of(closer, first, i, i + 2);
        ok = ((flat && i > first + 1) || csg_array_push(&surface->planes, plane)) &&
             csg_array_push(&surface->triangles,
                            ((struct csg_triangle){{walk[first], walk[i], walk[i + 1]},
                                                   (uint32_t)surface->planes.num - 1}));
    }
    return ok;
}

/* Takes the loop that ends where the walk has come back to, at the walk's corner first. */
static bool take_loop(struct closer *closer, uint32_t first)
{
    const bool ok = fill_loop(closer, first);
    for (uint32_t i = first + 1; i < closer->walk.num; i++)
        closer->place[closer->walk.data[i]] = 0;
    closer->walk.num = first + 1;
    return ok;
}

/* Walks from the edge's start until no way leads on, which is back there. */
static bool walk_from(struct closer *closer, uint32_t point)
{
    const struct edge *edges = closer->edges.data;
    bool ok = csg_array_push(&closer->walk, point);
    closer->place[point] = 1;
    while (ok && closer->next[point] < closer->edges.num &&
           edges[closer->next[point]].from == point) {
        point = edges[closer->next[point]++].to;
        if (closer->place[point] > 0) {
            ok = take_loop(closer, closer->place[point] - 1);
        } else {
            ok = csg_array_push(&closer->walk, point);
            closer->place[point] = (uint32_t)closer->walk.num;
        }
    }
    for (size_t i = 0; i < closer->walk.num; i++)
        closer->place[closer->walk.data[i]] = 0;
    closer->walk.num = 0;
    return ok;
}

static bool fill_gaps(struct closer *closer)
{
    const struct edge *edges = closer->edges.data;
    if (closer->edges.num > 1)
        qsort(closer->edges.data, closer->edges.num, sizeof *closer->edges.data, compare_from);
    for (size_t i = closer->edges.num; i-- > 0;)
        closer->next[edges[i].from] = (uint32_t)i;
    bool ok = true;
    for (size_t i = 0; i < closer->edges.num && ok; i++)
        if (closer->next[edges[i].from] == i)
            ok = walk_from(closer, edges[i].from);
    return ok;
}

static bool start(struct closer *closer)
{
    const size_t num = closer->surface->points.num;
    closer->roots = malloc((num + 1) * sizeof *closer->roots);
    closer->next = calloc(num + 1, sizeof *closer->next);
    closer->place = calloc(num + 1, sizeof *closer->place);
    for (uint32_t i = 0; i < num && closer->roots; i++)
        closer->roots[i] = i;
    return closer->roots && closer->next && closer->place;
}

static bool fill(struct csg_surface *surface)
{
    struct closer closer = {.surface = surface};
    bool ok = start(&closer) && list_edges(&closer);
    if (ok)
        keep_gaps(&closer);
    ok = ok && drop_sheets(&closer) && fill_gaps(&closer);
    free(closer.edges.data);
    free(closer.roots);
    free(closer.next);
    free(closer.place);
    free(closer.walk.data);
    return ok;
}

struct csg_surface *csg_surface_closed(struct csg_surface *surface)
{
    if (surface->is_filled)
        return csg_surface_share(surface);
    if (!surface->closed) {
        struct csg_surface *closed = csg_surface_copy(surface);
        if (!closed || !fill(closed)) {
            csg_surface_destroy(closed);
            return NULL;
        }
        closed->is_filled = true;
        csg_surface_measure(closed);
        surface->closed = closed;
    }
    return csg_surface_share(surface->closed);
}
