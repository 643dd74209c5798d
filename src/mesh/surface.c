/* SPDX-License-Identifier: MIT */
#include "mesh/surface.h"

#include <stdlib.h>
#include <string.h>

#include "solids/shape.h"

/* Products of three numbers below this one, and squares of sums of them, are finite. */
#define MODERATE 1e70

void csg_surface_destroy(struct csg_surface *surface)
{
    if (!surface || surface->num_sharers-- > 0)
        return;
    csg_surface_destroy(surface->closed);
    free(surface->own);
    free(surface->extents);
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

struct csg_surface *csg_surface_share(struct csg_surface *surface)
{
    surface->num_sharers++;
    return surface;
}

struct csg_surface *csg_surface_copy(const struct csg_surface *surface)
{
    struct csg_surface *copy = calloc(1, sizeof *copy);
    if (copy && copy_array(&copy->points, &surface->points) &&
        copy_array(&copy->triangles, &surface->triangles) &&
        copy_array(&copy->planes, &surface->planes)) {
        copy->rounding = surface->rounding;
        copy->open = surface->open;
        copy->is_filled = surface->is_filled;
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

struct csg_surface *csg_surface_placed(struct csg_surface *surface, const struct csg_map *place)
{
    struct csg_map inverse;
    if (csg_map_is_identity(place))
        return csg_surface_share(surface);
    struct csg_surface *copy = csg_map_invert(place, &inverse) ? csg_surface_copy(surface) : NULL;
    if (!copy)
        return NULL;
    for (size_t i = 0; i < copy->points.num; i++)
        copy->points.data[i] = csg_map_point(place, copy->points.data[i]);
    for (size_t i = 0; i < copy->planes.num; i++)
        csg_plane_map(&copy->planes.data[i], &inverse);
    if (csg_map_determinant(place) < 0)
        for (size_t i = 0; i < copy->triangles.num; i++)
            swap_corners(&copy->triangles.data[i]);
    csg_surface_measure(copy);
    return copy;
}

void csg_surface_measure(struct csg_surface *surface)
{
    bool finite = true;
    double size = 0;
    for (size_t i = 0; i < surface->points.num; i++) {
        const struct csg_vec3 p = surface->points.data[i];
        finite &= csg_vec3_is_finite(p);
        size = fmax(size, csg_vec3_largest(p));
    }
    for (size_t i = 0; i < surface->planes.num; i++)
        finite &= csg_vec3_is_finite(surface->planes.data[i].normal) &&
                  isfinite(surface->planes.data[i].offset);
    surface->size = finite ? size : (double)INFINITY;
}

/* Maps so near to the limits of double that points or planes may pass them. */
static bool is_extreme(const struct csg_map *map)
{
    bool is_moderate = true;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            is_moderate &= fabs(map->m[i][j]) < MODERATE;
    return !is_moderate;
}

bool csg_surface_is_finite(struct csg_surface *surface, const struct csg_map *place)
{
    struct csg_map inverse;
    if (!isfinite(surface->size) || !csg_map_invert(place, &inverse))
        return false;
    if (!is_extreme(place) && !is_extreme(&inverse) && surface->size < MODERATE)
        return true;
    struct csg_surface *placed = csg_surface_placed(surface, place);
    const bool finite = placed && isfinite(placed->size);
    csg_surface_destroy(placed);
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
struct csg_surface_extent *csg_surface_extents(const struct csg_surface *surface,
                                               const struct csg_map *place)
{
    struct csg_surface_extent *extents = calloc(surface->planes.num + 1, sizeof *extents);
    if (!extents)
        return NULL;
    for (size_t i = 0; i < surface->triangles.num; i++) {
        const struct csg_triangle *triangle = &surface->triangles.data[i];
        struct csg_surface_extent *extent = &extents[triangle->plane];
        extent->radius += 3;
        for (int j = 0; j < 3; j++)
            extent->center = csg_add(
                extent->center, csg_map_point(place, surface->points.data[triangle->points[j]]));
    }
    for (size_t i = 0; i < surface->planes.num; i++) {
        const double num = extents[i].radius;
        extents[i] =
            (struct csg_surface_extent){csg_scale(num > 0 ? 1 / num : 0, extents[i].center), 0};
    }
    for (size_t i = 0; i < surface->triangles.num; i++) {
        const struct csg_triangle *triangle = &surface->triangles.data[i];
        struct csg_surface_extent *extent = &extents[triangle->plane];
        for (int j = 0; j < 3; j++) {
            const struct csg_vec3 corner =
                csg_map_point(place, surface->points.data[triangle->points[j]]);
            extent->radius = fmax(extent->radius, csg_length(csg_sub(corner, extent->center)));
        }
    }
    return extents;
}
