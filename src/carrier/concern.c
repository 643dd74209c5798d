/* SPDX-License-Identifier: MIT */

/* Which carriers a new one concerns: those that come later and have a face that may lie on it. */

#include "carrier/change.h"

/* Further carriers are affected without a look at their faces. */
enum { MAX_SUSPECTS = 1 << 16 };

static bool is_later(const struct csg_carrier_change *change, enum csg_face_kind kind,
                     uint32_t carrier, uint32_t created)
{
    return csg_rank_compare(csg_rank_of(change, kind, carrier),
                            csg_rank_of(change, kind, created)) > 0;
}

void csg_carrier_find_last(struct csg_carrier_change *change, enum csg_face_kind kind)
{
    struct csg_carrier_work *work = &change->work[kind];
    const uint32_t *uses = change->builder->lists[kind].uses.data;
    work->last = CSG_NO_CARRIER;
    for (uint32_t i = 0; i < work->num_marks; i++)
        if (uses[i] > 0 && (work->last == CSG_NO_CARRIER || is_later(change, kind, i, work->last)))
            work->last = i;
}

/* ---- those that are near ------------------------------------------------------------------- */

/* The last pair of a carrier that has one is the first that is met; cells of several widths may
 * tell of the same one. */
static bool suspect(struct csg_carrier_change *change, uint32_t carrier, uint32_t created)
{
    struct csg_carrier_work *work = &change->work[CSG_PLANE];
    if (carrier >= work->num_marks || work->marks[carrier] ||
        !is_later(change, CSG_PLANE, carrier, created))
        return true;
    const uint32_t first = work->suspected[carrier];
    if (first && work->suspects.data[first - 1].created == created)
        return true;
    if (work->suspects.num == MAX_SUSPECTS)
        return csg_carrier_affect(change, CSG_PLANE, carrier);
    const struct csg_carrier_suspect pair = {carrier, created, first};
    work->suspected[carrier] = (uint32_t)work->suspects.num + 1;
    return csg_array_push(&work->suspects, pair);
}

/* In the cells of one width. */
static bool suspect_turned(struct csg_carrier_change *change, int width, uint32_t created)
{
    const struct csg_carrier_index *index = &change->builder->index;
    struct csg_index_probe probe;
    csg_index_probe_normals(index, width, &change->carriers->planes[created], &probe);
    for (uint32_t i; (i = csg_index_next(index, &probe)) != CSG_NO_CARRIER;)
        for (; i != CSG_NO_CARRIER; i = csg_index_next_member(index, width, i))
            if (!suspect(change, i, created))
                return false;
    return true;
}

/* Which width a face looks for the plane in is known to the face only. */
static bool suspect_planes(struct csg_carrier_change *change, uint32_t created)
{
    const struct csg_carrier_index *index = &change->builder->index;
    struct csg_index_probe probe;
    csg_index_probe_parallel(index, &change->carriers->planes[created], &probe);
    for (uint32_t i; (i = csg_index_next(index, &probe)) != CSG_NO_CARRIER;)
        if (!suspect(change, i, created))
            return false;
    for (int i = 0; i < index->space.num_widths; i++)
        if (!suspect_turned(change, i, created))
            return false;
    return true;
}

static bool affect_quadrics(struct csg_carrier_change *change, uint32_t created)
{
    const struct csg_carrier_index *index = &change->builder->index;
    struct csg_index_probe probe;
    csg_index_probe_quadric(index, csg_carrier_quadric(change->scene, change->carriers, created),
                            &probe);
    for (uint32_t i; (i = csg_index_next(index, &probe)) != CSG_NO_CARRIER;)
        if (is_later(change, CSG_QUADRIC, i, created) &&
            !csg_carrier_affect(change, CSG_QUADRIC, i))
            return false;
    return true;
}

bool csg_carrier_concern(struct csg_carrier_change *change, enum csg_face_kind kind,
                         uint32_t created)
{
    const uint32_t last = change->work[kind].last;
    if (last == CSG_NO_CARRIER || !is_later(change, kind, last, created))
        return true;
    return kind == CSG_PLANE ? suspect_planes(change, created) : affect_quadrics(change, created);
}

/* ---- those of them that have a face on it -------------------------------------------------- */

static bool confirm_face(struct csg_carrier_change *change, const struct csg_rank *rank,
                         uint32_t carrier)
{
    const struct csg_carrier_work *work = &change->work[CSG_PLANE];
    const struct csg_plane plane = csg_plane_of(change, rank);
    const struct csg_leaf_extent extent = csg_carrier_extent(change->builder, rank);
    for (uint32_t i = work->suspected[carrier]; i > 0; i = work->suspects.data[i - 1].next)
        if (csg_carrier_may_take(change->builder, work->suspects.data[i - 1].created, &plane,
                                 &extent))
            return csg_carrier_affect(change, CSG_PLANE, carrier);
    return true;
}

static bool confirm_leaf(struct csg_carrier_change *change, uint32_t leaf)
{
    const struct csg_carrier_work *work = &change->work[CSG_PLANE];
    struct csg_rank rank = {.leaf = leaf};
    for (; rank.face < csg_num_ranks(change->builder, leaf); rank.face++) {
        const uint32_t carrier = csg_face_of(change, CSG_PLANE, &rank)->carrier;
        if (carrier < work->num_marks && work->suspected[carrier] && !work->marks[carrier] &&
            !confirm_face(change, &rank, carrier))
            return false;
    }
    return true;
}

bool csg_carrier_confirm(struct csg_carrier_change *change, enum csg_face_kind kind)
{
    struct csg_carrier_work *work = &change->work[kind];
    bool ok = true;
    for (uint32_t i = 0; i < change->scene->num_leaves && work->suspects.num > 0 && ok; i++)
        ok = !change->wanted[i] || confirm_leaf(change, i);
    for (size_t i = 0; i < work->suspects.num; i++)
        work->suspected[work->suspects.data[i].carrier] = 0;
    work->suspects.num = 0;
    return ok;
}
