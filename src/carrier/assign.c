/* SPDX-License-Identifier: MIT */

/* Gives a face its carrier: one that it lies on, or a new one. */

#include "carrier/builder.h"

/* A new carrier: one that edits have left, or at the end. rank: of the face that it comes from. */
static bool place(struct csg_carrier_builder *builder, enum csg_face_kind kind,
                  const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                  uint32_t *carrier)
{
    struct csg_carrier_list *list = &builder->lists[kind];
    if (list->free.num == 0) {
        *carrier = (uint32_t)list->rounding.num;
        return csg_array_push(&list->rounding, extent->rounding) &&
               (!builder->keeps ||
                (csg_array_push(&list->ranks, *rank) && csg_array_push(&list->uses, 0)));
    }
    *carrier = list->free.data[--list->free.num];
    list->rounding.data[*carrier] = extent->rounding;
    list->ranks.data[*carrier] = *rank;
    list->uses.data[*carrier] = 0;
    return true;
}

static bool put_plane(struct csg_carriers *carriers, uint32_t carrier,
                      const struct csg_plane *plane)
{
    if (carrier == carriers->planes_capacity &&
        !csg_array_grow((void **)&carriers->planes, &carriers->planes_capacity, carrier, 1,
                        sizeof *carriers->planes))
        return false;
    carriers->num_planes += carrier == carriers->num_planes;
    carriers->planes[carrier] = *plane;
    return true;
}

static bool put_quadric(struct csg_carriers *carriers, uint32_t carrier, uint32_t leaf)
{
    if (carrier == carriers->quadric_leaves_capacity &&
        !csg_array_grow((void **)&carriers->quadric_leaves, &carriers->quadric_leaves_capacity,
                        carrier, 1, sizeof *carriers->quadric_leaves))
        return false;
    carriers->num_quadrics += carrier == carriers->num_quadrics;
    carriers->quadric_leaves[carrier] = leaf;
    return true;
}

static bool add_plane(struct csg_carrier_builder *builder, const struct csg_plane *plane,
                      const struct csg_leaf_extent *extent, const struct csg_rank *rank, bool alone,
                      struct csg_face *face)
{
    *face = (struct csg_face){0};
    return place(builder, CSG_PLANE, extent, rank, &face->carrier) &&
           put_plane(builder->carriers, face->carrier, plane) &&
           (alone || csg_index_add_plane(&builder->index, plane, face->carrier));
}

static bool add_quadric(struct csg_carrier_builder *builder, uint32_t leaf,
                        const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                        bool alone, struct csg_face *face)
{
    const struct csg_quadric *quadric = &builder->scene->leaves[leaf].shape.quadric;
    *face = (struct csg_face){0};
    return place(builder, CSG_QUADRIC, extent, rank, &face->carrier) &&
           put_quadric(builder->carriers, face->carrier, leaf) &&
           (alone || csg_index_add_quadric(&builder->index, quadric, face->carrier));
}

static void count_use(struct csg_carrier_builder *builder, enum csg_face_kind kind,
                      const struct csg_face *face)
{
    if (builder->keeps)
        builder->lists[kind].uses.data[face->carrier]++;
}

bool csg_carrier_assign_plane(struct csg_carrier_builder *builder, const struct csg_plane *plane,
                              const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                              bool alone, struct csg_face *face)
{
    struct csg_carriers *carriers = builder->carriers;
    const bool was_met = !alone && csg_carrier_find_met(builder, plane, face);
    const bool is_other =
        !alone && !was_met && csg_carrier_find_plane(builder, plane, extent, rank, face);
    carriers->num_shared += was_met || is_other;
    if (is_other ? !csg_plane_table_add(&builder->others, plane, face)
                 : !was_met && !add_plane(builder, plane, extent, rank, alone, face))
        return false;
    count_use(builder, CSG_PLANE, face);
    return true;
}

/* The sheet as the carrier's canonical space counts it: its z axis may point the other way. */
static int8_t carrier_sheet(const struct csg_shape *shape, const struct csg_quadric *carrier)
{
    const double *a = shape->quadric.to_canon.m[2], *b = carrier->to_canon.m[2];
    return (int8_t)(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < 0 ? -shape->sheet : shape->sheet);
}

bool csg_carrier_assign_quadric(struct csg_carrier_builder *builder, uint32_t leaf,
                                const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                                bool alone)
{
    struct csg_carriers *carriers = builder->carriers;
    struct csg_face *face = &carriers->quadric_faces[leaf];
    if (!alone && csg_carrier_find_quadric(builder, leaf, extent, rank, face))
        carriers->num_shared++;
    else if (!add_quadric(builder, leaf, extent, rank, alone, face))
        return false;
    count_use(builder, CSG_QUADRIC, face);
    carriers->sheets[leaf] =
        carrier_sheet(&builder->scene->leaves[leaf].shape,
                      csg_carrier_quadric(builder->scene, carriers, face->carrier));
    return true;
}

static bool is_lone_quadric(const struct csg_carrier_builder *builder, uint32_t leaf)
{
    return builder->is_alone || (builder->loners.quadrics && builder->loners.quadrics[leaf]);
}

bool csg_carrier_assign_leaf(struct csg_carrier_builder *builder, const struct csg_rank *rank)
{
    struct csg_carriers *carriers = builder->carriers;
    const uint32_t leaf = rank->leaf;
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const struct csg_leaf_extent extent = csg_leaf_extent_of(builder, leaf);
    struct csg_rank own = *rank;
    if (shape->surface)
        return csg_carrier_assign_surface(builder, rank);
    for (; own.face < shape->num_planes; own.face++) {
        const size_t face = carriers->face_begin[leaf] + own.face;
        if (!csg_carrier_assign_plane(builder, &shape->planes[own.face], &extent, &own,
                                      csg_is_lone_plane(builder, face), &carriers->faces[face]))
            return false;
    }
    return !shape->has_quadric ||
           csg_carrier_assign_quadric(builder, leaf, &extent, rank, is_lone_quadric(builder, leaf));
}
