/* SPDX-License-Identifier: MIT */
#include "csg/own_faces.h"

#include <stdlib.h>
#include <string.h>

#include "csg/carrier_builder.h"

struct csg_plane csg_own_plane(const struct csg_surface *surface, uint32_t face,
                               const struct csg_map *inverse)
{
    struct csg_plane plane = surface->planes.data[face];
    if (!csg_map_is_identity(inverse))
        csg_plane_map(&plane, inverse);
    return plane;
}

static bool is_same_plane(const struct csg_plane *a, const struct csg_plane *b)
{
    return a->normal.x == b->normal.x && a->normal.y == b->normal.y && a->normal.z == b->normal.z &&
           a->offset == b->offset;
}

/* No two faces lie upon each other: only those that follow each other share their plane. */
static void fill_simple(struct csg_surface *surface)
{
    const struct csg_plane *planes = surface->planes.data;
    for (uint32_t i = 0; i < surface->planes.num; i++)
        surface->own[i] = i > 0 && is_same_plane(&planes[i - 1], &planes[i])
                              ? surface->own[i - 1]
                              : (struct csg_own_face){i, false};
}

/* Of all faces of the surface; and which most of a large one are, so that nobody looks for what
 * they lie upon. */
static bool start_index(struct csg_carrier_builder *builder, const struct csg_surface *surface)
{
    const size_t num = surface->planes.num;
    uint8_t *near = malloc(num + 1);
    uint32_t face_begin[2] = {0, (uint32_t)num};
    if (!near)
        return false;
    memset(near, 1, num);
    builder->remote.near = &near;
    builder->carriers->face_begin = face_begin;
    const bool ok = csg_carrier_outline(builder) && csg_carrier_start_index(builder) &&
                    csg_loners_find(&builder->loners, builder);
    builder->carriers->face_begin = NULL;
    builder->remote.near = NULL;
    free(near);
    return ok;
}

static bool fill_from(struct csg_surface *surface, struct csg_carrier_builder *builder,
                      const struct csg_shape *shape)
{
    uint32_t *ranked = csg_carrier_rank_faces(surface->extents, surface->planes.num);
    uint32_t *firsts = malloc((surface->planes.num + 1) * sizeof *firsts); /* by carrier */
    bool ok = ranked && firsts && start_index(builder, surface);
    for (size_t i = 0; i < surface->planes.num && ok; i++) {
        const uint32_t plane = ranked[i];
        const struct csg_leaf_extent extent =
            csg_carrier_face_extent(&surface->extents[plane], shape->rounding);
        const size_t num = builder->carriers->num_planes;
        struct csg_face face;
        ok = csg_carrier_assign_plane(builder, &surface->planes.data[plane], &extent, NULL,
                                      csg_is_lone_plane(builder, plane), &face);
        if (ok && builder->carriers->num_planes > num)
            firsts[face.carrier] = plane;
        if (ok)
            surface->own[plane] = (struct csg_own_face){firsts[face.carrier], face.flipped};
    }
    free(ranked);
    free(firsts);
    return ok;
}

/* As the faces of a scene that has nothing but the surface. */
static bool fill_compared(struct csg_surface *surface, const struct csg_box *box)
{
    bool wanted = true;
    struct csg_leaf leaf = {
        .shape = {.surface = surface, .frame = csg_map_identity, .rounding = surface->rounding},
        .box = *box};
    const struct csgcast_scene scene = {.leaves = &leaf, .num_leaves = 1, .num_threads = 1};
    struct csg_carrier_builder builder = {
        .scene = &scene, .wanted = &wanted, .carriers = calloc(1, sizeof *builder.carriers)};
    const bool ok = builder.carriers && fill_from(surface, &builder, &leaf.shape);
    csg_carriers_destroy(builder.carriers);
    builder.carriers = NULL;
    builder.wanted = NULL;
    csg_carrier_builder_finish(&builder);
    return ok;
}

static void count(struct csg_surface *surface)
{
    surface->num_own = 0;
    for (uint32_t i = 0; i < surface->planes.num; i++)
        surface->num_own += surface->own[i].plane == i;
}

bool csg_own_faces_find(struct csg_surface *surface, const struct csg_box *box)
{
    surface->own = calloc(surface->planes.num + 1, sizeof *surface->own);
    bool ok = surface->own != NULL;
    if (ok && surface->is_simple)
        fill_simple(surface);
    else if (ok)
        ok = fill_compared(surface, box);
    if (ok)
        count(surface);
    return ok;
}
