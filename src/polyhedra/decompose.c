/* SPDX-License-Identifier: MIT */
/*
 * A polyhedron that is not convex is cut along the planes of its faces (a BSP, Fuchs et al. 1980):
 * space is a cell; a cell that holds pieces of faces is cut along one of them; a cell without any
 * is inside or outside as a whole. The cells inside abut along planes that both name, so they have
 * no seams.
 */
#include <stdlib.h>

#include "polyhedra/cell.h"
#include "polyhedra/mesh.h"

/* Planes that are tried for a cut. */
enum { max_candidates = 12 };

/* Testing whether a polyhedron is convex takes faces times corners; larger ones are not tried. */
#define MAX_CONVEX_TESTS 2e8

/* Give up when the faces are in so many pieces. */
enum { max_fragments = 400000 };

struct fragments {
    CSG_ARRAY(struct csg_polygon) polygons;
};

struct region {
    struct csg_cell cell;
    struct fragments fragments;
};

struct bsp {
    const struct csg_mesh *mesh;
    struct csg_part *part;
    CSG_ARRAY(struct region) todo;
    double near;
    size_t num_fragments; /* made so far */
};

static void finish_region(struct region *region)
{
    csg_cell_finish(&region->cell);
    for (size_t i = 0; i < region->fragments.polygons.num; i++)
        csg_polygon_finish(&region->fragments.polygons.data[i]);
    free(region->fragments.polygons.data);
    *region = (struct region){0};
}

static bool add_fragment(struct bsp *bsp, struct fragments *to, struct csg_polygon *polygon)
{
    bsp->num_fragments++;
    if (polygon->points.num >= 3 && csg_array_push(&to->polygons, *polygon))
        return true;
    const bool is_flat = polygon->points.num < 3;
    csg_polygon_finish(polygon);
    return is_flat;
}

/* ---- convex ------------------------------------------------------------------------------- */

static bool has_plane(const struct csg_shape *shape, const struct csg_plane *plane, double near)
{
    for (size_t i = 0; i < shape->num_planes; i++) {
        const struct csg_vec3 d = csg_sub(shape->planes[i].normal, plane->normal);
        if (csg_dot(d, d) < 1e-18 && fabs(shape->planes[i].offset - plane->offset) <= near)
            return true;
    }
    return false;
}

/* Triangles that a face is cut into lie on one plane to the last bit; it is tested once. */
static bool was_tested(const struct csg_shape *shape, const struct csg_plane *plane)
{
    for (size_t i = 0; i < shape->num_planes; i++) {
        const struct csg_vec3 n = shape->planes[i].normal;
        const double s = csg_dot(n, plane->normal) < 0 ? -1 : 1;
        if (plane->normal.x == s * n.x && plane->normal.y == s * n.y &&
            plane->normal.z == s * n.z && plane->offset == s * shape->planes[i].offset)
            return true;
    }
    return false;
}

static struct csg_box mesh_box(const struct csg_mesh *mesh)
{
    struct csg_box box = csg_box_empty;
    for (size_t i = 0; i < mesh->corners.num; i++)
        csg_box_extend(&box, mesh->points.data[mesh->corners.data[i]]);
    return box;
}

/* Where all points lie on one side of each face the polyhedron is convex, and its planes are it. */
static bool fill_convex(const struct csg_mesh *mesh, double near, struct csg_shape *shape,
                        bool *out_of_memory)
{
    struct csg_plane plane;
    for (size_t i = 0; i < mesh->faces.num; i++) {
        double lo = 0, hi = 0;
        if (!csg_mesh_plane(mesh, &mesh->faces.data[i], &plane) || was_tested(shape, &plane))
            continue;
        for (size_t j = 0; j < mesh->corners.num; j++) {
            const double d =
                csg_dot(plane.normal, mesh->points.data[mesh->corners.data[j]]) - plane.offset;
            lo = csg_least(lo, d);
            hi = csg_most(hi, d);
            if (lo < -near && hi > near)
                return false;
        }
        if (hi > near)
            plane = (struct csg_plane){csg_scale(-1, plane.normal), -plane.offset};
        if (has_plane(shape, &plane, near))
            continue;
        if (!csg_shape_add_plane(shape, plane.normal, plane.offset))
            return *out_of_memory = true, false;
    }
    shape->convex = true;
    shape->bounds = shape->written = mesh_box(mesh);
    return true;
}

/* ---- cutting ------------------------------------------------------------------------------ */

/* Fewer pieces and more even sides are better. */
static double cost_of(const struct region *region, const struct csg_plane *plane, double near)
{
    size_t num_below = 0, num_above = 0, num_cut = 0;
    for (size_t i = 0; i < region->fragments.polygons.num; i++) {
        double lo = INFINITY, hi = -INFINITY;
        csg_polygon_range(&region->fragments.polygons.data[i], plane, &lo, &hi);
        num_below += lo < -near;
        num_above += hi > near;
        num_cut += lo < -near && hi > near;
    }
    const double uneven =
        num_below > num_above ? (double)(num_below - num_above) : (double)(num_above - num_below);
    return 4 * (double)num_cut + 0.25 * uneven;
}

static struct csg_plane choose_plane(const struct bsp *bsp, const struct region *region)
{
    const size_t num = region->fragments.polygons.num;
    const size_t step = num > max_candidates ? num / max_candidates : 1;
    struct csg_plane best = region->fragments.polygons.data[0].plane;
    double least = INFINITY;
    for (size_t i = 0; i < num; i += step) {
        const struct csg_plane *plane = &region->fragments.polygons.data[i].plane;
        const double cost = cost_of(region, plane, bsp->near);
        if (cost < least) {
            least = cost;
            best = *plane;
        }
    }
    return best;
}

static bool split_fragments(struct bsp *bsp, const struct region *region,
                            const struct csg_plane *plane, struct region *below,
                            struct region *above)
{
    bool ok = true;
    for (size_t i = 0; i < region->fragments.polygons.num && ok; i++) {
        struct csg_polygon low = {0}, high = {0};
        ok = csg_polygon_split(&region->fragments.polygons.data[i], plane, bsp->near, &low, &high);
        const bool kept = add_fragment(bsp, &below->fragments, &low);
        ok = add_fragment(bsp, &above->fragments, &high) && kept && ok;
    }
    return ok;
}

static bool push_region(struct bsp *bsp, struct region *region)
{
    if (region->cell.faces.num >= 4 && csg_array_push(&bsp->todo, *region))
        return true;
    const bool is_flat = region->cell.faces.num < 4;
    finish_region(region);
    return is_flat;
}

/* A plane that only touches the cell leaves it whole. */
static bool split_region(struct bsp *bsp, const struct region *region)
{
    const struct csg_plane plane = choose_plane(bsp, region);
    struct region below = {0}, above = {0};
    double lo, hi;
    csg_cell_range(&region->cell, &plane, &lo, &hi);
    const double near = lo < -bsp->near && hi > bsp->near ? bsp->near : INFINITY;
    bool ok = split_fragments(bsp, region, &plane, &below, &above);
    if (near < INFINITY) {
        ok = ok && csg_cell_split(&region->cell, &plane, bsp->near, &below.cell, &above.cell);
    } else {
        /* All of the cell is on one side: a far plane copies it there. */
        const double far = 4 * (fabs(lo) + fabs(hi)) + 1;
        struct csg_plane beyond = plane;
        beyond.offset += hi > -lo ? -far : far;
        ok = ok && csg_cell_split(&region->cell, &beyond, bsp->near, &below.cell, &above.cell);
    }
    ok = push_region(bsp, &below) && ok;
    return push_region(bsp, &above) && ok;
}

/* ---- cells -------------------------------------------------------------------------------- */

static bool add_cell(struct bsp *bsp, const struct csg_cell *cell)
{
    struct csg_shape shape = {
        .frame = csg_map_identity, .convex = true, .rounding = bsp->mesh->rounding};
    bool ok = true;
    for (size_t i = 0; i < cell->faces.num && ok; i++)
        ok = csg_shape_add_plane(&shape, cell->faces.data[i].plane.normal,
                                 cell->faces.data[i].plane.offset);
    shape.bounds = shape.written = csg_cell_box(cell);
    if (ok)
        return csg_part_add(bsp->part, &shape, false);
    csg_shape_finish(&shape);
    return false;
}

static bool is_inside(const struct bsp *bsp, const struct csg_cell *cell)
{
    return fabs(csg_mesh_winding(bsp->mesh, csg_cell_center(cell))) > 0.5;
}

static bool visit(struct bsp *bsp, const struct region *region)
{
    if (region->fragments.polygons.num > 0)
        return split_region(bsp, region);
    return !is_inside(bsp, &region->cell) || add_cell(bsp, &region->cell);
}

/* The box has room around the faces, so that none of them lies in its walls. */
static bool start(struct bsp *bsp)
{
    const struct csg_mesh *mesh = bsp->mesh;
    struct region all = {0};
    struct csg_box box = mesh_box(mesh);
    const double room = mesh->size > 0 ? mesh->size : 1;
    box.lo = csg_sub(box.lo, csg_vec3(room, room, room));
    box.hi = csg_add(box.hi, csg_vec3(room, room, room));
    bool ok = csg_cell_from_box(&all.cell, &box);
    for (size_t i = 0; i < mesh->faces.num && ok; i++) {
        const struct csg_mesh_face *face = &mesh->faces.data[i];
        struct csg_polygon polygon = {0};
        if (!csg_mesh_plane(mesh, face, &polygon.plane))
            continue;
        for (uint32_t j = face->begin; j < face->end && ok; j++)
            ok = csg_array_push(&polygon.points, mesh->points.data[mesh->corners.data[j]]);
        ok = add_fragment(bsp, &all.fragments, &polygon) && ok;
    }
    if (ok && csg_array_push(&bsp->todo, all))
        return true;
    finish_region(&all);
    return false;
}

static bool cut_all(struct bsp *bsp)
{
    bool ok = start(bsp) && csg_part_open(bsp->part, false);
    while (ok && bsp->todo.num > 0 && !bsp->part->is_too_large) {
        struct region region = bsp->todo.data[--bsp->todo.num];
        ok = visit(bsp, &region);
        bsp->part->is_too_large |= bsp->num_fragments > max_fragments;
        finish_region(&region);
    }
    while (bsp->todo.num > 0)
        finish_region(&bsp->todo.data[--bsp->todo.num]);
    free(bsp->todo.data);
    if (ok)
        csg_part_close(bsp->part);
    return ok;
}

enum csg_mesh_result csg_mesh_decompose(const struct csg_mesh *mesh, size_t max_faces,
                                        size_t max_planes, struct csg_part *part)
{
    const double near = CSG_MESH_ON_PLANE * mesh->size + 2 * mesh->rounding;
    struct csg_shape shape = {.frame = csg_map_identity, .rounding = mesh->rounding};
    bool out_of_memory = false;
    if ((double)mesh->faces.num * (double)mesh->corners.num > MAX_CONVEX_TESTS)
        return CSG_MESH_TOO_LARGE;
    const bool is_convex = fill_convex(mesh, near, &shape, &out_of_memory);
    if (is_convex && shape.num_planes > max_planes) {
        csg_shape_finish(&shape);
        return CSG_MESH_TOO_LARGE;
    }
    if (is_convex && shape.num_planes >= 4)
        return csg_part_add(part, &shape, false) ? CSG_MESH_DONE : CSG_MESH_NO_MEMORY;
    const bool is_flat = shape.convex;
    csg_shape_finish(&shape);
    if (out_of_memory)
        return CSG_MESH_NO_MEMORY;
    if (is_flat)
        return CSG_MESH_DONE;
    if (mesh->faces.num > max_faces)
        return CSG_MESH_TOO_LARGE;
    struct csg_part cells = {0};
    struct bsp bsp = {.mesh = mesh, .part = &cells, .near = near};
    enum csg_mesh_result result = cut_all(&bsp) ? CSG_MESH_DONE : CSG_MESH_NO_MEMORY;
    if (result == CSG_MESH_DONE && cells.is_too_large)
        result = CSG_MESH_TOO_LARGE;
    else if (result == CSG_MESH_DONE && !csg_part_append(part, &cells, false))
        result = CSG_MESH_NO_MEMORY;
    csg_part_finish(&cells);
    return result;
}
