/* SPDX-License-Identifier: MIT */
/*
 * OpenSCAD takes faces in any order of corners; here the faces of a mesh are turned until those
 * that share an edge run along it in opposite directions. Where they cannot, the mesh has a gap.
 */
#include <stdlib.h>

#include "polyhedra/edges.h"

/* A face in the forest of faces known to belong together. */
struct link {
    uint32_t parent, size;
    bool turned; /* with regard to its parent */
};

struct orient {
    struct csg_mesh *mesh;
    struct csg_mesh_edges edges;
    struct link *links;
};

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

static void link_faces(struct orient *orient)
{
    const struct csg_mesh *mesh = orient->mesh;
    for (uint32_t i = 0; i < mesh->faces.num; i++)
        orient->links[i] = (struct link){i, 1, false};
    for (size_t low = 0; low < mesh->points.num; low++)
        for (uint32_t i = orient->edges.begin[low], j; i < orient->edges.begin[low + 1]; i = j) {
            const struct csg_mesh_edge *edge = &orient->edges.edges[i];
            j = csg_mesh_edges_run(&orient->edges, i, orient->edges.begin[low + 1]);
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
    const struct csg_mesh_edge *edge = &orient->edges.edges[i];
    return j > i + 2 || (j == i + 2 && i >= begin + 2 && edge[0].face == edge[-2].face &&
                         edge[1].face == edge[-1].face);
}

static void count_gaps(const struct orient *orient, struct csg_mesh_gaps *gaps)
{
    *gaps = (struct csg_mesh_gaps){0};
    for (uint32_t low = 0; low < orient->mesh->points.num; low++)
        for (uint32_t i = orient->edges.begin[low], j; i < orient->edges.begin[low + 1]; i = j) {
            int sum = 0;
            j = csg_mesh_edges_run(&orient->edges, i, orient->edges.begin[low + 1]);
            gaps->is_folded |= is_folded(orient, i, j, orient->edges.begin[low]);
            for (uint32_t k = i; k < j; k++) {
                const struct csg_mesh_edge *edge = &orient->edges.edges[k];
                sum += orient->links[edge->face].size ? -edge->direction : edge->direction;
            }
            if (sum == 0)
                continue;
            if (gaps->num++ == 0) {
                gaps->points[0] = low;
                gaps->points[1] = orient->edges.edges[i].high;
            }
        }
}

bool csg_mesh_orient(struct csg_mesh *mesh, struct csg_mesh_gaps *gaps)
{
    struct orient orient = {.mesh = mesh};
    orient.links = malloc((mesh->faces.num + 1) * sizeof *orient.links);
    bool ok = csg_mesh_edges_init(&orient.edges, mesh) && orient.links;
    if (ok) {
        link_faces(&orient);
        ok = turn_faces(&orient);
    }
    if (ok)
        count_gaps(&orient, gaps);
    csg_mesh_edges_finish(&orient.edges);
    free(orient.links);
    return ok;
}
