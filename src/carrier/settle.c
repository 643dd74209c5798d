/* SPDX-License-Identifier: MIT */

/* Faces of an edit that get their carriers anew. */

#include <stdlib.h>

#include "carrier/change.h"

/* ---- carriers and faces that go ------------------------------------------------------------ */

static void take_face(struct csg_carrier_change *change, const struct csg_rank *rank,
                      struct csg_face *face)
{
    if (face->is_other) {
        const struct csg_plane plane = csg_plane_of(change, rank);
        csg_plane_table_remove(&change->builder->others, &plane);
    }
    face->carrier = CSG_NO_CARRIER;
}

/* The leaf's faces on affected carriers; num counts down those that are left. */
static bool collect_leaf(struct csg_carrier_change *change, enum csg_face_kind kind, uint32_t leaf,
                         size_t *num)
{
    struct csg_carriers *carriers = change->carriers;
    struct csg_carrier_work *work = &change->work[kind];
    struct csg_rank rank = {.leaf = leaf};
    const uint32_t num_faces = kind == CSG_QUADRIC ? 1 : csg_num_ranks(change->builder, leaf);
    for (; rank.face < num_faces; rank.face++) {
        struct csg_face *face = csg_face_of(change, kind, &rank);
        if (face->carrier >= work->num_marks || !work->marks[face->carrier])
            continue;
        struct csg_carrier_item item = {csg_carrier_rank(change->builder, leaf, rank.face), false};
        item.was_first =
            csg_rank_compare(csg_rank_of(change, kind, face->carrier), &item.rank) == 0;
        take_face(change, &rank, face);
        carriers->renewed[leaf] = true;
        if (!csg_array_push(&work->items, item))
            return false;
        --*num;
    }
    return true;
}

static bool remove_carrier(struct csg_carrier_change *change, enum csg_face_kind kind,
                           uint32_t carrier)
{
    struct csg_carrier_builder *builder = change->builder;
    builder->lists[kind].uses.data[carrier] = 0;
    if (carrier < change->work[kind].num_marks)
        change->work[kind].marks[carrier] = 0; /* another one may get its number */
    if (kind == CSG_QUADRIC)
        csg_index_remove_quadric(&builder->index, carrier);
    else
        csg_index_remove_plane(&builder->index, &change->carriers->planes[carrier], carrier);
    return csg_array_push(&builder->lists[kind].free, carrier);
}

/* The faces of affected carriers become items. */
static bool collect(struct csg_carrier_change *change, enum csg_face_kind kind)
{
    struct csg_carrier_work *work = &change->work[kind];
    size_t num = 0;
    bool ok = true;
    for (size_t i = 0; i < work->affected.num; i++)
        num += change->builder->lists[kind].uses.data[work->affected.data[i]];
    for (uint32_t leaf = 0; leaf < change->scene->num_leaves && num > 0 && ok; leaf++)
        ok = !change->wanted[leaf] || collect_leaf(change, kind, leaf, &num);
    for (size_t i = 0; i < work->affected.num && ok; i++)
        ok = remove_carrier(change, kind, work->affected.data[i]);
    work->affected.num = 0;
    return ok;
}

/* What a pass has done, when it turns out to concern more carriers. */
static bool undo(struct csg_carrier_change *change, enum csg_face_kind kind)
{
    struct csg_carrier_work *work = &change->work[kind];
    bool ok = true;
    for (size_t i = 0; i < work->items.num; i++) {
        const struct csg_rank *rank = &work->items.data[i].rank;
        struct csg_face *face = csg_face_of(change, kind, rank);
        if (face->carrier == CSG_NO_CARRIER)
            continue;
        change->builder->lists[kind].uses.data[face->carrier]--;
        take_face(change, rank, face);
    }
    for (size_t i = 0; i < work->created.num && ok; i++)
        ok = remove_carrier(change, kind, work->created.data[i]);
    work->created.num = 0;
    return ok;
}

/* ---- passes ------------------------------------------------------------------------------- */

static int compare_items(const void *a, const void *b)
{
    const struct csg_carrier_item *x = a, *y = b;
    return csg_rank_compare(&x->rank, &y->rank);
}

static bool assign_plane(struct csg_carrier_builder *builder, const struct csg_rank *rank,
                         struct csg_face *face)
{
    const struct csg_leaf_extent extent = csg_carrier_extent(builder, rank);
    const struct csg_plane plane =
        csg_carrier_plane(builder, &builder->scene->leaves[rank->leaf].shape, rank);
    return csg_carrier_assign_plane(builder, &plane, &extent, rank, false, face);
}

static bool assign_quadric(struct csg_carrier_builder *builder, const struct csg_rank *rank)
{
    const struct csg_leaf_extent extent = csg_leaf_extent_of(builder, rank->leaf);
    return csg_carrier_assign_quadric(builder, rank->leaf, &extent, rank, false);
}

static bool assign(struct csg_carrier_change *change, enum csg_face_kind kind,
                   const struct csg_carrier_item *item)
{
    struct csg_carrier_builder *builder = change->builder;
    const struct csg_rank *rank = &item->rank;
    struct csg_face *face = csg_face_of(change, kind, rank);
    if (!(kind == CSG_PLANE ? assign_plane(builder, rank, face) : assign_quadric(builder, rank)))
        return false;
    if (csg_rank_compare(csg_rank_of(change, kind, face->carrier), rank) != 0)
        return true;
    if (!csg_array_push(&change->work[kind].created, face->carrier))
        return false;
    return item->was_first || csg_carrier_concern(change, kind, face->carrier);
}

/* All items so far, in their order, until the carriers that they make concern no others. */
bool csg_carrier_settle(struct csg_carrier_change *change, enum csg_face_kind kind)
{
    struct csg_carrier_work *work = &change->work[kind];
    bool ok = true;
    do {
        ok = undo(change, kind) && collect(change, kind);
        if (work->items.num > 1)
            qsort(work->items.data, work->items.num, sizeof *work->items.data, compare_items);
        csg_carrier_find_last(change, kind);
        for (size_t i = 0; i < work->items.num && ok; i++)
            ok = assign(change, kind, &work->items.data[i]);
        ok = ok && csg_carrier_confirm(change, kind);
    } while (ok && work->affected.num > 0);
    return ok;
}
