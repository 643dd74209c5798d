/* SPDX-License-Identifier: MIT */
/*
 * OpenSCAD takes faces in any order of corners; here the faces of a mesh are turned until those
 * that share an edge run along it in opposite directions. Where they cannot, the mesh has a gap.
 */
#include <stdlib.h>

#include "polyhedra/mesh.h"

/* A directed edge, in the list of its end with the smaller number. */
struct edge {
    uint32_t high, face;
    int8_t direction; /* 1: from low to high */
};

/* A face in the forest of faces known to belong together. */
struct link {
    uint32_t parent, size;
    bool turned; /* with regard to its parent */
};

struct orient {
    struct csg_mesh *mesh;
    uint32_t *begin; /* by point: its edges */
    struct edge *edges;
    struct link *links;
};

static int compare_edges(const void *a, const void *b)
{
    const struct edge *x = a, *y = b;
    if (x->high != y->high)
        return x->high < y->high ? -1 : 1;
    return x->face < y->face ? -1 : x->face > y->face;
}

static uint32_t next_corner(const struct csg_mesh_face *face, uint32_t corner)
{
    return corner + 1 < face->end ? corner + 1 : face->begin;
}

/* Calls for each directed edge of the mesh; counts where place is false. */
static void scatter(struct orient *orient, bool place)
{
    const struct csg_mesh *mesh = orient->mesh;
    for (uint32_t i = 0; i < mesh->faces.num; i++) {
        const struct csg_mesh_face *face = &mesh->faces.data[i];
        for (uint32_t j = face->begin; j < face->end; j++) {
            const uint32_t a = mesh->corners.data[j];
            const uint32_t b = mesh->corners.data[next_corner(face, j)];
            const uint32_t low = a < b ? a : b, high = a < b ? b : a;
            if (place)
                orient->edges[orient->begin[low + 1]++] = (struct edge){high, i, a < b ? 1 : -1};
            else
                orient->begin[low + 2]++;
        }
    }
}

/* Counting sort by the lower end, then the few edges of each by the higher one. */
static void list_edges(struct orient *orient)
{
    const size_t num = orient->mesh->points.num;
    scatter(orient, false);
    for (size_t i = 2; i < num + 2; i++)
        orient->begin[i] += orient->begin[i - 1];
    scatter(orient, true);
    for (size_t i = 0; i < num; i++) {
        const size_t length = orient->begin[i + 1] - orient->begin[i];
        if (length > 1)
            qsort(&orient->edges[orient->begin[i]], length, sizeof *orient->edges, compare_edges);
    }
}

/* The root of a face's tree, with the path to it shortened; *turned with regard to it. */
static uint32_t find_root(struct link *links, uint32_t face, bool *turned)
{
    *turned = false;
    while (links[face].parent != face) {
        struct link *link = &links[face];
        const struct link *above = &links[link->parent];
        if (above->parent != link->parent) {
            link->turned = link->turned != above->turned;
            link->parent = above->parent;
        }
        *turned = *turned != link->turned;
        face = link->parent;
    }
    return face;
}

static void join(struct link *links, uint32_t a, uint32_t b, bool turned)
{
    bool a_turned, b_turned;
    uint32_t x = find_root(links, a, &a_turned), y = find_root(links, b, &b_turned);
    if (x == y)
        return;
    if (links[x].size < links[y].size) {
        const uint32_t root = x;
        x = y;
        y = root;
    }
    links[y].parent = x;
    links[y].turned = (a_turned != b_turned) != turned;
    links[x].size += links[y].size;
}

/* The end of the run of edges at i that have the same ends. */
static uint32_t run_end(const struct orient *orient, uint32_t i, uint32_t end)
{
    uint32_t j = i + 1;
    while (j < end && orient->edges[j].high == orient->edges[i].high)
        j++;
    return j;
}

static void link_faces(struct orient *orient)
{
    const struct csg_mesh *mesh = orient->mesh;
    for (uint32_t i = 0; i < mesh->faces.num; i++)
        orient->links[i] = (struct link){i, 1, false};
    for (size_t low = 0; low < mesh->points.num; low++)
        for (uint32_t i = orient->begin[low], j; i < orient->begin[low + 1]; i = j) {
            const struct edge *edge = &orient->edges[i];
            j = run_end(orient, i, orient->begin[low + 1]);
            if (j == i + 2)
                join(orient->links, edge[0].face, edge[1].face,
                     edge[0].direction == edge[1].direction);
        }
}

static void reverse(struct csg_mesh *mesh, const struct csg_mesh_face *face)
{
    for (uint32_t i = face->begin, j = face->end - 1; i < j; i++, j--) {
        const uint32_t corner = mesh->corners.data[i];
        mesh->corners.data[i] = mesh->corners.data[j];
        mesh->corners.data[j] = corner;
    }
}

/* The fewer faces of each piece are turned; votes[root] is negative where those are the root's. */
static bool turn_faces(struct orient *orient)
{
    struct csg_mesh *mesh = orient->mesh;
    int64_t *votes = calloc(mesh->faces.num + 1, sizeof *votes);
    if (!votes)
        return false;
    for (uint32_t i = 0; i < mesh->faces.num; i++) {
        bool turned;
        const uint32_t root = find_root(orient->links, i, &turned);
        votes[root] += turned ? -1 : 1;
    }
    for (uint32_t i = 0; i < mesh->faces.num; i++) {
        bool turned;
        const uint32_t root = find_root(orient->links, i, &turned);
        orient->links[i].size = turned != (votes[root] < 0); /* from here on: is turned over */
        if (orient->links[i].size)
            reverse(mesh, &mesh->faces.data[i]);
    }
    free(votes);
    return true;
}

/* Whether faces may lie upon each other at the edges [i, j), which have the same ends. */
static bool is_folded(const struct orient *orient, uint32_t i, uint32_t j, uint32_t begin)
{
    const struct edge *edge = &orient->edges[i];
    return j > i + 2 || (j == i + 2 && i >= begin + 2 && edge[0].face == edge[-2].face &&
                         edge[1].face == edge[-1].face);
}

static void count_gaps(const struct orient *orient, struct csg_mesh_gaps *gaps)
{
    *gaps = (struct csg_mesh_gaps){0};
    for (uint32_t low = 0; low < orient->mesh->points.num; low++)
        for (uint32_t i = orient->begin[low], j; i < orient->begin[low + 1]; i = j) {
            int sum = 0;
            j = run_end(orient, i, orient->begin[low + 1]);
            gaps->is_folded |= is_folded(orient, i, j, orient->begin[low]);
            for (uint32_t k = i; k < j; k++) {
                const struct edge *edge = &orient->edges[k];
                sum += orient->links[edge->face].size ? -edge->direction : edge->direction;
            }
            if (sum == 0)
                continue;
            if (gaps->num++ == 0) {
                gaps->points[0] = low;
                gaps->points[1] = orient->edges[i].high;
            }
        }
}

bool csg_mesh_orient(struct csg_mesh *mesh, struct csg_mesh_gaps *gaps)
{
    struct orient orient = {.mesh = mesh};
    orient.begin = calloc(mesh->points.num + 2, sizeof *orient.begin);
    orient.edges = malloc((mesh->corners.num + 1) * sizeof *orient.edges);
    orient.links = malloc((mesh->faces.num + 1) * sizeof *orient.links);
    bool ok = orient.begin && orient.edges && orient.links;
    if (ok) {
        list_edges(&orient);
        link_faces(&orient);
        ok = turn_faces(&orient);
    }
    if (ok)
        count_gaps(&orient, gaps);
    free(orient.begin);
    free(orient.edges);
    free(orient.links);
    return ok;
}
