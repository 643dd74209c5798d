/* SPDX-License-Identifier: MIT */
#include "csg/carrier.h"

#include <stdlib.h>
#include <string.h>

#include "csg/carrier_builder.h"
#include "csg/object.h"
#include "csg/own_faces.h"
#include "mesh/surface.h"

/* Appends to an array that lives in struct csg_carriers. */
#define push_carrier(carriers, name, value)                                                        \
    (((carriers)->num_##name < (carriers)->name##_capacity ||                                      \
      csg_array_grow((void **)&(carriers)->name, &(carriers)->name##_capacity,                     \
                     (carriers)->num_##name, 1, sizeof *(carriers)->name))                         \
         ? ((carriers)->name[(carriers)->num_##name++] = (value), true)                            \
         : false)

/* Who came to a new carrier, where edits will ask. */
#define note_owner(builder, kind, carrier, rank)                                                   \
    (!(builder)->keeps ||                                                                          \
     ((carrier) < (builder)->kind##_ranks.num                                                      \
          ? ((builder)->kind##_ranks.data[carrier] = *(rank),                                      \
             (builder)->kind##_uses.data[carrier] = 0, true)                                       \
          : csg_array_push(&(builder)->kind##_ranks, *(rank)) &&                                   \
                csg_array_push(&(builder)->kind##_uses, 0)))

/* A carrier's place: one that edits have left, or at the end. */
static bool place_plane(struct csg_carrier_builder *builder, const struct csg_plane *plane,
                        double rounding, uint32_t *carrier)
{
    struct csg_carriers *carriers = builder->carriers;
    if (builder->free_planes.num == 0) {
        *carrier = (uint32_t)carriers->num_planes;
        return push_carrier(carriers, planes, *plane) &&
               csg_array_push(&builder->plane_rounding, rounding);
    }
    *carrier = builder->free_planes.data[--builder->free_planes.num];
    carriers->planes[*carrier] = *plane;
    builder->plane_rounding.data[*carrier] = rounding;
    return true;
}

static bool place_quadric(struct csg_carrier_builder *builder, uint32_t leaf, double rounding,
                          uint32_t *carrier)
{
    struct csg_carriers *carriers = builder->carriers;
    if (builder->free_quadrics.num == 0) {
        *carrier = (uint32_t)carriers->num_quadrics++;
        return push_carrier(carriers, quadric_boxes, csg_box_empty) &&
               push_carrier(carriers, quadric_leaves, leaf) &&
               csg_array_push(&builder->quadric_rounding, rounding);
    }
    *carrier = builder->free_quadrics.data[--builder->free_quadrics.num];
    carriers->quadric_leaves[*carrier] = leaf;
    builder->quadric_rounding.data[*carrier] = rounding;
    return true;
}

static bool add_plane(struct csg_carrier_builder *builder, const struct csg_plane *plane,
                      const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                      bool alone, struct csg_face *face)
{
    *face = (struct csg_face){0};
    return place_plane(builder, plane, extent->rounding, &face->carrier) &&
           note_owner(builder, plane, face->carrier, rank) &&
           (alone || csg_index_add_plane(&builder->index, plane, face->carrier));
}

static bool add_quadric(struct csg_carrier_builder *builder, uint32_t leaf,
                        const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                        bool alone, struct csg_face *face)
{
    const struct csg_quadric *quadric = &builder->scene->leaves[leaf].shape.quadric;
    *face = (struct csg_face){0};
    return place_quadric(builder, leaf, extent->rounding, &face->carrier) &&
           note_owner(builder, quadric, face->carrier, rank) &&
           (alone || csg_index_add_quadric(&builder->index, quadric, face->carrier));
}

/* The sheet as the carrier's canonical space counts it: its z axis may point the other way. */
static int8_t carrier_sheet(const struct csg_shape *shape, const struct csg_quadric *carrier)
{
    const double *a = shape->quadric.to_canon.m[2], *b = carrier->to_canon.m[2];
    return (int8_t)(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < 0 ? -shape->sheet : shape->sheet);
}

static bool is_loner(const struct csg_carrier_builder *builder, const uint8_t *loners, size_t i)
{
    return builder->is_alone || (loners && loners[i]);
}

static bool assign_plane(struct csg_carrier_builder *builder, const struct csg_plane *plane,
                         const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                         bool alone, struct csg_face *face)
{
    struct csg_carriers *carriers = builder->carriers;
    if (alone)
        return add_plane(builder, plane, extent, rank, alone, face);
    const bool was_met = csg_plane_table_find(&builder->planes, carriers->planes, plane, face);
    const bool is_shared = was_met || csg_carrier_find_plane(builder, plane, extent, rank, face);
    carriers->num_shared += is_shared;
    if (!(is_shared || add_plane(builder, plane, extent, rank, alone, face)) ||
        !(was_met || csg_plane_table_add(&builder->planes, carriers->planes, plane, face)))
        return false;
    if (builder->keeps)
        builder->plane_uses.data[face->carrier]++;
    return true;
}

bool csg_carrier_assign_plane(struct csg_carrier_builder *builder, const struct csg_plane *plane,
                              const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                              struct csg_face *face)
{
    return assign_plane(builder, plane, extent, rank, false, face);
}

static bool assign_quadric(struct csg_carrier_builder *builder, uint32_t leaf,
                           const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                           bool alone)
{
    struct csg_carriers *carriers = builder->carriers;
    struct csg_face *face = &carriers->quadric_faces[leaf];
    if (!alone && csg_carrier_find_quadric(builder, leaf, extent, rank, face))
        carriers->num_shared++;
    else if (!add_quadric(builder, leaf, extent, rank, alone, face))
        return false;
    if (builder->keeps)
        builder->quadric_uses.data[face->carrier]++;
    carriers->sheets[leaf] =
        carrier_sheet(&builder->scene->leaves[leaf].shape,
                      csg_carrier_quadric(builder->scene, carriers, face->carrier));
    return true;
}

bool csg_carrier_assign_quadric(struct csg_carrier_builder *builder, uint32_t leaf,
                                const struct csg_leaf_extent *extent, const struct csg_rank *rank)
{
    return assign_quadric(builder, leaf, extent, rank, false);
}

/* ---- surfaces ----------------------------------------------------------------------------- */

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

uint32_t csg_num_faces(const struct csgcast_scene *scene, uint32_t leaf)
{
    const struct csg_shape *shape = &scene->leaves[leaf].shape;
    return shape->surface ? (uint32_t)shape->surface->planes.num : shape->num_planes;
}

struct csg_plane csg_carrier_of_face(const struct csgcast_scene *scene, uint32_t leaf,
                                     uint32_t face, const struct csg_map *inverse, bool *flipped)
{
    const struct csg_carriers *carriers = scene->carriers;
    const struct csg_surface *surface = scene->leaves[leaf].shape.surface;
    const uint32_t begin = carriers->face_begin[leaf];
    const bool is_own = surface && (begin == carriers->face_begin[leaf + 1] ||
                                    carriers->faces[begin + face].carrier == CSG_NO_CARRIER);
    *flipped = is_own ? surface->own[face].flipped : carriers->faces[begin + face].flipped;
    return is_own ? csg_own_plane(surface, surface->own[face].plane, inverse)
                  : carriers->planes[carriers->faces[begin + face].carrier];
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
            ok = assign_plane(builder, &plane, &extent, &own,
                              is_loner(builder, builder->loners.planes, begin + face),
                              &faces[face]);
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

static bool assign_surface(struct csg_carrier_builder *builder, const struct csg_rank *rank)
{
    const uint32_t leaf = rank->leaf;
    const uint8_t *near = builder->remote.near[leaf];
    count_own(builder->carriers, builder->scene->leaves[leaf].shape.surface, near);
    return !near || assign_faces(builder, rank, near);
}

static bool assign_leaf(struct csg_carrier_builder *builder, const struct csg_rank *rank)
{
    struct csg_carriers *carriers = builder->carriers;
    const uint32_t leaf = rank->leaf;
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const struct csg_leaf_extent extent = csg_leaf_extent_of(builder, leaf);
    struct csg_rank own = *rank;
    if (shape->surface)
        return assign_surface(builder, rank);
    for (; own.face < shape->num_planes; own.face++) {
        const size_t face = carriers->face_begin[leaf] + own.face;
        const bool alone = is_loner(builder, builder->loners.planes, face);
        if (!assign_plane(builder, &shape->planes[own.face], &extent, &own, alone,
                          &carriers->faces[face]))
            return false;
    }
    return !shape->has_quadric ||
           assign_quadric(builder, leaf, &extent, rank,
                          is_loner(builder, builder->loners.quadrics, leaf));
}

/* Faces of surfaces have a place where not all are remote. */
static size_t count_faces(const struct csg_carrier_builder *builder, size_t leaf)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    if (!shape->surface)
        return shape->num_planes;
    return builder->remote.near && builder->remote.near[leaf] ? shape->surface->planes.num : 0;
}

bool csg_carriers_allocate_faces(struct csg_carrier_builder *builder)
{
    struct csg_carriers *carriers = builder->carriers;
    const struct csgcast_scene *scene = builder->scene;
    const size_t num = scene->num_leaves;
    carriers->face_begin = malloc((num + 1) * sizeof *carriers->face_begin);
    if (!carriers->face_begin)
        return false;
    uint32_t total = 0;
    for (size_t i = 0; i < num; i++) {
        carriers->face_begin[i] = total;
        total += (uint32_t)count_faces(builder, i);
    }
    carriers->face_begin[num] = total;
    carriers->faces = calloc(total + 1, sizeof *carriers->faces);
    carriers->quadric_faces = malloc((num + 1) * sizeof *carriers->quadric_faces);
    carriers->sheets = calloc(num + 1, sizeof *carriers->sheets);
    if (!carriers->faces || !carriers->quadric_faces || !carriers->sheets)
        return false;
    for (size_t i = 0; i < num; i++)
        carriers->quadric_faces[i] = (struct csg_face){.carrier = CSG_NO_CARRIER};
    return true;
}

/* Edits are followed where leaves have bounds and are neither surfaces nor specks: what the others'
 * faces lie on depends on more than the faces near them. */
static bool can_keep(const struct csg_carrier_builder *builder)
{
    for (size_t i = 0; i < builder->leaves.num; i++)
        if (!csg_carrier_can_follow(builder, builder->leaves.data[i].leaf))
            return false;
    return builder->leaves.num > 1;
}

/* Coincidence is looked for among all leaves: flush faces of different objects share carriers too,
 * so that the depth buffer sees equal depths and the first object wins everywhere. */
static bool assign_all(struct csg_carrier_builder *builder)
{
    if (!csg_carrier_rank_leaves(builder))
        return false;
    builder->keeps = builder->keeps && can_keep(builder);
    builder->is_alone = builder->leaves.num == 1 &&
                        !builder->scene->leaves[builder->leaves.data[0].leaf].shape.surface;
    if (!builder->is_alone &&
        (!csg_carrier_start_index(builder) ||
         !csg_remote_find(&builder->remote, builder->scene, builder->wanted,
                          builder->largest_rounding)))
        return false;
    if (!csg_carriers_allocate_faces(builder) || (!builder->is_alone && !builder->keeps &&
                               !csg_loners_find(&builder->loners, builder)))
        return false;
    for (size_t i = 0; i < builder->leaves.num; i++)
        if (!assign_leaf(builder, &builder->leaves.data[i]))
            return false;
    return true;
}

/* Its leaves, as far as the objects reach that they are in. */
void csg_carriers_fill_boxes(const struct csgcast_scene *scene, struct csg_carriers *carriers)
{
    for (size_t i = 0; i < carriers->num_quadric_boxes; i++)
        carriers->quadric_boxes[i] = csg_box_empty;
    for (size_t i = 0; i < scene->objects->num; i++) {
        const struct csg_object *object = &scene->objects->data[i];
        const struct csg_node *nodes = scene->trees[object->layer].data;
        for (uint32_t j = object->begin; j < object->end; j++) {
            const struct csg_face face = nodes[j].op == CSG_LEAF && !nodes[j].spare
                                             ? carriers->quadric_faces[nodes[j].leaf]
                                             : (struct csg_face){.carrier = CSG_NO_CARRIER};
            if (face.carrier == CSG_NO_CARRIER)
                continue;
            struct csg_box box = csg_leaf_box(&scene->leaves[nodes[j].leaf]);
            box = csg_box_intersection(&box, &object->box);
            if (!csg_box_is_empty(&box))
                carriers->quadric_boxes[face.carrier] =
                    csg_box_union(&carriers->quadric_boxes[face.carrier], &box);
        }
    }
}

void csg_carrier_builder_finish(struct csg_carrier_builder *builder)
{
    csg_index_finish(&builder->index);
    csg_remote_finish(&builder->remote);
    csg_loners_finish(&builder->loners);
    free(builder->wanted);
    csg_plane_table_finish(&builder->planes);
    free(builder->plane_rounding.data);
    free(builder->quadric_rounding.data);
    free(builder->plane_ranks.data);
    free(builder->quadric_ranks.data);
    free(builder->plane_uses.data);
    free(builder->quadric_uses.data);
    free(builder->free_planes.data);
    free(builder->free_quadrics.data);
    free(builder->leaves.data);
}

void csg_carrier_builder_destroy(struct csg_carrier_builder *builder)
{
    if (builder)
        csg_carrier_builder_finish(builder);
    free(builder);
}

struct csg_carriers *csg_carriers_create(const struct csgcast_scene *scene, bool keeps)
{
    struct csg_carriers *carriers = calloc(1, sizeof *carriers);
    struct csg_carrier_builder *builder = calloc(1, sizeof *builder);
    if (carriers && builder) {
        *builder = (struct csg_carrier_builder){
            .scene = scene, .carriers = carriers, .keeps = keeps};
        if (assign_all(builder)) {
            csg_carriers_fill_boxes(scene, carriers);
            carriers->kept = builder->keeps ? builder : NULL;
            if (!builder->keeps)
                csg_carrier_builder_destroy(builder);
            return carriers;
        }
    }
    csg_carrier_builder_destroy(builder);
    csg_carriers_destroy(carriers);
    return NULL;
}

void csg_carriers_destroy(struct csg_carriers *carriers)
{
    if (!carriers)
        return;
    csg_carrier_builder_destroy(carriers->kept);
    free(carriers->planes);
    free(carriers->quadric_boxes);
    free(carriers->quadric_leaves);
    free(carriers->face_begin);
    free(carriers->faces);
    free(carriers->quadric_faces);
    free(carriers->sheets);
    free(carriers->renewed);
    free(carriers);
}
