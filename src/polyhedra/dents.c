/* SPDX-License-Identifier: MIT */
/*
 * How far a closed mesh is from being convex: by the angles at its edges, as OpenSCAD 2021.01
 * judges it (is_approximately_convex in its cgalutils.cc). Which side of the faces is outside need
 * not be known: seen from the wrong side the sharp edges are the dents.
 */
#include <stdlib.h>

#include "polyhedra/edges.h"
#include "solids/facets.h"

struct dents {
    const struct csg_mesh *mesh;
    struct csg_mesh_edges edges;
    struct csg_vec3 *points, *normals; /* mapped; of faces */
    uint32_t *parents;                 /* of faces, in the forest of those that share edges */
    size_t num_trees;
    double near, cos_limit;
    bool is_there[2], is_deep[2]; /* a dent as seen from the one side or the other */
};

static bool start(struct dents *dents, const struct csg_mesh *mesh)
{
    dents->mesh = mesh;
    dents->points = malloc((mesh->points.num + 1) * sizeof *dents->points);
    dents->normals = malloc((mesh->faces.num + 1) * sizeof *dents->normals);
    dents->parents = malloc((mesh->faces.num + 1) * sizeof *dents->parents);
    return csg_mesh_edges_init(&dents->edges, mesh) && dents->points && dents->normals &&
           dents->parents;
}

static void finish(struct dents *dents)
{
    csg_mesh_edges_finish(&dents->edges);
    free(dents->points);
    free(dents->normals);
    free(dents->parents);
}

static struct csg_vec3 corner(const struct dents *dents, uint32_t i)
{
    return dents->points[dents->mesh->corners.data[i]];
}

/* Newell's; 0 of a face without area. */
static struct csg_vec3 normal_of(const struct dents *dents, const struct csg_mesh_face *face)
{
    const struct csg_vec3 origin = corner(dents, face->begin);
    struct csg_vec3 normal = {0, 0, 0};
    for (uint32_t i = face->begin + 1; i + 1 < face->end; i++)
        normal = csg_add(normal, csg_cross(csg_sub(corner(dents, i), origin),
                                           csg_sub(corner(dents, i + 1), origin)));
    return csg_length(normal) > 0 ? csg_normalize(normal) : normal;
}

static void place(struct dents *dents, const struct csg_map *map)
{
    const struct csg_mesh *mesh = dents->mesh;
    double size = 0;
    for (size_t i = 0; i < mesh->points.num; i++) {
        dents->points[i] = csg_map_point(map, mesh->points.data[i]);
        size = fmax(size, csg_length(dents->points[i]));
    }
    for (uint32_t i = 0; i < mesh->faces.num; i++) {
        dents->normals[i] = normal_of(dents, &mesh->faces.data[i]);
        dents->parents[i] = i;
    }
    dents->num_trees = mesh->faces.num;
    dents->near = CSG_MESH_ON_PLANE * size;
    if (mesh->size > 0)
        dents->near += 2 * mesh->rounding * size / mesh->size;
}

static uint32_t find_root(uint32_t *parents, uint32_t face)
{
    while (parents[face] != face)
        face = parents[face] = parents[parents[face]];
    return face;
}

static void join(struct dents *dents, uint32_t a, uint32_t b)
{
    const uint32_t x = find_root(dents->parents, a), y = find_root(dents->parents, b);
    dents->num_trees -= x != y;
    dents->parents[x] = y;
}

/* How far the face's corners are from a plane through origin. */
static double distance_of(const struct dents *dents, uint32_t face, struct csg_vec3 normal,
                          struct csg_vec3 origin)
{
    const struct csg_mesh_face *f = &dents->mesh->faces.data[face];
    double distance = 0;
    for (uint32_t i = f->begin; i < f->end; i++)
        distance = fmax(distance, fabs(csg_dot(normal, csg_sub(corner(dents, i), origin))));
    return distance;
}

/* up runs along the edge from low to high, down the other way. */
static void judge(struct dents *dents, uint32_t low, uint32_t high, uint32_t up, uint32_t down)
{
    const struct csg_vec3 a = dents->points[low], b = dents->points[high];
    const struct csg_vec3 n = dents->normals[up], m = dents->normals[down];
    const bool side = csg_dot(csg_cross(n, m), csg_sub(b, a)) > 0;
    dents->is_deep[side] |= csg_dot(n, m) < dents->cos_limit;
    dents->is_there[side] |= distance_of(dents, up, m, a) > dents->near;
    join(dents, up, down);
}

/* false: two faces do not meet at each edge, in opposite directions, or there are deep dents. */
static bool judge_point(struct dents *dents, uint32_t low)
{
    const uint32_t end = dents->edges.begin[low + 1];
    for (uint32_t i = dents->edges.begin[low]; i < end; i += 2) {
        const struct csg_mesh_edge *edge = &dents->edges.edges[i];
        if (csg_mesh_edges_run(&dents->edges, i, end) != i + 2 ||
            edge[0].direction == edge[1].direction)
            return false;
        const int up = edge[0].direction < 0;
        judge(dents, low, edge->high, edge[up].face, edge[!up].face);
    }
    return !dents->is_deep[0] || !dents->is_deep[1];
}

static bool is_nearly_convex(struct dents *dents)
{
    for (uint32_t low = 0; low < dents->mesh->points.num; low++)
        if (!judge_point(dents, low))
            return false;
    return dents->num_trees == 1;
}

bool csg_mesh_find_dents(const struct csg_mesh *mesh, const struct csg_map *map, double degrees,
                         bool *are_shallow, bool *are_there)
{
    struct dents dents = {.cos_limit = csg_cos_degrees(degrees)};
    const bool ok = start(&dents, mesh);
    if (ok) {
        place(&dents, map);
        *are_shallow = is_nearly_convex(&dents);
        *are_there = dents.is_there[dents.is_deep[0]];
    }
    finish(&dents);
    return ok;
}
