/* SPDX-License-Identifier: MIT */

/* Leaves of an edit that go and come, and the carriers which that concerns. */

#include "csg/carrier_change.h"

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

static const struct csg_shape *shape_before(const struct csg_carrier_change *change, uint32_t leaf)
{
    const uint32_t place = change->before->changed[leaf];
    return place ? change->before->shapes[place - 1] : &change->scene->leaves[leaf].shape;
}

static bool take_out(struct csg_carrier_change *change, uint32_t leaf)
{
    const struct csg_carriers *old = change->before->scene->carriers;
    const uint32_t begin = old->face_begin[leaf], end = old->face_begin[leaf + 1];
    const struct csg_shape *shape = shape_before(change, leaf);
    for (uint32_t i = begin; i < end; i++) {
        if (old->faces[i].is_other)
            csg_plane_table_remove(&change->builder->others, &shape->planes[i - begin]);
        if (!leave(change, CSG_PLANE, leaf, &old->faces[i]))
            return false;
    }
    const struct csg_face *quadric = &old->quadric_faces[leaf];
    return quadric->carrier == CSG_NO_CARRIER || leave(change, CSG_QUADRIC, leaf, quadric);
}

/* A face on a plane that is there gets its carrier: that of the first face on it, which may be the
 * one that comes. */
static bool enter_plane(struct csg_carrier_change *change, const struct csg_rank *rank)
{
    struct csg_face there;
    if (!csg_carrier_find_met(change->builder, csg_plane_of(change, rank), &there))
        return true;
    const bool is_first = csg_rank_compare(csg_rank_of(change, CSG_PLANE, there.carrier), rank) > 0;
    return !(is_first || there.is_other) || csg_carrier_affect(change, CSG_PLANE, there.carrier);
}

static bool put_in(struct csg_carrier_change *change, uint32_t leaf)
{
    const struct csg_shape *shape = &change->scene->leaves[leaf].shape;
    struct csg_carrier_item item = {.rank = csg_carrier_rank(change->builder, leaf, 0)};
    if (shape->has_quadric && !csg_array_push(&change->work[CSG_QUADRIC].items, item))
        return false;
    for (; item.rank.face < shape->num_planes; item.rank.face++)
        if (!csg_array_push(&change->work[CSG_PLANE].items, item) ||
            !enter_plane(change, &item.rank))
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

bool csg_carrier_exchange(struct csg_carrier_change *change)
{
    const struct csg_before *before = change->before;
    const bool same = before->objects != NULL;
    const size_t num = same ? before->num : change->scene->num_leaves;
    bool ok = true; /* all go before the first one comes */
    for (uint32_t i = 0; i < num && ok; i++)
        ok = go(change, same ? before->leaves[i] : i);
    for (uint32_t i = 0; i < num && ok; i++)
        ok = come(change, same ? before->leaves[i] : i);
    return ok;
}
