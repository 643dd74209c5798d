/* SPDX-License-Identifier: MIT */
#include "nodes/sets.h"

#include <stdlib.h>

#include "mesh/surface.h"
#include "polyhedra/mesh.h"

void csg_sets_finish(struct csg_sets *sets)
{
    csg_clusters_finish(&sets->convex);
    for (size_t i = 0; i < sets->surfaces.num; i++)
        csg_shape_finish(&sets->surfaces.data[i]);
    free(sets->surfaces.data);
    *sets = (struct csg_sets){0};
}

static void add_origin(struct csg_sets *sets, const struct csg_part *part)
{
    sets->has_flat |= part->has_flat;
    for (size_t i = 0; i < part->shapes.num; i++) {
        sets->rounding = fmax(sets->rounding, part->shapes.data[i].rounding);
        sets->facetted |= part->shapes.data[i].facetted;
    }
}

/* Says what went wrong; false when memory is out. */
static bool report(struct csg_walk *walk, uint32_t node, enum csg_hull_result result)
{
    const char *name = csg_walk_ops(walk, node)->name;
    if (result == CSG_HULL_NO_MEMORY)
        return csg_walk_no_memory(walk);
    if (result == CSG_HULL_MISSING)
        csg_walk_unsupported(walk, node,
                             "%s needs the Qhull library, which csgcast was built "
                             "without (Debian: libqhull-dev)",
                             name);
    else if (result == CSG_HULL_FLAT)
        csg_walk_unsupported(walk, node, "%s: the Booleans in it have too many pieces", name);
    return true;
}

bool csg_sets_take_surfaces(struct csg_sets *sets, struct csg_part *part)
{
    bool ok = true;
    for (size_t i = csg_part_next_uncut(part, 0); i < part->tree.num && ok;
         i = csg_part_next_uncut(part, i + 1)) {
        struct csg_node *node = &part->tree.data[i];
        if (!part->shapes.data[node->leaf].surface)
            continue;
        ok = csg_array_push(&sets->surfaces, part->shapes.data[node->leaf]);
        if (ok)
            part->shapes.data[node->leaf] = (struct csg_shape){.frame = csg_map_identity};
        node->op = CSG_OR;
        node->leaf = 0;
    }
    return ok;
}

static bool add_moved(struct csg_sets *sets, const struct csg_shape *surface, struct csg_vec3 by)
{
    struct csg_map map = csg_map_identity;
    struct csg_shape moved;
    map.m[0][3] = by.x;
    map.m[1][3] = by.y;
    map.m[2][3] = by.z;
    if (!csg_shape_copy(&moved, surface))
        return false;
    if (csg_shape_map(&moved, &map) && csg_array_push(&sets->surfaces, moved))
        return true;
    csg_shape_finish(&moved);
    return false;
}

static bool add_triangles(struct csg_sets *sets, const struct csg_surface *surface,
                          const struct csg_vec3 *corners, size_t num)
{
    bool ok = true;
    for (size_t i = 0; i < surface->triangles.num && ok; i++) {
        struct csg_vec3 triangle[3];
        for (int j = 0; j < 3; j++)
            triangle[j] = surface->points.data[surface->triangles.data[i].points[j]];
        ok = csg_clusters_add_sum(&sets->convex, triangle, 3, corners, num);
    }
    return ok;
}

bool csg_sets_add_sum(struct csg_sets *sets, const struct csg_shape *surface,
                      const struct csg_vec3 *corners, size_t num)
{
    struct csg_surface *placed = csg_surface_placed(surface->surface, &surface->frame);
    const bool ok =
        placed && add_moved(sets, surface, corners[0]) && add_triangles(sets, placed, corners, num);
    csg_surface_destroy(placed);
    return ok;
}

static enum csg_hull_result evaluate(struct csg_sets *sets, struct csg_part *part,
                                     enum csg_part_wanted wanted)
{
    if (part->is_too_large)
        return CSG_HULL_FLAT;
    if (wanted != CSG_WANT_POINTS && !csg_sets_take_surfaces(sets, part))
        return CSG_HULL_NO_MEMORY;
    return csg_part_evaluate(part, wanted == CSG_WANT_POINTS, &sets->convex);
}

bool csg_sets_read(struct csg_walk *walk, uint32_t node, uint32_t begin, uint32_t end,
                   bool in_boolean, enum csg_part_wanted wanted, struct csg_sets *sets,
                   bool *is_there)
{
    struct csg_part inner = {0};
    bool ok = csg_part_read(walk, begin, end, in_boolean, wanted, &inner);
    if (ok) {
        add_origin(sets, &inner);
        const enum csg_hull_result result = evaluate(sets, &inner, wanted);
        *is_there = result == CSG_HULL_DONE;
        ok = report(walk, node, result);
    }
    csg_part_finish(&inner);
    return ok;
}

/* Where only the points of a hull matter they are those that it was made of: the corners of a thin
 * one follow from its planes badly. */
static bool take_points(const struct csg_points *points, struct csg_shape *shape)
{
    struct csg_mesh mesh = {.rounding = shape->rounding};
    bool ok = true;
    for (size_t i = 0; i < points->points.num && ok; i++)
        ok = csg_mesh_add_point(&mesh, points->points.data[i]) &&
             csg_array_push(&mesh.corners, (uint32_t)i);
    csg_shape_finish(shape);
    *shape = (struct csg_shape){.frame = csg_map_identity};
    ok = ok && csg_mesh_to_points(&mesh, shape);
    csg_mesh_finish(&mesh);
    return ok;
}

bool csg_sets_add_hull(struct csg_walk *walk, uint32_t node, const struct csg_sets *sets,
                       const struct csg_points *points, struct csg_part *part)
{
    struct csg_shape shape = {.frame = csg_map_identity};
    enum csg_hull_result result = csg_hull_fill(&shape, points);
    shape.rounding = sets->rounding;
    if (result == CSG_HULL_DONE && walk->points_only && !take_points(points, &shape))
        result = CSG_HULL_NO_MEMORY;
    shape.facetted = sets->facetted;
    if (result == CSG_HULL_DONE)
        return csg_part_add(part, &shape, false) || csg_walk_no_memory(walk);
    csg_shape_finish(&shape);
    return result == CSG_HULL_FLAT || report(walk, node, result);
}
