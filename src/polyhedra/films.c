/* SPDX-License-Identifier: MIT */
/*
 * Faces that bound no volume. A face and the same one the other way round take each other back, and
 * of a polyhedron whose corners lie on one plane the faces of one side are all there is to see.
 * Those within the solid are left out: they are walls between its parts, which nobody outside sees.
 */
#include <stdlib.h>

#include "mesh/surface.h"
#include "polyhedra/mesh.h"

/* A face by its corners from the lowest one on, towards the lower of its neighbours. */
struct loop {
    const uint32_t *corners; /* of the face */
    uint32_t num, first, face;
    bool is_backwards;
};

static uint32_t corner_of(const struct loop *loop, uint32_t i)
{
    return loop->corners[(loop->first + (loop->is_backwards ? loop->num - i : i)) % loop->num];
}

static struct loop loop_of(const struct csg_mesh *mesh, uint32_t face)
{
    const struct csg_mesh_face *f = &mesh->faces.data[face];
    struct loop loop = {&mesh->corners.data[f->begin], f->end - f->begin, 0, face, false};
    for (uint32_t i = 1; i < loop.num; i++)
        if (loop.corners[i] < loop.corners[loop.first])
            loop.first = i;
    loop.is_backwards = corner_of(&loop, loop.num - 1) < corner_of(&loop, 1);
    return loop;
}

static int compare_loops(const void *a, const void *b)
{
    const struct loop *x = a, *y = b;
    if (x->num != y->num)
        return x->num < y->num ? -1 : 1;
    for (uint32_t i = 0; i < x->num; i++)
        if (corner_of(x, i) != corner_of(y, i))
            return corner_of(x, i) < corner_of(y, i) ? -1 : 1;
    return 0;
}

static bool copy_points(const struct csg_mesh *mesh, struct csg_mesh *films)
{
    bool ok = true;
    for (size_t i = 0; i < mesh->points.num && ok; i++)
        ok = csg_mesh_add_point(films, mesh->points.data[i]);
    films->rounding = mesh->rounding;
    return ok;
}

static bool copy_face(const struct csg_mesh *mesh, uint32_t face, struct csg_mesh *films)
{
    const struct csg_mesh_face *f = &mesh->faces.data[face];
    bool ok = true;
    for (uint32_t i = f->begin; i < f->end && ok; i++)
        ok = csg_array_push(&films->corners, mesh->corners.data[i]);
    return ok && csg_mesh_close_face(films);
}

/* A point of a fan's triangle, whose area is not 0, is this share of its size above its plane. */
#define ABOVE 1e-6

/* Whether the solid is on both sides of the middles of all the face's triangles. */
static bool is_within(const struct csg_mesh *mesh, const struct csg_surface *solid, uint32_t face)
{
    const struct csg_mesh_face *f = &mesh->faces.data[face];
    const struct csg_vec3 *points = mesh->points.data;
    const uint32_t *corners = mesh->corners.data;
    for (uint32_t i = f->begin + 1; i + 1 < f->end; i++) {
        const struct csg_vec3 a = points[corners[f->begin]];
        const struct csg_vec3 b = csg_sub(points[corners[i]], a);
        const struct csg_vec3 c = csg_sub(points[corners[i + 1]], a);
        const struct csg_vec3 middle = csg_add(a, csg_scale(1.0 / 3, csg_add(b, c)));
        const struct csg_vec3 normal = csg_normalize(csg_cross(b, c));
        const struct csg_vec3 up = csg_scale(ABOVE * fmin(csg_length(b), csg_length(c)), normal);
        if (csg_length(up) > 0 &&
            (!csg_surface_winding(solid, &csg_map_identity, csg_add(middle, up)) ||
             !csg_surface_winding(solid, &csg_map_identity, csg_sub(middle, up))))
            return false;
    }
    return true;
}

/* One face of each run of equal loops of which as many run one way as the other. */
static bool copy_pairs(const struct csg_mesh *mesh, const struct csg_surface *solid,
                       const struct loop *loops, struct csg_mesh *films)
{
    bool ok = true;
    for (size_t i = 0, j; i < mesh->faces.num && ok; i = j) {
        long turns = 0;
        for (j = i; j < mesh->faces.num && compare_loops(&loops[i], &loops[j]) == 0; j++)
            turns += loops[j].is_backwards ? -1 : 1;
        ok = turns != 0 || is_within(mesh, solid, loops[i].face) ||
             copy_face(mesh, loops[i].face, films);
    }
    return ok;
}

static bool add_pairs(const struct csg_mesh *mesh, struct csg_mesh *films)
{
    struct csg_shape solid = {0};
    struct loop *loops = malloc(mesh->faces.num * sizeof *loops);
    for (uint32_t i = 0; loops && i < mesh->faces.num; i++)
        loops[i] = loop_of(mesh, i);
    if (loops)
        qsort(loops, mesh->faces.num, sizeof *loops, compare_loops);
    const bool ok = loops && csg_mesh_to_shape(mesh, false, &solid) &&
                    csg_surface_build(solid.surface) &&
                    copy_pairs(mesh, solid.surface, loops, films);
    csg_shape_finish(&solid);
    free(loops);
    return ok;
}

/* The plane that all corners lie on. false: there is none. */
static bool find_plane(const struct csg_mesh *mesh, struct csg_plane *plane)
{
    const double near = CSG_MESH_ON_PLANE * mesh->size + 2 * mesh->rounding;
    size_t i = 0;
    while (i < mesh->faces.num && !csg_mesh_plane(mesh, &mesh->faces.data[i], plane))
        i++;
    bool is_flat = i < mesh->faces.num;
    for (i = 0; i < mesh->corners.num && is_flat; i++) {
        const struct csg_vec3 p = mesh->points.data[mesh->corners.data[i]];
        is_flat = fabs(csg_dot(plane->normal, p) - plane->offset) <= near;
    }
    return is_flat;
}

static bool add_front(const struct csg_mesh *mesh, const struct csg_plane *front,
                      struct csg_mesh *films)
{
    bool ok = true;
    for (uint32_t i = 0; i < mesh->faces.num && ok; i++) {
        struct csg_plane plane;
        if (csg_mesh_plane(mesh, &mesh->faces.data[i], &plane) &&
            csg_dot(plane.normal, front->normal) > 0)
            ok = copy_face(mesh, i, films);
    }
    return ok;
}

bool csg_mesh_films(const struct csg_mesh *mesh, const struct csg_mesh_gaps *gaps,
                    struct csg_mesh *films)
{
    struct csg_plane front;
    if (mesh->faces.num == 0 || gaps->num > 0)
        return true;
    if (find_plane(mesh, &front))
        return copy_points(mesh, films) && add_front(mesh, &front, films);
    return !gaps->is_folded || (copy_points(mesh, films) && add_pairs(mesh, films));
}
