/* SPDX-License-Identifier: MIT */
#include "nodes/hull_film.h"

#include <stdlib.h>

#include "plane/wrap.h"
#include "polyhedra/mesh.h"

/* Volumes below this share of the product of their edges are the rounding of long double. */
#define EXACT 1e-18L

/* The coordinate that the plane reaches least along, and the other two. */
struct axes {
    int x, y, up;
};

/* A plane through three of the points that lie far apart. false: they are all on one line. */
static bool find_plane(const struct csg_points *points, struct csg_vec3 corner[3],
                       struct csg_plane *plane)
{
    const struct csg_vec3 *p = points->points.data;
    struct csg_vec3 normal = {0, 0, 0};
    corner[0] = corner[1] = corner[2] = p[0];
    for (size_t i = 1; i < points->points.num; i++)
        if (csg_length(csg_sub(p[i], p[0])) > csg_length(csg_sub(corner[1], p[0])))
            corner[1] = p[i];
    for (size_t i = 1; i < points->points.num; i++) {
        const struct csg_vec3 n = csg_cross(csg_sub(corner[1], p[0]), csg_sub(p[i], p[0]));
        if (csg_length(n) > csg_length(normal)) {
            normal = n;
            corner[2] = p[i];
        }
    }
    plane->normal = csg_normalize(normal);
    plane->offset = csg_dot(plane->normal, p[0]);
    return csg_length(plane->normal) > 0.5;
}

/* Qhull refuses other points as well. */
static bool is_thin(const struct csg_points *points, const struct csg_plane *plane)
{
    double size = 0, off = 0;
    for (size_t i = 0; i < points->points.num; i++) {
        const struct csg_vec3 p = points->points.data[i];
        size = fmax(size, csg_vec3_largest(p));
        off = fmax(off, fabs(csg_dot(plane->normal, p) - plane->offset));
    }
    return off <= CSG_MESH_ON_PLANE * size;
}

/* Whether the four points are in a plane, as far as long double tells. */
static bool is_flat(const struct csg_vec3 corner[3], struct csg_vec3 p)
{
    long double d[3][3];
    const struct csg_vec3 to[3] = {corner[1], corner[2], p};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            d[i][k] = (long double)csg_vec3_component(to[i], k) - csg_vec3_component(corner[0], k);
    long double volume = 0, size = 1;
    for (int k = 0; k < 3; k++) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        volume += d[2][k] * (d[0][l] * d[1][m] - d[0][m] * d[1][l]);
        size *= fabsl(d[k][0]) + fabsl(d[k][1]) + fabsl(d[k][2]);
    }
    return fabsl(volume) <= EXACT * size;
}

static struct axes axes_for(const struct csg_plane *plane)
{
    const double x = fabs(plane->normal.x), y = fabs(plane->normal.y), z = fabs(plane->normal.z);
    const int up = x > y && x > z ? 0 : y > z ? 1 : 2;
    return (struct axes){(up + 1) % 3, (up + 2) % 3, up};
}

/* The point of the plane above or below p. */
static struct csg_vec3 lift(const struct csg_plane *plane, const struct axes *axes,
                            struct csg_vec2 p)
{
    double at[3];
    at[axes->x] = p.x;
    at[axes->y] = p.y;
    at[axes->up] = (plane->offset - csg_vec3_component(plane->normal, axes->x) * p.x -
                    csg_vec3_component(plane->normal, axes->y) * p.y) /
                   csg_vec3_component(plane->normal, axes->up);
    return csg_vec3_of(at);
}

/* The one face of the hull. */
static bool fill(const struct csg_points *points, const struct csg_plane *plane,
                 struct csg_mesh *film)
{
    const struct axes axes = axes_for(plane);
    struct csg_flat_points flat = {0};
    bool ok = true;
    for (size_t i = 0; i < points->points.num && ok; i++) {
        const struct csg_vec3 p = points->points.data[i];
        const struct csg_vec2 at = {csg_vec3_component(p, axes.x), csg_vec3_component(p, axes.y)};
        ok = csg_array_push(&flat.list, at);
    }
    ok = ok && csg_flat_points_wrap(&flat);
    for (uint32_t i = 0; i < flat.list.num && ok; i++)
        ok = csg_mesh_add_point(film, lift(plane, &axes, flat.list.data[i])) &&
             csg_array_push(&film->corners, i);
    free(flat.list.data);
    return ok && csg_mesh_close_face(film);
}

bool csg_hull_film(const struct csg_sets *sets, const struct csg_points *points,
                   struct csg_part *part)
{
    struct csg_vec3 corner[3];
    struct csg_plane plane;
    struct csg_mesh film = {.rounding = sets->rounding};
    struct csg_shape shape;
    bool flat = true;
    if (points->points.num < 4 || !find_plane(points, corner, &plane) || !is_thin(points, &plane))
        return true;
    for (size_t i = 0; i < points->points.num && flat; i++)
        flat = is_flat(corner, points->points.data[i]);
    if (flat)
        return true;
    bool ok = fill(points, &plane, &film);
    if (ok && film.faces.num > 0) {
        ok = csg_mesh_to_shape(&film, true, &shape);
        if (ok) {
            shape.facetted = sets->facetted;
            ok = csg_part_add(part, &shape, false);
        }
    }
    csg_mesh_finish(&film);
    return ok;
}
