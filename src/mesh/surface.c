/* SPDX-License-Identifier: MIT */
#include "mesh/surface.h"

#include <stdlib.h>
#include <string.h>

#include "solids/shape.h"

void csg_surface_destroy(struct csg_surface *surface)
{
    if (!surface)
        return;
    free(surface->points.data);
    free(surface->triangles.data);
    free(surface->planes.data);
    free(surface->nodes.data);
    free(surface);
}

#define copy_array(to, from)                                                                       \
    (csg_array_reserve(to, (from)->num) &&                                                         \
     ((from)->num == 0 ||                                                                          \
      memcpy((to)->data, (from)->data, (from)->num * sizeof *(to)->data) != NULL) &&               \
     ((to)->num = (from)->num, true))

struct csg_surface *csg_surface_copy(const struct csg_surface *surface)
{
    struct csg_surface *copy = calloc(1, sizeof *copy);
    if (copy && copy_array(&copy->points, &surface->points) &&
        copy_array(&copy->triangles, &surface->triangles) &&
        copy_array(&copy->planes, &surface->planes) && copy_array(&copy->nodes, &surface->nodes)) {
        copy->open = surface->open;
        copy->is_simple = surface->is_simple;
        return copy;
    }
    csg_surface_destroy(copy);
    return NULL;
}

static void swap_corners(struct csg_triangle *triangle)
{
    const uint32_t point = triangle->points[1];
    triangle->points[1] = triangle->points[2];
    triangle->points[2] = point;
}

bool csg_surface_map(struct csg_surface *surface, const struct csg_map *map)
{
    struct csg_map inverse = csg_map_identity;
    if (!csg_map_invert(map, &inverse) && surface->triangles.num > 0)
        return false;
    for (size_t i = 0; i < surface->points.num; i++)
        surface->points.data[i] = csg_map_point(map, surface->points.data[i]);
    for (size_t i = 0; i < surface->planes.num; i++)
        csg_plane_map(&surface->planes.data[i], &inverse);
    if (csg_map_determinant(map) < 0)
        for (size_t i = 0; i < surface->triangles.num; i++)
            swap_corners(&surface->triangles.data[i]);
    surface->nodes.num = 0;
    return true;
}

static bool is_finite(struct csg_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

bool csg_surface_is_finite(const struct csg_surface *surface)
{
    bool finite = true;
    for (size_t i = 0; i < surface->points.num; i++)
        finite &= is_finite(surface->points.data[i]);
    for (size_t i = 0; i < surface->planes.num; i++)
        finite &= is_finite(surface->planes.data[i].normal) &&
                  isfinite(surface->planes.data[i].offset);
    return finite;
}

struct csg_box csg_surface_box(const struct csg_surface *surface)
{
    struct csg_box box = csg_box_empty;
    for (size_t i = 0; i < surface->triangles.num; i++)
        for (int j = 0; j < 3; j++)
            csg_box_extend(&box, surface->points.data[surface->triangles.data[i].points[j]]);
    return box;
}

/* Centres are means of corners, then radii reach the farthest. */
struct csg_surface_extent *csg_surface_extents(const struct csg_surface *surface)
{
    struct csg_surface_extent *extents = calloc(surface->planes.num + 1, sizeof *extents);
    if (!extents)
        return NULL;
    for (size_t i = 0; i < surface->triangles.num; i++) {
        const struct csg_triangle *triangle = &surface->triangles.data[i];
        struct csg_surface_extent *extent = &extents[triangle->plane];
        extent->radius += 3;
        for (int j = 0; j < 3; j++)
            extent->center =
                csg_add(extent->center, surface->points.data[triangle->points[j]]);
    }
    for (size_t i = 0; i < surface->planes.num; i++) {
        const double num = extents[i].radius;
        extents[i] = (struct csg_surface_extent){csg_scale(num > 0 ? 1 / num : 0,
                                                           extents[i].center), 0};
    }
    for (size_t i = 0; i < surface->triangles.num; i++) {
        const struct csg_triangle *triangle = &surface->triangles.data[i];
        struct csg_surface_extent *extent = &extents[triangle->plane];
        for (int j = 0; j < 3; j++) {
            const struct csg_vec3 corner = surface->points.data[triangle->points[j]];
            extent->radius = fmax(extent->radius, csg_length(csg_sub(corner, extent->center)));
        }
    }
    return extents;
}
