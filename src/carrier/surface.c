/* SPDX-License-Identifier: MIT */

/* Carriers of a surface's faces: each is as large as itself, not as its leaf. */

#include <stdlib.h>

#include "carrier/builder.h"
#include "carrier/own_faces.h"

struct ranked_plane {
    double radius;
    uint32_t plane;
};

static int compare_planes(const void *a, const void *b)
{
    const struct ranked_plane *x = a, *y = b;
    if (x->radius != y->radius)
        return x->radius > y->radius ? -1 : 1;
    return x->plane < y->plane ? -1 : x->plane > y->plane;
}

uint32_t *csg_carrier_rank_faces(const struct csg_surface_extent *extents, size_t num)
{
    struct ranked_plane *ranked = malloc((num + 1) * sizeof *ranked);
    uint32_t *faces = malloc((num + 1) * sizeof *faces);
    for (uint32_t i = 0; ranked && i < num; i++)
        ranked[i] = (struct ranked_plane){extents[i].radius, i};
    if (ranked && num > 1)
        qsort(ranked, num, sizeof *ranked, compare_planes);
    for (size_t i = 0; ranked && faces && i < num; i++)
        faces[i] = ranked[i].plane;
    const bool ok = ranked && faces;
    free(ranked);
    if (ok)
        return faces;
    free(faces);
    return NULL;
}

struct csg_leaf_extent csg_carrier_face_extent(const struct csg_surface_extent *extent,
                                               double rounding)
{
    return (struct csg_leaf_extent){extent->center, extent->radius, extent->radius, rounding};
}

struct csg_placed_faces *csg_placed_faces_create(const struct csg_shape *shape)
{
    struct csg_placed_faces *placed = calloc(1, sizeof *placed);
    if (!placed)
        return NULL;
    placed->extents = csg_surface_extents(shape->surface, &shape->frame);
    placed->order = placed->extents
                        ? csg_carrier_rank_faces(placed->extents, shape->surface->planes.num)
                        : NULL;
    placed->inverse = csg_map_identity;
    csg_map_invert(&shape->frame, &placed->inverse);
    if (placed->order)
        return placed;
    csg_placed_faces_destroy(placed);
    return NULL;
}

void csg_placed_faces_destroy(struct csg_placed_faces *placed)
{
    if (!placed)
        return;
    free(placed->extents);
    free(placed->order);
    free(placed);
}

uint32_t csg_carrier_face(const struct csg_carrier_builder *builder, const struct csg_rank *rank)
{
    const struct csg_placed_faces *placed = builder->placed ? builder->placed[rank->leaf] : NULL;
    return placed ? placed->order[rank->face] : rank->face;
}

struct csg_plane csg_carrier_plane(const struct csg_carrier_builder *builder,
                                   const struct csg_shape *shape, const struct csg_rank *rank)
{
    const uint32_t face = csg_carrier_face(builder, rank);
    return shape->surface
               ? csg_own_plane(shape->surface, face, &builder->placed[rank->leaf]->inverse)
               : shape->planes[face];
}

struct csg_leaf_extent csg_carrier_extent(const struct csg_carrier_builder *builder,
                                          const struct csg_rank *rank)
{
    const struct csg_shape *shape = &builder->scene->leaves[rank->leaf].shape;
    if (!shape->surface)
        return csg_leaf_extent_of(builder, rank->leaf);
    const struct csg_placed_faces *placed = builder->placed[rank->leaf];
    return csg_carrier_face_extent(&placed->extents[placed->order[rank->face]], shape->rounding);
}

/* Each face that is not remote counts where it is, the largest first. */
static bool assign_faces(struct csg_carrier_builder *builder, const struct csg_rank *rank,
                         const uint8_t *near)
{
    const uint32_t leaf = rank->leaf;
    struct csg_rank own = *rank;
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const size_t begin = builder->carriers->face_begin[leaf], num = shape->surface->planes.num;
    struct csg_face *faces = &builder->carriers->faces[begin];
    bool ok = true;
    for (; ok && own.face < num; own.face++) {
        const uint32_t face = csg_carrier_face(builder, &own);
        const struct csg_plane plane = csg_carrier_plane(builder, shape, &own);
        const struct csg_leaf_extent extent = csg_carrier_extent(builder, &own);
        if (near[face])
            ok = csg_carrier_assign_plane(builder, &plane, &extent, &own,
                                          csg_is_lone_plane(builder, begin + face), &faces[face]);
        else
            faces[face].carrier = CSG_NO_CARRIER;
    }
    return ok;
}

void csg_carrier_count_own(const struct csg_carrier_builder *builder, uint32_t leaf)
{
    const struct csg_surface *surface = builder->scene->leaves[leaf].shape.surface;
    const uint8_t *near = builder->remote.near[leaf];
    size_t num_faces = surface->planes.num, num_own = surface->num_own;
    for (uint32_t i = 0; near && i < surface->planes.num; i++) {
        num_faces -= near[i];
        num_own -= near[i] && surface->own[i].plane == i;
    }
    builder->carriers->num_own += num_own;
    builder->carriers->num_shared += num_faces - num_own;
}

/* What is kept of the places of faces is for edits. */
bool csg_carrier_assign_surface(struct csg_carrier_builder *builder, const struct csg_rank *rank)
{
    const uint32_t leaf = rank->leaf;
    const uint8_t *near = builder->remote.near[leaf];
    struct csg_placed_faces **placed = &builder->placed[leaf];
    csg_carrier_count_own(builder, leaf);
    if (!near)
        return true;
    if (!*placed)
        *placed = csg_placed_faces_create(&builder->scene->leaves[leaf].shape);
    const bool ok = *placed && assign_faces(builder, rank, near);
    if (builder->keeps)
        return ok;
    csg_placed_faces_destroy(*placed);
    *placed = NULL;
    return ok;
}
