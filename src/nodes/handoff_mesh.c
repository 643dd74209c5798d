/* SPDX-License-Identifier: MIT */
#include "nodes/handoff_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of a triangle without its normal, see is_whole_record. */
enum { SHORT_RECORD = CSG_STL_RECORD - CSG_STL_POINT };

static const double unit_slack = 1e-4; /* of the length of a normal computed in float */

static bool is_same(struct csg_vec3 a, struct csg_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/*
 * OpenSCAD 2021.01 writes no normal where two corners of a triangle are the same as floats
 * (export_stl.cc, append_stl): such a record has 38 bytes instead of 50. Of a whole one the first
 * three floats are a unit normal or zeroes, and the corners behind them differ.
 */
static bool is_whole_record(const char *bytes, size_t rest)
{
    if (rest < CSG_STL_RECORD)
        return false;
    const struct csg_vec3 a = csg_stl_point(bytes + 12), b = csg_stl_point(bytes + 24),
                          c = csg_stl_point(bytes + 36);
    const double length = csg_length(csg_stl_point(bytes));
    return (length == 0 || fabs(length - 1) < unit_slack) && !is_same(a, b) && !is_same(b, c) &&
           !is_same(a, c);
}

static enum csg_mesh_file read_triangles(const struct csg_bytes *bytes, struct csg_mesh *mesh)
{
    bool ok = true;
    uint32_t num = 0;
    if (bytes->num < CSG_STL_HEADER + CSG_STL_COUNT || bytes->num / SHORT_RECORD > UINT32_MAX / 3)
        return CSG_MESH_FILE_MALFORMED;
    for (size_t at = CSG_STL_HEADER + CSG_STL_COUNT; at < bytes->num && ok;) {
        const size_t rest = bytes->num - at;
        const bool is_whole = is_whole_record(bytes->data + at, rest);
        if (!is_whole && rest < SHORT_RECORD)
            return CSG_MESH_FILE_MALFORMED;
        bool is_left_out = false;
        if (is_whole)
            ok = csg_stl_add(mesh, bytes->data + at + CSG_STL_POINT, &is_left_out);
        if (is_left_out)
            return CSG_MESH_FILE_MALFORMED;
        at += is_whole ? CSG_STL_RECORD : SHORT_RECORD;
        num++;
    }
    if (ok && num != csg_stl_uint32(bytes->data + CSG_STL_HEADER)) /* where the disk was full */
        return CSG_MESH_FILE_MALFORMED;
    csg_stl_end(mesh);
    return ok && csg_mesh_clean(mesh, NULL) ? CSG_MESH_FILE_DONE : CSG_MESH_FILE_NO_MEMORY;
}

enum csg_mesh_file csg_stl_read(const struct csg_bytes *bytes, struct csg_mesh *mesh)
{
    const enum csg_mesh_file result = read_triangles(bytes, mesh);
    if (result == CSG_MESH_FILE_MALFORMED) {
        csg_mesh_finish(mesh);
        *mesh = (struct csg_mesh){0};
    }
    return result;
}

/* ---- outlines ----------------------------------------------------------------------------- */

struct edge {
    uint32_t from, to;
    bool is_used; /* in a contour, or in both directions */
};

struct edges {
    CSG_ARRAY(struct edge) list; /* sorted by from, then to */
};

static int compare_edges(const void *left, const void *right)
{
    const struct edge *a = left, *b = right;
    if (a->from != b->from)
        return a->from < b->from ? -1 : 1;
    return a->to < b->to ? -1 : a->to > b->to;
}

static bool is_on_floor(const struct csg_mesh *mesh, const struct csg_mesh_face *face)
{
    bool on_floor = true;
    for (uint32_t i = face->begin; i < face->end; i++)
        on_floor = on_floor && mesh->points.data[mesh->corners.data[i]].z == 0;
    return on_floor;
}

static bool add_edges(const struct csg_mesh *mesh, const struct csg_mesh_face *face,
                      struct edges *edges)
{
    bool ok = true;
    for (uint32_t i = face->begin; i < face->end && ok; i++) {
        const uint32_t next = i + 1 < face->end ? i + 1 : face->begin;
        const struct edge edge = {mesh->corners.data[i], mesh->corners.data[next], false};
        ok = csg_array_push(&edges->list, edge);
    }
    return ok;
}

/* The first edge not before (from, to) in the list. */
static size_t find_edge(const struct edges *edges, uint32_t from, uint32_t to)
{
    const struct edge wanted = {from, to, false};
    size_t low = 0, high = edges->list.num;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (compare_edges(&edges->list.data[middle], &wanted) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Triangles side by side go along their common edge in opposite directions. */
static void cancel_inner_edges(struct edges *edges)
{
    for (size_t i = 0; i < edges->list.num; i++) {
        struct edge *edge = &edges->list.data[i];
        size_t j = find_edge(edges, edge->to, edge->from);
        while (!edge->is_used && j < edges->list.num && edges->list.data[j].from == edge->to &&
               edges->list.data[j].to == edge->from) {
            if (!edges->list.data[j].is_used)
                edges->list.data[j].is_used = edge->is_used = true;
            j++;
        }
    }
}

/* An unused edge that starts at the point; NULL: there is none. */
static struct edge *next_edge(struct edges *edges, uint32_t from)
{
    size_t i = find_edge(edges, from, 0);
    while (i < edges->list.num && edges->list.data[i].from == from && edges->list.data[i].is_used)
        i++;
    return i < edges->list.num && edges->list.data[i].from == from ? &edges->list.data[i] : NULL;
}

/* Where contours touch, any way to go on will do: what an odd number of them goes round stays. */
static bool add_contour(const struct csg_mesh *mesh, const struct csg_map *map, struct edges *edges,
                        struct edge *edge, struct csg_drawing *drawing)
{
    bool ok = csg_drawing_add_contour(drawing);
    for (; edge && ok; edge = next_edge(edges, edge->to)) {
        const struct csg_vec3 p = csg_map_point(map, mesh->points.data[edge->from]);
        edge->is_used = true;
        ok = csg_drawing_add_point(drawing, p.x, p.y);
    }
    return ok;
}

bool csg_stl_outline(const struct csg_mesh *mesh, const struct csg_map *map, double rounding,
                     struct csg_drawing *drawing)
{
    struct edges edges = {0};
    bool ok = csg_drawing_add_figure(drawing, rounding);
    for (size_t i = 0; i < mesh->faces.num && ok; i++)
        if (is_on_floor(mesh, &mesh->faces.data[i]))
            ok = add_edges(mesh, &mesh->faces.data[i], &edges);
    if (ok && edges.list.num > 0) {
        qsort(edges.list.data, edges.list.num, sizeof *edges.list.data, compare_edges);
        cancel_inner_edges(&edges);
    }
    for (size_t i = 0; i < edges.list.num && ok; i++)
        if (!edges.list.data[i].is_used)
            ok = add_contour(mesh, map, &edges, &edges.list.data[i], drawing);
    free(edges.list.data);
    return ok;
}
