/* SPDX-License-Identifier: MIT */

/* Leaves of an edit that go and come, and the carriers which that concerns. */

#include <string.h>

#include "carrier/change.h"

bool csg_carrier_affect(struct csg_carrier_change *change, enum csg_face_kind kind,
                        uint32_t carrier)
{
    struct csg_carrier_work *work = &change->work[kind];
    if (carrier >= work->num_marks || work->marks[carrier])
        return true; /* is known to be */
    work->marks[carrier] = 1;
    return csg_array_push(&work->affected, carrier);
}

/* Where it was another's face, with the carrier's own numbers, that has an effect on no one. */
static bool leave(struct csg_carrier_change *change, enum csg_face_kind kind, uint32_t leaf,
                  const struct csg_face *face)
{
    struct csg_carrier_list *list = &change->builder->lists[kind];
    const bool is_first = list->ranks.data[face->carrier].leaf == leaf;
    list->uses.data[face->carrier]--;
    return !(is_first || face->is_other) || csg_carrier_affect(change, kind, face->carrier);
}

static bool take_out_plane(struct csg_carrier_change *change, const struct csg_rank *rank)
{
    const struct csg_carriers *old = change->before->scene->carriers;
    const struct csg_face *face =
        &old->faces[old->face_begin[rank->leaf] + csg_carrier_face(change->builder, rank)];
    if (face->is_other) {
        const struct csg_plane plane =
            csg_carrier_plane(change->builder, csg_shape_before(change, rank->leaf), rank);
        csg_plane_table_remove(&change->builder->others, &plane);
    }
    return leave(change, CSG_PLANE, rank->leaf, face);
}

/*
 * Whether a plane of a leaf that has changed is the carrier that came from it, to the last bit, as
 * those are that a solid is moved along: where no carrier before it is found for it now, it makes
 * no difference to any other face.
 */
static bool stays(const struct csg_carrier_change *change, const struct csg_rank *rank)
{
    const struct csg_carriers *old = change->before->scene->carriers;
    const struct csg_shape *now = &change->scene->leaves[rank->leaf].shape;
    const struct csg_shape *shape = csg_shape_before(change, rank->leaf);
    if (!change->wanted[rank->leaf] || !change->builder->wanted[rank->leaf] || now->surface ||
        shape->surface || rank->face >= now->num_planes || rank->face >= shape->num_planes)
        return false;
    const struct csg_rank own = csg_carrier_rank(change->builder, rank->leaf, rank->face);
    const uint32_t carrier = old->faces[old->face_begin[rank->leaf] + rank->face].carrier;
    return csg_rank_compare(csg_rank_of(change, CSG_PLANE, carrier), &own) == 0 &&
           now->rounding == shape->rounding &&
           memcmp(&now->planes[rank->face], &shape->planes[rank->face], sizeof *now->planes) == 0;
}

/* Its carrier is found anew after all where there is one before. */
static bool keep_plane(struct csg_carrier_change *change, const struct csg_rank *rank)
{
    const struct csg_carriers *old = change->before->scene->carriers;
    struct csg_carriers *carriers = change->carriers;
    const struct csg_face face = old->faces[old->face_begin[rank->leaf] + rank->face];
    const struct csg_leaf_extent extent = csg_carrier_extent(change->builder, rank);
    const struct csg_plane plane = csg_plane_of(change, rank);
    struct csg_face found;
    carriers->faces[carriers->face_begin[rank->leaf] + rank->face] = face;
    return !csg_carrier_find_plane(change->builder, &plane, &extent, rank, &found) ||
           csg_carrier_affect(change, CSG_PLANE, face.carrier);
}

static bool take_out(struct csg_carrier_change *change, uint32_t leaf)
{
    const struct csg_carriers *old = change->before->scene->carriers;
    const uint32_t begin = old->face_begin[leaf], num = old->face_begin[leaf + 1] - begin;
    struct csg_rank rank = {.leaf = leaf};
    for (; rank.face < num; rank.face++) {
        const uint32_t face = csg_carrier_face(change->builder, &rank);
        if (old->faces[begin + face].carrier != CSG_NO_CARRIER && !stays(change, &rank) &&
            !take_out_plane(change, &rank))
            return false;
    }
    const struct csg_face *quadric = &old->quadric_faces[leaf];
    return quadric->carrier == CSG_NO_CARRIER || leave(change, CSG_QUADRIC, leaf, quadric);
}

/* A face on a plane that is there gets its carrier: that of the first face on it, which may be the
 * one that comes. */
static bool enter_plane(struct csg_carrier_change *change, const struct csg_rank *rank)
{
    const struct csg_plane plane = csg_plane_of(change, rank);
    struct csg_face there;
    if (!csg_carrier_find_met(change->builder, &plane, &there))
        return true;
    const bool is_first = csg_rank_compare(csg_rank_of(change, CSG_PLANE, there.carrier), rank) > 0;
    return !(is_first || there.is_other) || csg_carrier_affect(change, CSG_PLANE, there.carrier);
}

static bool put_in_plane(struct csg_carrier_change *change, const struct csg_rank *rank)
{
    const struct csg_carrier_item item = {.rank = *rank};
    return csg_array_push(&change->work[CSG_PLANE].items, item) && enter_plane(change, rank);
}

static bool put_in(struct csg_carrier_change *change, uint32_t leaf)
{
    const struct csg_shape *shape = &change->scene->leaves[leaf].shape;
    const uint8_t *near = shape->surface ? change->builder->remote.near[leaf] : NULL;
    struct csg_carrier_item item = {.rank = csg_carrier_rank(change->builder, leaf, 0)};
    struct csg_rank *rank = &item.rank;
    if (shape->has_quadric && !csg_array_push(&change->work[CSG_QUADRIC].items, item))
        return false;
    for (; rank->face < csg_num_ranks(change->builder, leaf); rank->face++)
        if ((!near || near[csg_carrier_face(change->builder, rank)]) &&
            !(stays(change, rank) ? keep_plane(change, rank) : put_in_plane(change, rank)))
            return false;
    return true;
}

static bool go(struct csg_carrier_change *change, uint32_t leaf)
{
    return !csg_is_touched(change, leaf) || !change->builder->wanted[leaf] ||
           take_out(change, leaf);
}

static bool come(struct csg_carrier_change *change, uint32_t leaf)
{
    return !csg_is_touched(change, leaf) || !change->wanted[leaf] || put_in(change, leaf);
}

/* Faces of a surface that has not changed which are not near any more. */
static bool go_away(struct csg_carrier_change *change, const struct csg_met_surface *met)
{
    const struct csg_carriers *old = change->before->scene->carriers;
    struct csg_carriers *carriers = change->carriers;
    const uint32_t begin = old->face_begin[met->leaf];
    const uint32_t num = old->face_begin[met->leaf + 1] - begin;
    struct csg_rank rank = {.leaf = met->leaf};
    carriers->renewed[met->leaf] = true;
    for (; rank.face < num; rank.face++) {
        const uint32_t face = csg_carrier_face(change->builder, &rank);
        if (old->faces[begin + face].carrier == CSG_NO_CARRIER || (met->near && met->near[face]))
            continue;
        if (!take_out_plane(change, &rank))
            return false;
        if (carriers->face_begin[met->leaf] < carriers->face_begin[met->leaf + 1])
            carriers->faces[carriers->face_begin[met->leaf] + face].carrier = CSG_NO_CARRIER;
    }
    return true;
}

/* And those that are now. */
static bool come_near(struct csg_carrier_change *change, const struct csg_met_surface *met)
{
    const struct csg_carriers *carriers = change->carriers;
    const struct csg_face *faces = &carriers->faces[carriers->face_begin[met->leaf]];
    struct csg_rank rank = csg_carrier_rank(change->builder, met->leaf, 0);
    for (; rank.face < csg_num_ranks(change->builder, met->leaf); rank.face++) {
        const uint32_t face = csg_carrier_face(change->builder, &rank);
        if (met->near[face] && faces[face].carrier == CSG_NO_CARRIER &&
            !put_in_plane(change, &rank))
            return false;
    }
    return true;
}

bool csg_carrier_exchange(struct csg_carrier_change *change)
{
    const struct csg_before *before = change->before;
    const bool same = change->is_same;
    const size_t num = same ? before->num : change->scene->num_leaves;
    bool ok = true; /* all go before the first one comes */
    for (uint32_t i = 0; i < num && ok; i++)
        ok = go(change, same ? before->leaves[i] : i);
    for (size_t i = 0; i < change->met.num && ok; i++)
        ok = csg_is_touched(change, change->met.data[i].leaf) ||
             go_away(change, &change->met.data[i]);
    csg_carrier_put_placed(change);
    for (uint32_t i = 0; i < num && ok; i++)
        ok = come(change, same ? before->leaves[i] : i);
    for (size_t i = 0; i < change->met.num && ok; i++)
        ok = csg_is_touched(change, change->met.data[i].leaf) ||
             come_near(change, &change->met.data[i]);
    return ok;
}
