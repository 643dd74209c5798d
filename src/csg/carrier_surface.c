/* SPDX-License-Identifier: MIT */

/* Carriers of a surface's faces: each is as large as itself, not as its leaf. */

#include <stdlib.h>

#include "csg/carrier_builder.h"
#include "csg/own_faces.h"

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

/* Each face that is not remote counts where it is, the largest first. */
static bool assign_faces(struct csg_carrier_builder *builder, const struct csg_rank *rank,
                         const uint8_t *near)
{
    const uint32_t leaf = rank->leaf;
    struct csg_rank own = *rank;
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const size_t begin = builder->carriers->face_begin[leaf], num = shape->surface->planes.num;
    struct csg_face *faces = &builder->carriers->faces[begin];
    struct csg_surface_extent *extents = csg_surface_extents(shape->surface, &shape->frame);
    uint32_t *ranked = extents ? csg_carrier_rank_faces(extents, num) : NULL;
    struct csg_map inverse = csg_map_identity;
    bool ok = ranked != NULL;
    csg_map_invert(&shape->frame, &inverse);
    for (; ok && own.face < num; own.face++) {
        const uint32_t face = ranked[own.face];
        const struct csg_plane plane = csg_own_plane(shape->surface, face, &inverse);
        const struct csg_leaf_extent extent =
            csg_carrier_face_extent(&extents[face], shape->rounding);
        if (near[face])
            ok = csg_carrier_assign_plane(builder, &plane, &extent, &own,
                                          csg_is_lone_plane(builder, begin + face), &faces[face]);
        else
            faces[face].carrier = CSG_NO_CARRIER;
    }
    free(extents);
    free(ranked);
    return ok;
}

/* How many of the surface's own planes stand for faces of the leaf. */
static void count_own(struct csg_carriers *carriers, const struct csg_surface *surface,
                      const uint8_t *near)
{
    size_t num_faces = surface->planes.num, num_own = surface->num_own;
    for (uint32_t i = 0; near && i < surface->planes.num; i++) {
        num_faces -= near[i];
        num_own -= near[i] && surface->own[i].plane == i;
    }
    carriers->num_own += num_own;
    carriers->num_shared += num_faces - num_own;
}

bool csg_carrier_assign_surface(struct csg_carrier_builder *builder, const struct csg_rank *rank)
{
    const uint32_t leaf = rank->leaf;
    const uint8_t *near = builder->remote.near[leaf];
    count_own(builder->carriers, builder->scene->leaves[leaf].shape.surface, near);
    return !near || assign_faces(builder, rank, near);
}
