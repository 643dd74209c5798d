/* SPDX-License-Identifier: MIT */
/* A mesh as one solid bounded by triangles, for what is too much to be cut into convex cells. */
#include <stdlib.h>

#include "mesh/surface.h"
#include "polyhedra/mesh.h"

/* A face without area has no plane of its own; one through its longest edge holds it as well. */
static struct csg_plane flat_plane(const struct csg_mesh *mesh, const struct csg_mesh_face *face)
{
    const struct csg_vec3 *points = mesh->points.data;
    const uint32_t *corners = mesh->corners.data;
    const struct csg_vec3 origin = points[corners[face->begin]];
    struct csg_vec3 longest = {0, 0, 0}, normal;
    for (uint32_t i = face->begin; i < face->end; i++) {
        const struct csg_vec3 edge = csg_sub(points[corners[i]], origin);
        if (csg_length(edge) > csg_length(longest))
            longest = edge;
    }
    normal = fabs(longest.x) < fabs(longest.y) ? csg_vec3(1, 0, 0) : csg_vec3(0, 1, 0);
    normal = csg_normalize(csg_cross(longest, normal));
    if (!(csg_length(normal) > 0.5))
        normal = csg_vec3(0, 0, 1);
    return (struct csg_plane){normal, csg_dot(normal, origin)};
}

/* A fan; where the face is not convex its triangles fold over each other and cancel. */
static bool add_face(const struct csg_mesh *mesh, const struct csg_mesh_face *face,
                     struct csg_surface *surface)
{
    const uint32_t *corners = mesh->corners.data;
    struct csg_plane plane;
    if (!csg_mesh_plane(mesh, face, &plane))
        plane = flat_plane(mesh, face);
    bool ok = csg_array_push(&surface->planes, plane);
    for (uint32_t i = face->begin + 1; i + 1 < face->end && ok; i++) {
        const struct csg_triangle triangle = {{corners[face->begin], corners[i], corners[i + 1]},
                                              (uint32_t)surface->planes.num - 1};
        ok = csg_array_push(&surface->triangles, triangle);
    }
    return ok;
}

/* Six times the volume, where the triangles run counter-clockwise as seen from outside. */
static double volume_of(const struct csg_surface *surface, struct csg_vec3 origin)
{
    double volume = 0;
    for (size_t i = 0; i < surface->triangles.num; i++) {
        const uint32_t *points = surface->triangles.data[i].points;
        const struct csg_vec3 a = csg_sub(surface->points.data[points[0]], origin);
        const struct csg_vec3 b = csg_sub(surface->points.data[points[1]], origin);
        const struct csg_vec3 c = csg_sub(surface->points.data[points[2]], origin);
        volume += csg_dot(a, csg_cross(b, c));
    }
    return volume;
}

/* OpenSCAD's faces run clockwise as seen from outside. */
static void turn_outwards(struct csg_surface *surface, struct csg_vec3 origin)
{
    if (volume_of(surface, origin) >= 0)
        return;
    for (size_t i = 0; i < surface->triangles.num; i++) {
        uint32_t *points = surface->triangles.data[i].points;
        const uint32_t point = points[1];
        points[1] = points[2];
        points[2] = point;
    }
    for (size_t i = 0; i < surface->planes.num; i++) {
        struct csg_plane *plane = &surface->planes.data[i];
        *plane = (struct csg_plane){csg_scale(-1, plane->normal), -plane->offset};
    }
}

/* Only points that some face has. */
static bool copy_points(const struct csg_mesh *mesh, struct csg_surface *surface)
{
    uint32_t *index = malloc((mesh->points.num + 1) * sizeof *index);
    bool ok = index != NULL;
    for (size_t i = 0; i < mesh->points.num && ok; i++)
        index[i] = UINT32_MAX;
    for (size_t i = 0; i < surface->triangles.num && ok; i++)
        for (int j = 0; j < 3 && ok; j++) {
            uint32_t *point = &surface->triangles.data[i].points[j];
            if (index[*point] == UINT32_MAX) {
                index[*point] = (uint32_t)surface->points.num;
                ok = csg_array_push(&surface->points, mesh->points.data[*point]);
            }
            *point = index[*point];
        }
    free(index);
    return ok;
}

bool csg_mesh_to_points(const struct csg_mesh *mesh, struct csg_shape *shape)
{
    struct csg_surface *surface = calloc(1, sizeof *surface);
    bool *is_taken = calloc(mesh->points.num + 1, sizeof *is_taken);
    struct csg_box box = csg_box_empty;
    bool ok = surface && is_taken;
    for (size_t i = 0; i < mesh->corners.num && ok; i++) {
        const uint32_t point = mesh->corners.data[i];
        ok = is_taken[point] || csg_array_push(&surface->points, mesh->points.data[point]);
        is_taken[point] = true;
        csg_box_extend(&box, mesh->points.data[point]);
    }
    free(is_taken);
    if (!ok) {
        csg_surface_destroy(surface);
        return false;
    }
    surface->rounding = mesh->rounding;
    csg_surface_measure(surface);
    *shape = (struct csg_shape){
        .surface = surface, .frame = csg_map_identity, .rounding = mesh->rounding};
    shape->bounds = shape->written = box;
    return true;
}

bool csg_mesh_to_shape(const struct csg_mesh *mesh, bool open, struct csg_shape *shape)
{
    struct csg_surface *surface = calloc(1, sizeof *surface);
    bool ok = surface != NULL;
    for (size_t i = 0; i < mesh->faces.num && ok; i++)
        ok = add_face(mesh, &mesh->faces.data[i], surface);
    ok = ok && copy_points(mesh, surface);
    if (!ok) {
        csg_surface_destroy(surface);
        return false;
    }
    surface->open = open;
    surface->is_simple = mesh->is_simple && !open;
    *shape = (struct csg_shape){
        .surface = surface, .frame = csg_map_identity, .rounding = mesh->rounding};
    shape->bounds = shape->written = csg_surface_box(surface);
    turn_outwards(surface, shape->bounds.lo);
    surface->rounding = mesh->rounding;
    csg_surface_measure(surface);
    csg_array_trim(&surface->points);
    csg_array_trim(&surface->triangles);
    csg_array_trim(&surface->planes);
    return true;
}
