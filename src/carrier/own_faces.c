/* SPDX-License-Identifier: MIT */
#include "carrier/own_faces.h"

#include <stdlib.h>

#include "carrier/builder.h"
#include "carrier/overlaps.h"

struct csg_plane csg_own_plane(const struct csg_surface *surface, uint32_t face,
                               const struct csg_map *inverse)
{
    struct csg_plane plane = surface->planes.data[face];
    if (!csg_map_is_identity(inverse))
        csg_plane_map(&plane, inverse);
    return plane;
}

/* Of faces that lie upon no other one only those that follow each other share their plane. */
static void fill_own(struct csg_surface *surface, const uint8_t *near, uint32_t i)
{
    const struct csg_plane *planes = surface->planes.data;
    surface->own[i] = i > 0 && !near[i - 1] && csg_plane_is_same(&planes[i - 1], &planes[i])
                          ? surface->own[i - 1]
                          : (struct csg_own_face){i, false};
}

/* Of the faces that are near others; and which of them, where they are many, lie upon nothing. */
static bool start_index(struct csg_carrier_builder *builder, const struct csg_surface *surface,
                        uint8_t *near)
{
    uint32_t face_begin[2] = {0, (uint32_t)surface->planes.num};
    builder->remote.near = &near;
    builder->carriers->face_begin = face_begin;
    const bool ok = csg_carrier_outline(builder) && csg_carrier_start_index(builder) &&
                    csg_loners_find(&builder->loners, builder);
    builder->carriers->face_begin = NULL;
    builder->remote.near = NULL;
    return ok;
}

static bool fill_from(struct csg_surface *surface, struct csg_carrier_builder *builder,
                      const struct csg_shape *shape, uint8_t *near)
{
    const size_t num = surface->planes.num;
    uint32_t *ranked = csg_carrier_rank_faces(surface->extents, num);
    uint32_t *firsts = malloc((num + 1) * sizeof *firsts); /* by carrier */
    bool ok = ranked && firsts && start_index(builder, surface, near);
    for (size_t i = 0; i < num && ok; i++) {
        const uint32_t plane = ranked[i];
        if (!near[plane])
            continue;
        const struct csg_leaf_extent extent =
            csg_carrier_face_extent(&surface->extents[plane], shape->rounding);
        const size_t num_carriers = builder->carriers->num_planes;
        struct csg_face face;
        ok = csg_carrier_assign_plane(builder, &surface->planes.data[plane], &extent, NULL,
                                      csg_is_lone_plane(builder, plane), &face);
        if (ok && builder->carriers->num_planes > num_carriers)
            firsts[face.carrier] = plane;
        if (ok)
            surface->own[plane] = (struct csg_own_face){firsts[face.carrier], face.flipped};
    }
    free(ranked);
    free(firsts);
    return ok;
}

/* As the faces of a scene that has nothing but the surface. */
static bool fill_compared(struct csg_surface *surface, const struct csg_box *box, uint8_t *near)
{
    bool wanted = true;
    struct csg_leaf leaf = {
        .shape = {.surface = surface, .frame = csg_map_identity, .rounding = surface->rounding},
        .box = *box};
    const struct csgcast_scene scene = {.leaves = &leaf, .num_leaves = 1, .num_threads = 1};
    struct csg_carrier_builder builder = {
        .scene = &scene, .wanted = &wanted, .carriers = calloc(1, sizeof *builder.carriers)};
    const bool ok = builder.carriers && fill_from(surface, &builder, &leaf.shape, near);
    csg_carriers_destroy(builder.carriers);
    builder.carriers = NULL;
    builder.wanted = NULL;
    csg_carrier_builder_finish(&builder);
    return ok;
}

/* The most of any face. */
static double tolerance_of(const struct csg_surface *surface, const struct csg_box *box)
{
    const struct csg_leaf_extent extent = {box->lo, 0, csg_length(csg_sub(box->hi, box->lo)),
                                           surface->rounding};
    return csg_carrier_tolerance(&extent, surface->rounding);
}

static bool fill(struct csg_surface *surface, const struct csg_box *box, int num_threads)
{
    const size_t num = surface->planes.num;
    uint8_t *near = calloc(num + 1, sizeof *near);
    bool ok = near && (surface->is_simple ||
                       csg_overlaps_find(surface, tolerance_of(surface, box), num_threads, near));
    bool is_any = false;
    for (uint32_t i = 0; i < num && ok; i++) {
        fill_own(surface, near, i);
        is_any |= near[i];
    }
    ok = ok && (!is_any || fill_compared(surface, box, near));
    free(near);
    return ok;
}

static void count(struct csg_surface *surface)
{
    surface->num_own = 0;
    for (uint32_t i = 0; i < surface->planes.num; i++)
        surface->num_own += surface->own[i].plane == i;
}

bool csg_own_faces_find(struct csg_surface *surface, const struct csg_box *box, int num_threads)
{
    surface->own = calloc(surface->planes.num + 1, sizeof *surface->own);
    if (!surface->own || !fill(surface, box, num_threads)) {
        free(surface->own); /* a surface that has it is ready */
        surface->own = NULL;
        return false;
    }
    count(surface);
    return true;
}
