/* SPDX-License-Identifier: MIT */
/*
 * polyhedron(points, faces), also with triangles for faces, as in OpenSCAD.
 */
#include "nodes/polyhedron.h"

#include <stdlib.h>

#include "nodes/compounds.h"
#include "nodes/cut_space.h"
#include "polyhedra/hull.h"
#include "polyhedra/mesh.h"

/* Where a surface of triangles is faster to draw than convex solids, or the only way to show all
 * faces of a mesh that is not closed: from so many faces on, and
 * from so many planes of a convex one (measured, docs/surfaces.md). Hulls and Minkowski sums are
 * made of convex solids. */
enum { max_cut_faces = 24, max_planes = 32, max_summed_faces = 2000 };

/* OpenSCAD takes the hull of a solid that meets others where it has no deeper dents than these
 * (is_approximately_convex in its cgalutils.cc); a map between here and there seldom makes dents
 * shallow that are deeper than this. */
#define SHALLOW_DEGREES 0.1
#define MAPPED_DEGREES 10.0

/* Without z it is 0, as in OpenSCAD. */
static bool read_point(const struct csg_value *point, double p[3], double *rounding)
{
    p[2] = 0;
    return (csg_value_numbers(point, 3, p, rounding) || csg_value_numbers(point, 2, p, rounding)) &&
           isfinite(p[0] + p[1] + p[2]);
}

static bool read_points(const struct csg_args *args, struct csg_mesh *mesh)
{
    const struct csg_value *points = csg_args_find(args, "points");
    bool ok = true;
    for (size_t i = 0; points && points->type == CSG_VALUE_VECTOR && i < points->num && ok; i++) {
        const struct csg_value *point = &points->items[i];
        double p[3], rounding = 0;
        if (!read_point(point, p, &rounding)) {
            csg_log_warning(args->log, CSGCAST_MESSAGE_SCENE,
                            "%s:%u:%u: polyhedron: a point must be [x, y, z] with finite numbers; "
                            "the polyhedron is empty",
                            args->file, (unsigned)point->line, (unsigned)point->column);
            mesh->points.num = 0;
            return true;
        }
        mesh->rounding = fmax(mesh->rounding, rounding);
        ok = csg_mesh_add_point(mesh, csg_vec3_of(p));
    }
    return ok;
}

/* Indices that no point has are left out, as in OpenSCAD. */
static bool read_face(const struct csg_args *args, const struct csg_value *face, bool points_only,
                      struct csg_mesh *mesh)
{
    const size_t begin = mesh->corners.num;
    bool ok = true;
    for (size_t i = 0; face->type == CSG_VALUE_VECTOR && i < face->num && ok; i++) {
        const struct csg_value *index = &face->items[i];
        if (index->type == CSG_VALUE_NUMBER && index->number >= 0 &&
            index->number < (double)mesh->points.num)
            ok = csg_array_push(&mesh->corners, (uint32_t)index->number);
        else
            csg_log_warning(args->log, CSGCAST_MESSAGE_SCENE,
                            "%s:%u:%u: polyhedron: a face has an index that no point has; it is "
                            "left out",
                            args->file, (unsigned)index->line, (unsigned)index->column);
    }
    if (ok && !points_only && mesh->corners.num < begin + 3)
        csg_log_warning(args->log, CSGCAST_MESSAGE_SCENE,
                        "%s:%u:%u: polyhedron: a face has fewer than three corners; it is left out",
                        args->file, (unsigned)face->line, (unsigned)face->column);
    return ok && (points_only || csg_mesh_close_face(mesh));
}

/* points_only: faces are only lists of corners, however many. */
static bool read_mesh(const struct csg_args *args, bool points_only, struct csg_mesh *mesh)
{
    const struct csg_value *faces = csg_args_find(args, "faces");
    bool ok = read_points(args, mesh);
    if (!faces)
        faces = csg_args_find(args, "triangles");
    for (size_t i = 0; faces && faces->type == CSG_VALUE_VECTOR && i < faces->num && ok; i++)
        ok = mesh->points.num == 0 || read_face(args, &faces->items[i], points_only, mesh);
    return ok || csg_log_memory(args->log);
}

/* OpenSCAD asks whether an operand of minkowski is convex before it cuts its faces: by the planes
 * that fit them best. false: out of memory. */
static bool is_summed_hull(const struct csg_mesh *mesh, const struct csg_cut_space *space,
                           bool *is_hull)
{
    bool are_there;
    return !space->in_sum ||
           csg_mesh_find_dents(mesh, &space->map, SHALLOW_DEGREES, is_hull, &are_there);
}

bool csg_polyhedron_clean(struct csg_walk *walk, uint32_t node, bool reversed,
                          struct csg_mesh *mesh)
{
    struct csg_cut_space space = {.map = csg_map_identity, .reversed = reversed};
    bool is_hull = false;
    if (walk->points_only)
        return true;
    const double volume = csg_mesh_volume(mesh);
    const bool is_bent = csg_mesh_is_bent(mesh), keeps_dents = reversed ? volume > 0 : volume < 0;
    walk->was_placed |= is_bent;
    if (is_bent && !csg_cut_space_find(walk, node, &space))
        return false;
    if ((is_bent && !keeps_dents && !is_summed_hull(mesh, &space, &is_hull)) ||
        !csg_mesh_clean(mesh, &space))
        return csg_walk_no_memory(walk);
    mesh->is_hull = is_hull;
    mesh->keeps_dents = keeps_dents;
    return true;
}

static void warn_of_gaps(struct csg_walk *walk, uint32_t node, const struct csg_mesh *mesh,
                         const struct csg_mesh_gaps *gaps)
{
    const struct csg_vec3 a = mesh->points.data[gaps->points[0]];
    const struct csg_vec3 b = mesh->points.data[gaps->points[1]];
    csg_walk_warning(
        walk, node,
        "not closed: %zu edge%s, one of them from [%g, %g, %g] to [%g, %g, %g], %s not "
        "belong to two faces in opposite directions; the picture may be wrong",
        gaps->num, gaps->num == 1 ? "" : "s", a.x, a.y, a.z, b.x, b.y, b.z,
        gaps->num == 1 ? "does" : "do");
}

static void warn_of_guesses(struct csg_walk *walk, uint32_t node, size_t num)
{
    csg_walk_warning(walk, node,
                     "%zu face%s not plane, and cut otherwise than in OpenSCAD, because %s or "
                     "csgcast-tess.so is missing, or lacks its library (Debian: libglu1-mesa)",
                     num, num == 1 ? " is" : "s are",
                     num == 1 ? "it crosses itself" : "they cross themselves");
}

static bool add_surface(const struct csg_mesh *mesh, bool open, struct csg_part *part)
{
    struct csg_shape shape;
    return csg_mesh_to_shape(mesh, open, &shape) && csg_part_add(part, &shape, false);
}

static bool add_points(const struct csg_mesh *mesh, struct csg_part *part)
{
    struct csg_shape shape;
    return mesh->corners.num == 0 ||
           (csg_mesh_to_points(mesh, &shape) && csg_part_add(part, &shape, false));
}

/* ---- hulls -------------------------------------------------------------------------------- */

bool csg_polyhedron_find_hull(struct csg_walk *walk, uint32_t node, const struct csg_mesh *mesh,
                              bool *is_hull)
{
    struct csg_cut_space space = {.map = csg_map_identity};
    bool shallow, there;
    *is_hull = false;
    if (!csg_mesh_find_dents(mesh, &csg_map_identity, MAPPED_DEGREES, &shallow, &there))
        return csg_walk_no_memory(walk);
    if (!shallow || !there)
        return true;
    walk->was_placed = true;
    if (!csg_cut_space_find(walk, node, &space))
        return false;
    if (space.on_grid && !csg_mesh_find_dents(mesh, &space.map, SHALLOW_DEGREES, &shallow, &there))
        return csg_walk_no_memory(walk);
    *is_hull = space.on_grid && shallow && there;
    return true;
}

/* is_there: it could be made. */
static bool add_hull(struct csg_walk *walk, const struct csg_mesh *mesh, struct csg_part *part,
                     bool *is_there)
{
    struct csg_shape shape = {.frame = csg_map_identity, .rounding = mesh->rounding};
    struct csg_points points = {0};
    enum csg_hull_result result = CSG_HULL_DONE;
    for (size_t i = 0; i < mesh->corners.num && result == CSG_HULL_DONE; i++)
        if (!csg_array_push(&points.points, mesh->points.data[mesh->corners.data[i]]))
            result = CSG_HULL_NO_MEMORY;
    if (result == CSG_HULL_DONE)
        result = csg_hull_fill(&shape, &points);
    free(points.points.data);
    *is_there = result == CSG_HULL_DONE;
    if (*is_there)
        return csg_part_add(part, &shape, false) || csg_walk_no_memory(walk);
    csg_shape_finish(&shape);
    return result != CSG_HULL_NO_MEMORY || csg_walk_no_memory(walk);
}

/* ---- solids ------------------------------------------------------------------------------- */

/* The solid that the mesh bounds. */
static bool add_solid(struct csg_walk *walk, const struct csg_mesh *mesh,
                      const struct csg_mesh_gaps *gaps, struct csg_part *part)
{
    enum csg_mesh_result result = CSG_MESH_TOO_LARGE;
    const bool is_inner = walk->is_operand;
    /* Planes of one face that rounding bent apart leave pieces between them that stick out. */
    const bool is_bent = mesh->rounding > CSG_MESH_ON_PLANE * mesh->size;
    const size_t max_faces = is_bent ? 0 : is_inner ? max_summed_faces : max_cut_faces;
    if (gaps->num == 0 || is_inner)
        result = csg_mesh_decompose(mesh, max_faces, is_inner ? SIZE_MAX : max_planes, part);
    if (result == CSG_MESH_TOO_LARGE)
        result = add_surface(mesh, gaps->num > 0, part) ? CSG_MESH_DONE : CSG_MESH_NO_MEMORY;
    return result == CSG_MESH_DONE;
}

/* Booleans are regularised and leave nothing of a face without volume; what meets no other solid is
 * in OpenSCAD's mesh as it was written. */
static bool add_all(struct csg_walk *walk, const struct csg_mesh *mesh,
                    const struct csg_mesh_gaps *gaps, struct csg_part *part)
{
    struct csg_mesh films = {0};
    bool ok = csg_mesh_films(mesh, gaps, &films);
    if (ok && films.faces.num == 0) {
        ok = add_solid(walk, mesh, gaps, part);
    } else if (ok) {
        ok = csg_part_open(part, false) && add_solid(walk, mesh, gaps, part) &&
             add_surface(&films, true, part);
        csg_part_close(part);
    }
    csg_mesh_finish(&films);
    return ok;
}

bool csg_polyhedron_add(struct csg_walk *walk, uint32_t node, bool in_boolean,
                        struct csg_mesh *mesh, struct csg_part *part)
{
    struct csg_mesh_gaps gaps;
    bool is_hull = mesh->is_hull;
    if (walk->points_only)
        return add_points(mesh, part) || csg_walk_no_memory(walk);
    if (mesh->faces.num == 0)
        return true;
    if (!csg_mesh_orient(mesh, &gaps))
        return csg_walk_no_memory(walk);
    if (gaps.num)
        warn_of_gaps(walk, node, mesh, &gaps);
    if (mesh->num_guessed)
        warn_of_guesses(walk, node, mesh->num_guessed);
    if (!is_hull && gaps.num == 0 && !mesh->keeps_dents &&
        !csg_polyhedron_find_hull(walk, node, mesh, &is_hull))
        return false;
    if (is_hull && (!add_hull(walk, mesh, part, &is_hull) || is_hull))
        return is_hull;
    const bool has_films = !in_boolean && !walk->is_operand;
    return (has_films ? add_all(walk, mesh, &gaps, part) : add_solid(walk, mesh, &gaps, part)) ||
           csg_walk_no_memory(walk);
}

bool csg_compound_polyhedron(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                             bool in_boolean, struct csg_part *part)
{
    struct csg_mesh mesh = {0};
    const bool ok = read_mesh(args, walk->points_only, &mesh) &&
                    csg_polyhedron_clean(walk, node, true, &mesh) &&
                    csg_polyhedron_add(walk, node, in_boolean, &mesh, part);
    csg_mesh_finish(&mesh);
    return ok;
}
