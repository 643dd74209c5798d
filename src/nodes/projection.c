/* SPDX-License-Identifier: MIT */
/*
 * projection(cut): of OpenSCAD's facets, as unions of convex sets. The shadow of a convex set, and
 * its section with z = 0, are the hulls of points that are easily found. The shadow of a surface is
 * that of its triangles. Where there is a surface, the section of a Boolean is that Boolean of its
 * operands' sections.
 */
#include <stdlib.h>

#include "mesh/surface.h"
#include "nodes/figures.h"
#include "nodes/sets.h"
#include "nodes/transforms.h"
#include "plane/outline.h"
#include "plane/section.h"
#include "plane/wrap.h"
#include "polyhedra/hull.h"

#define WIDER 1e-9

/* Sets of more corners are asked face by face. */
enum { MAX_PAIRED = 64 };

/* Shadows of surfaces of more triangles are refused. */
enum { max_triangles = 20000 };

struct projection {
    struct csg_walk *walk;
    const struct csg_space *space;
    struct csg_drawing *drawing;
    double rounding;
    bool facetted, cut;
    bool has_area;      /* of what has been drawn */
    bool has_triangles; /* of surfaces: many figures that lie side by side */
    bool has_tree;      /* a Boolean of sections has been drawn */
};

static bool add_point(const struct projection *projection, struct csg_flat_points *to,
                      struct csg_vec3 p)
{
    const struct csg_vec3 at = csg_map_point(&projection->space->map, csg_vec3(p.x, p.y, 0));
    return csg_array_push(&to->list, ((struct csg_vec2){at.x, at.y}));
}

static bool add_shadow(const struct projection *projection, const struct csg_vec3 *corners,
                       size_t num, struct csg_flat_points *to)
{
    bool ok = true;
    for (size_t i = 0; i < num && ok; i++)
        ok = add_point(projection, to, corners[i]);
    return ok;
}

/* A convex set whose section is looked for. */
struct section {
    const struct projection *projection;
    const struct csg_vec3 *corners;
    double near; /* corners less far from z = 0 lie on it */
    struct csg_flat_points *to;
};

static bool add_crossing(const struct section *section, struct csg_vec3 a, struct csg_vec3 b)
{
    const double t = -a.z / (b.z - a.z);
    return a.z >= -section->near || b.z <= section->near ||
           add_point(section->projection, section->to, csg_add(a, csg_scale(t, csg_sub(b, a))));
}

/* Any two corners on either side have a point of the section between them. */
static bool add_crossings(void *user, const size_t *corners, size_t num)
{
    const struct section *section = user;
    bool ok = true;
    for (size_t i = 0; i < num && ok; i++)
        for (size_t j = 0; j < num && ok; j++)
            ok = add_crossing(section, section->corners[corners[i]], section->corners[corners[j]]);
    return ok;
}

/* Pairs at one face are enough. All pairs are asked where corners are few, or have no hull. */
static bool add_edges(struct section *section, size_t num)
{
    struct csg_points points = {0};
    CSG_ARRAY(size_t) all = {0};
    enum csg_hull_result result = CSG_HULL_FLAT;
    bool ok = true;
    for (size_t i = 0; i < num && ok; i++)
        ok = csg_array_push(&points.points, csg_sub(section->corners[i], section->corners[0])) &&
             csg_array_push(&all, i);
    if (ok && num > MAX_PAIRED)
        result = csg_hull_visit(&points, add_crossings, section);
    if (ok && result != CSG_HULL_DONE && result != CSG_HULL_NO_MEMORY)
        ok = add_crossings(section, all.data, num);
    free(points.points.data);
    free(all.data);
    return ok && result != CSG_HULL_NO_MEMORY;
}

static bool add_section(const struct projection *projection, const struct csg_vec3 *corners,
                        size_t num, struct csg_flat_points *to)
{
    double size = 0;
    bool ok = true;
    for (size_t i = 0; i < num; i++)
        size = fmax(size, fabs(corners[i].z));
    struct section section = {projection, corners, CSG_SECTION_ON_PLANE * size, to};
    for (size_t i = 0; i < num && ok; i++)
        if (fabs(corners[i].z) <= section.near)
            ok = add_point(projection, to, corners[i]);
    return ok && add_edges(&section, num);
}

static bool add_set(struct projection *projection, const struct csg_vec3 *corners, size_t num)
{
    struct csg_flat_points points = {0};
    bool ok = (projection->cut ? add_section(projection, corners, num, &points)
                               : add_shadow(projection, corners, num, &points)) &&
              csg_flat_points_wrap(&points) &&
              csg_flat_points_draw(projection->drawing, &points, projection->rounding);
    projection->has_area |= points.list.num >= 3;
    if (ok)
        projection->drawing->figures.data[projection->drawing->figures.num - 1].facetted =
            projection->facetted;
    free(points.list.data);
    return ok;
}

static bool add_sets(struct projection *projection, const struct csg_clusters *clusters)
{
    size_t begin = 0;
    bool ok = true;
    for (size_t i = 0; i < clusters->ends.num && ok; i++) {
        ok = add_set(projection, &clusters->corners.points.data[begin],
                     clusters->ends.data[i] - begin);
        begin = clusters->ends.data[i];
    }
    return ok || csg_log_memory(&projection->walk->builder->report->log);
}

/* Those that look up cover all of it, unless there are gaps. */
static bool add_triangles(struct projection *projection, const struct csg_shape *shape)
{
    struct csg_surface *surface = csg_surface_placed(shape->surface, &shape->frame);
    bool ok = surface != NULL;
    projection->has_triangles = true;
    for (size_t i = 0; ok && i < surface->triangles.num; i++) {
        const struct csg_triangle *triangle = &surface->triangles.data[i];
        struct csg_vec3 corners[3];
        for (int k = 0; k < 3; k++)
            corners[k] = surface->points.data[triangle->points[k]];
        if (surface->open || surface->planes.data[triangle->plane].normal.z > 0)
            ok = add_set(projection, corners, 3);
    }
    csg_surface_destroy(surface);
    return ok || csg_log_memory(&projection->walk->builder->report->log);
}

static bool add_surfaces(struct projection *projection, const struct csg_sets *sets)
{
    bool ok = true;
    for (size_t i = 0; i < sets->surfaces.num && ok; i++)
        ok = add_triangles(projection, &sets->surfaces.data[i]);
    return ok;
}

static size_t count_triangles(const struct csg_part *part)
{
    size_t num = 0;
    for (size_t i = 0; i < part->shapes.num; i++)
        num += part->shapes.data[i].surface ? part->shapes.data[i].surface->triangles.num : 0;
    return num;
}

/* What is subtracted takes its boundary with it: a pocket's floor at z = 0 is no part of the
 * section. So its planes there move out a little, by more than evaluation takes for rounding. */
static void widen_cuts(struct csg_part *part)
{
    for (size_t i = 0; i < part->tree.num; i++) {
        const struct csg_node *node = &part->tree.data[i];
        if (node->op != CSG_LEAF || !node->negated)
            continue;
        struct csg_shape *shape = &part->shapes.data[node->leaf];
        const struct csg_box box = csg_box_map(&shape->frame, &shape->bounds);
        const double size = csg_length(box.lo) + csg_length(box.hi);
        for (size_t j = 0; j < shape->num_planes; j++) {
            struct csg_plane *plane = &shape->planes[j];
            if (hypot(plane->normal.x, plane->normal.y) < CSG_SECTION_ON_PLANE &&
                fabs(plane->offset) <= CSG_SECTION_ON_PLANE * size)
                plane->offset += WIDER * size;
        }
    }
}

static enum csg_hull_result evaluate(const struct projection *projection, struct csg_part *part,
                                     struct csg_sets *sets)
{
    if (part->is_too_large)
        return CSG_HULL_FLAT;
    if (projection->cut)
        widen_cuts(part);
    else if (csg_part_is_union(part) && count_triangles(part) <= max_triangles &&
             !csg_sets_take_surfaces(sets, part))
        return CSG_HULL_NO_MEMORY;
    return csg_part_evaluate(part, false, &sets->convex);
}

/* ---- sections of surfaces ----------------------------------------------------------------- */

static bool has_closed_surfaces(const struct csg_part *part)
{
    for (size_t i = 0; i < part->shapes.num; i++)
        if (part->shapes.data[i].surface && part->shapes.data[i].surface->open)
            return false;
    return count_triangles(part) > 0;
}

static bool add_surface_section(struct projection *projection, const struct csg_shape *shape)
{
    struct csg_surface *surface = csg_surface_placed(shape->surface, &shape->frame);
    const size_t before = projection->drawing->points.num;
    const bool ok = surface && csg_surface_section(surface, &projection->space->map,
                                                   projection->rounding, projection->drawing);
    projection->has_area |= projection->drawing->points.num > before;
    csg_surface_destroy(surface);
    return ok;
}

static enum csg_hull_result add_leaf_section(struct projection *projection,
                                             const struct csg_shape *shape)
{
    struct csg_points corners = {0};
    enum csg_hull_result result = CSG_HULL_DONE;
    bool ok = true;
    if (shape->surface) {
        ok = add_surface_section(projection, shape);
    } else {
        result = csg_shape_corners(shape, &corners);
        ok =
            result != CSG_HULL_DONE || add_set(projection, corners.points.data, corners.points.num);
    }
    free(corners.points.data);
    return ok ? result : CSG_HULL_NO_MEMORY;
}

/* What every section is within. */
static bool add_surroundings(struct projection *projection, const struct csg_part *part)
{
    const struct csg_box box = csg_part_box(part);
    struct csg_flat_points corners = {0};
    const struct csg_vec3 size = csg_sub(box.hi, box.lo);
    bool ok = true;
    for (int i = 0; i < 4 && ok; i++) {
        const double x = i & 1 ? box.hi.x + size.x : box.lo.x - size.x;
        const double y = i & 2 ? box.hi.y + size.y : box.lo.y - size.y;
        ok = add_point(projection, &corners, csg_vec3(x, y, 0));
    }
    ok = ok && csg_flat_points_wrap(&corners) &&
         csg_flat_points_draw(projection->drawing, &corners, projection->rounding);
    free(corners.list.data);
    return ok;
}

static enum csg_hull_result add_literal(struct projection *projection, const struct csg_part *part,
                                        const struct csg_node *node)
{
    const struct csg_shape *shape = &part->shapes.data[node->leaf];
    const uint32_t draw = (uint32_t)projection->drawing->nodes.num;
    if (!node->negated)
        return add_leaf_section(projection, shape);
    if (!csg_drawing_open(projection->drawing, CSG_DRAW_DIFFERENCE) ||
        !add_surroundings(projection, part))
        return CSG_HULL_NO_MEMORY;
    const enum csg_hull_result result = add_leaf_section(projection, shape);
    csg_drawing_close(projection->drawing, draw);
    return result;
}

/* The part's tree, node by node. */
static enum csg_hull_result add_tree(struct projection *projection, const struct csg_part *part)
{
    CSG_ARRAY(struct csg_open_node) open = {0}; /* of the drawing */
    enum csg_hull_result result = CSG_HULL_DONE;
    for (uint32_t i = 0; i < part->tree.num && result == CSG_HULL_DONE; i++) {
        while (open.num > 0 && open.data[open.num - 1].old_end <= i)
            csg_drawing_close(projection->drawing, open.data[--open.num].index);
        const struct csg_node *node = &part->tree.data[i];
        const struct csg_open_node opened = {(uint32_t)projection->drawing->nodes.num, node->end};
        if (node->op == CSG_LEAF)
            result = add_literal(projection, part, node);
        else if (!csg_drawing_open(projection->drawing,
                                   node->op == CSG_AND ? CSG_DRAW_INTERSECTION : CSG_DRAW_UNION) ||
                 !csg_array_push(&open, opened))
            result = CSG_HULL_NO_MEMORY;
    }
    while (open.num > 0)
        csg_drawing_close(projection->drawing, open.data[--open.num].index);
    free(open.data);
    return result;
}

static bool project(struct projection *projection, uint32_t node, struct csg_part *part)
{
    struct csg_walk *walk = projection->walk;
    struct csg_sets sets = {0};
    for (size_t i = 0; i < part->shapes.num; i++) {
        projection->rounding = fmax(projection->rounding, part->shapes.data[i].rounding);
        projection->facetted |= part->shapes.data[i].facetted;
    }
    projection->rounding *= csg_space_stretch(projection->space);
    projection->has_tree = projection->cut && !part->is_too_large && has_closed_surfaces(part);
    const enum csg_hull_result result =
        projection->has_tree ? add_tree(projection, part) : evaluate(projection, part, &sets);
    bool ok = true;
    if (result == CSG_HULL_DONE)
        ok = add_sets(projection, &sets.convex) && add_surfaces(projection, &sets);
    else if (result == CSG_HULL_NO_MEMORY)
        ok = csg_walk_no_memory(walk);
    else
        csg_walk_unsupported(walk, node, "projection: what is in it has too many pieces");
    if (projection->cut && !projection->has_area &&
        (projection->has_tree || sets.convex.ends.num > 0))
        csg_walk_warning(walk, node, "nothing of what is in it is at z = 0; the section is empty");
    csg_sets_finish(&sets);
    return ok;
}

/* One outline of all. As written, that of a shadow is Clipper's, which OpenSCAD projects triangles
 * with; a section it has by its kernel, without a grid. */
static bool unite(const struct projection *projection, uint32_t node, uint32_t draw)
{
    struct csg_walk *walk = projection->walk;
    const bool as_written = walk->builder->facets == CSGCAST_FACETS_AS_WRITTEN;
    if (as_written ? !projection->cut : !projection->has_triangles && !projection->has_tree)
        return true;
    const enum csg_sweep_result result = csg_drawing_evaluate(projection->drawing, draw);
    if (result == CSG_SWEEP_TOO_LARGE && (projection->has_tree || !as_written))
        csg_walk_unsupported(walk, node, "projection: what is in it has too many pieces");
    return result != CSG_SWEEP_NO_MEMORY || csg_walk_no_memory(walk);
}

bool csg_figure_projection(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                           const struct csg_space *space, struct csg_drawing *drawing)
{
    struct projection projection = {
        .walk = walk, .space = space, .drawing = drawing, .cut = csg_args_bool(args, "cut")};
    const uint32_t end = csg_walk_node(walk, node)->end, draw = (uint32_t)drawing->nodes.num;
    struct csg_part part = {0};
    struct csg_map inverse;
    bool ok = csg_drawing_open(drawing, CSG_DRAW_UNION) || csg_walk_no_memory(walk);
    if (ok && !space->is_empty && csg_map_invert(&space->map, &inverse))
        ok = csg_part_read(walk, node + 1, end, space->in_boolean, CSG_WANT_FACETS, &part) &&
             project(&projection, node, &part);
    csg_drawing_close(drawing, draw);
    csg_part_finish(&part);
    return ok && unite(&projection, node, draw);
}
