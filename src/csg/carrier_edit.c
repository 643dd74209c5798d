/* SPDX-License-Identifier: MIT */
#include "csg/carrier_edit.h"

#include <stdlib.h>
#include <string.h>

#include "csg/carrier_builder.h"
#include "csg/object.h"

/* The index is made anew for scenes that have become so many times smaller than it. */
#define MOST_ROOM 16

/* Of planes and of quadrics. */
enum { PLANE, QUADRIC, NUM_KINDS };

/* A face that gets its carrier anew. */
struct item {
    struct csg_rank rank; /* of a quadric: face 0 */
    bool was_first;       /* before the edit a carrier came from it, which has not changed */
};

struct items {
    struct item *data;
    size_t num, capacity;
};

struct numbers {
    uint32_t *data;
    size_t num, capacity;
};

struct edit {
    struct csg_carrier_builder *builder;
    const struct csgcast_scene *scene;
    struct csg_carriers *carriers;
    const struct csg_before *before;
    bool *wanted; /* by leaf, after the edit */
    struct items items[NUM_KINDS];
    struct numbers affected[NUM_KINDS]; /* carriers whose faces are still to become items */
    struct numbers created[NUM_KINDS];  /* by the pass at hand */
    uint8_t *marks[NUM_KINDS];          /* by carrier: it is affected */
    size_t num_marks[NUM_KINDS];
};

/* ---- by kind ------------------------------------------------------------------------------ */

static const struct csg_rank *rank_of(const struct edit *edit, int kind, uint32_t carrier)
{
    return kind == PLANE ? &edit->builder->plane_ranks.data[carrier]
                         : &edit->builder->quadric_ranks.data[carrier];
}

static uint32_t *uses_of(struct edit *edit, int kind, uint32_t carrier)
{
    return kind == PLANE ? &edit->builder->plane_uses.data[carrier]
                         : &edit->builder->quadric_uses.data[carrier];
}

static struct csg_face *face_of(struct edit *edit, int kind, const struct csg_rank *rank)
{
    struct csg_carriers *carriers = edit->carriers;
    return kind == PLANE ? &carriers->faces[carriers->face_begin[rank->leaf] + rank->face]
                         : &carriers->quadric_faces[rank->leaf];
}

static const struct csg_plane *plane_of(const struct edit *edit, const struct csg_rank *rank)
{
    return &edit->scene->leaves[rank->leaf].shape.planes[rank->face];
}

static const struct csg_quadric *quadric_of(const struct edit *edit, const struct csg_rank *rank)
{
    return &edit->scene->leaves[rank->leaf].shape.quadric;
}

/* ---- what is affected --------------------------------------------------------------------- */

static bool affect(struct edit *edit, int kind, uint32_t carrier)
{
    if (carrier >= edit->num_marks[kind] || edit->marks[kind][carrier])
        return true; /* is known to be */
    edit->marks[kind][carrier] = 1;
    return csg_array_push(&edit->affected[kind], carrier);
}

/* Faces of a carrier that comes later may lie on that of the rank. */
static bool affect_later(struct edit *edit, int kind, uint32_t carrier, const struct csg_rank *rank)
{
    return csg_rank_compare(rank_of(edit, kind, carrier), rank) <= 0 || affect(edit, kind, carrier);
}

static bool affect_near_plane(struct edit *edit, const struct csg_rank *rank)
{
    const struct csg_carrier_index *index = &edit->builder->index;
    struct csg_index_probe probe;
    csg_index_probe_parallel(index, plane_of(edit, rank), &probe);
    for (uint32_t i; (i = csg_index_next(index, &probe)) != CSG_NO_CARRIER;)
        if (!affect_later(edit, PLANE, i, rank))
            return false;
    csg_index_probe_normals(index, plane_of(edit, rank), &probe);
    for (uint32_t i; (i = csg_index_next(index, &probe)) != CSG_NO_CARRIER;)
        for (; i != CSG_NO_CARRIER; i = csg_index_next_member(index, i))
            if (!affect_later(edit, PLANE, i, rank))
                return false;
    return true;
}

static bool affect_near_quadric(struct edit *edit, const struct csg_rank *rank)
{
    const struct csg_carrier_index *index = &edit->builder->index;
    struct csg_index_probe probe;
    csg_index_probe_quadric(index, quadric_of(edit, rank), &probe);
    for (uint32_t i; (i = csg_index_next(index, &probe)) != CSG_NO_CARRIER;)
        if (!affect_later(edit, QUADRIC, i, rank))
            return false;
    return true;
}

/* The carriers whose faces may lie on that of the rank once it is one. */
static bool affect_near(struct edit *edit, int kind, const struct csg_rank *rank)
{
    return kind == PLANE ? affect_near_plane(edit, rank) : affect_near_quadric(edit, rank);
}

/* ---- leaves that go and come --------------------------------------------------------------- */

/* Where it was another's face, with the carrier's own numbers, that has an effect on no one. */
static bool leave(struct edit *edit, int kind, uint32_t leaf, const struct csg_face *face)
{
    const bool is_first = rank_of(edit, kind, face->carrier)->leaf == leaf;
    --*uses_of(edit, kind, face->carrier);
    return !(is_first || face->is_other) || affect(edit, kind, face->carrier);
}

static const struct csg_shape *shape_before(const struct edit *edit, uint32_t leaf)
{
    const uint32_t place = edit->before->changed[leaf];
    return place ? edit->before->shapes[place - 1] : &edit->scene->leaves[leaf].shape;
}

static bool take_out(struct edit *edit, uint32_t leaf)
{
    const struct csg_carriers *old = edit->before->scene->carriers;
    const uint32_t begin = old->face_begin[leaf], end = old->face_begin[leaf + 1];
    const struct csg_shape *shape = shape_before(edit, leaf);
    for (uint32_t i = begin; i < end; i++) {
        if (old->faces[i].is_other)
            csg_plane_table_remove(&edit->builder->planes, edit->carriers->planes,
                                   &shape->planes[i - begin]);
        if (!leave(edit, PLANE, leaf, &old->faces[i]))
            return false;
    }
    const struct csg_face *quadric = &old->quadric_faces[leaf];
    return quadric->carrier == CSG_NO_CARRIER || leave(edit, QUADRIC, leaf, quadric);
}

/* A face on a plane that is there gets its carrier: that of the first face on it, which may be the
 * one that comes. */
static bool enter_plane(struct edit *edit, const struct csg_rank *rank)
{
    struct csg_face there;
    if (!csg_plane_table_find(&edit->builder->planes, edit->carriers->planes, plane_of(edit, rank),
                              &there))
        return true;
    const bool is_first = csg_rank_compare(rank_of(edit, PLANE, there.carrier), rank) > 0;
    return !(is_first || there.is_other) || affect(edit, PLANE, there.carrier);
}

static bool put_in(struct edit *edit, uint32_t leaf)
{
    const struct csg_shape *shape = &edit->scene->leaves[leaf].shape;
    struct item item = {.rank = csg_carrier_rank(edit->builder, leaf, 0)};
    if (shape->has_quadric && !csg_array_push(&edit->items[QUADRIC], item))
        return false;
    for (; item.rank.face < shape->num_planes; item.rank.face++)
        if (!csg_array_push(&edit->items[PLANE], item) || !enter_plane(edit, &item.rank))
            return false;
    return true;
}

static bool is_touched(const struct edit *edit, uint32_t leaf)
{
    return edit->before->changed[leaf] || edit->wanted[leaf] != edit->builder->wanted[leaf];
}

/* All go before the first one comes. */
static bool exchange(struct edit *edit)
{
    bool ok = true;
    for (uint32_t i = 0; i < edit->scene->num_leaves && ok; i++)
        ok = !is_touched(edit, i) || !edit->builder->wanted[i] || take_out(edit, i);
    for (uint32_t i = 0; i < edit->scene->num_leaves && ok; i++)
        ok = !is_touched(edit, i) || !edit->wanted[i] || put_in(edit, i);
    return ok;
}

/* ---- faces that get their carriers anew ----------------------------------------------------- */

static bool is_on_affected(const struct edit *edit, int kind, const struct csg_face *face)
{
    return face->carrier < edit->num_marks[kind] && edit->marks[kind][face->carrier];
}

static bool take_item(struct edit *edit, int kind, const struct csg_rank *rank)
{
    struct csg_face *face = face_of(edit, kind, rank);
    const struct item item = {
        *rank, csg_rank_compare(rank_of(edit, kind, face->carrier), rank) == 0};
    if (face->is_other)
        csg_plane_table_remove(&edit->builder->planes, edit->carriers->planes,
                               plane_of(edit, rank));
    face->carrier = CSG_NO_CARRIER;
    edit->carriers->renewed[rank->leaf] = true;
    return csg_array_push(&edit->items[kind], item);
}

/* The faces of affected carriers; num: how many they are. */
static bool collect_faces(struct edit *edit, int kind, size_t num)
{
    const struct csg_carriers *carriers = edit->carriers;
    for (uint32_t leaf = 0; leaf < edit->scene->num_leaves && num > 0; leaf++) {
        if (!edit->wanted[leaf])
            continue;
        const uint32_t num_faces =
            kind == QUADRIC ? 1 : carriers->face_begin[leaf + 1] - carriers->face_begin[leaf];
        for (uint32_t face = 0; face < num_faces; face++) {
            struct csg_rank rank = {.leaf = leaf, .face = face};
            if (!is_on_affected(edit, kind, face_of(edit, kind, &rank)))
                continue;
            rank = csg_carrier_rank(edit->builder, leaf, face);
            if (!take_item(edit, kind, &rank))
                return false;
            num--;
        }
    }
    return true;
}

static bool remove_carrier(struct edit *edit, int kind, uint32_t carrier)
{
    struct csg_carrier_builder *builder = edit->builder;
    *uses_of(edit, kind, carrier) = 0;
    if (carrier < edit->num_marks[kind])
        edit->marks[kind][carrier] = 0; /* another one may get its number */
    if (kind == QUADRIC) {
        csg_index_remove_quadric(&builder->index, carrier);
        return csg_array_push(&builder->free_quadrics, carrier);
    }
    const struct csg_plane *plane = &edit->carriers->planes[carrier];
    csg_index_remove_plane(&builder->index, plane, carrier);
    csg_plane_table_remove(&builder->planes, edit->carriers->planes, plane);
    return csg_array_push(&builder->free_planes, carrier);
}

static bool collect(struct edit *edit, int kind)
{
    struct numbers *affected = &edit->affected[kind];
    size_t num = 0;
    for (size_t i = 0; i < affected->num; i++)
        num += *uses_of(edit, kind, affected->data[i]);
    bool ok = collect_faces(edit, kind, num);
    for (size_t i = 0; i < affected->num && ok; i++)
        ok = remove_carrier(edit, kind, affected->data[i]);
    affected->num = 0;
    return ok;
}

static int compare_items(const void *a, const void *b)
{
    const struct item *x = a, *y = b;
    return csg_rank_compare(&x->rank, &y->rank);
}

static bool assign(struct edit *edit, int kind, const struct item *item)
{
    const struct csg_leaf_extent extent = csg_leaf_extent_of(edit->builder, item->rank.leaf);
    struct csg_face *face = face_of(edit, kind, &item->rank);
    const bool ok = kind == PLANE
                        ? csg_carrier_assign_plane(edit->builder, plane_of(edit, &item->rank),
                                                   &extent, &item->rank, face)
                        : csg_carrier_assign_quadric(edit->builder, item->rank.leaf, &extent,
                                                     &item->rank);
    if (!ok || csg_rank_compare(rank_of(edit, kind, face->carrier), &item->rank) != 0)
        return ok;
    return csg_array_push(&edit->created[kind], face->carrier) &&
           (item->was_first || affect_near(edit, kind, &item->rank));
}

/* What a pass has done, when it turns out to concern more carriers. */
static bool undo(struct edit *edit, int kind)
{
    bool ok = true;
    for (size_t i = 0; i < edit->items[kind].num; i++) {
        const struct csg_rank *rank = &edit->items[kind].data[i].rank;
        struct csg_face *face = face_of(edit, kind, rank);
        if (face->carrier == CSG_NO_CARRIER)
            continue;
        if (face->is_other)
            csg_plane_table_remove(&edit->builder->planes, edit->carriers->planes,
                                   plane_of(edit, rank));
        --*uses_of(edit, kind, face->carrier);
        face->carrier = CSG_NO_CARRIER;
    }
    for (size_t i = 0; i < edit->created[kind].num && ok; i++)
        ok = remove_carrier(edit, kind, edit->created[kind].data[i]);
    edit->created[kind].num = 0;
    return ok;
}

/* Passes over all faces so far, until the carriers that they make concern no others. */
static bool settle(struct edit *edit, int kind)
{
    bool ok = true;
    do {
        ok = undo(edit, kind) && collect(edit, kind);
        struct items *items = &edit->items[kind];
        if (items->num > 1)
            qsort(items->data, items->num, sizeof *items->data, compare_items);
        for (size_t i = 0; i < items->num && ok; i++)
            ok = assign(edit, kind, &items->data[i]);
    } while (ok && edit->affected[kind].num > 0);
    return ok;
}

/* ---- the whole ------------------------------------------------------------------------------ */

/* Leaves that are out keep no carriers, and those that come have none yet. */
static void copy_faces(struct edit *edit)
{
    const struct csg_carriers *old = edit->before->scene->carriers;
    struct csg_carriers *carriers = edit->carriers;
    for (uint32_t i = 0; i < edit->scene->num_leaves; i++) {
        struct csg_face *faces = &carriers->faces[carriers->face_begin[i]];
        const uint32_t num = carriers->face_begin[i + 1] - carriers->face_begin[i];
        if (!is_touched(edit, i) && edit->wanted[i]) {
            memcpy(faces, &old->faces[old->face_begin[i]], num * sizeof *faces);
            carriers->quadric_faces[i] = old->quadric_faces[i];
            carriers->sheets[i] = old->sheets[i];
        }
        carriers->renewed[i] = is_touched(edit, i);
        for (uint32_t j = 0; j < num && is_touched(edit, i) && edit->wanted[i]; j++)
            faces[j].carrier = CSG_NO_CARRIER;
    }
}

static void *copy_of(const void *data, size_t num, size_t size)
{
    void *copy = malloc((num + 1) * size);
    if (copy && num)
        memcpy(copy, data, num * size);
    return copy;
}

/* The carriers are those of before, for now. */
static bool copy_carriers(struct edit *edit)
{
    const struct csg_carriers *old = edit->before->scene->carriers;
    struct csg_carriers *carriers = edit->carriers;
    carriers->planes = copy_of(old->planes, old->num_planes, sizeof *old->planes);
    carriers->quadric_leaves =
        copy_of(old->quadric_leaves, old->num_quadrics, sizeof *old->quadric_leaves);
    carriers->quadric_boxes = malloc((old->num_quadrics + 1) * sizeof *old->quadric_boxes);
    carriers->num_planes = carriers->planes_capacity = old->num_planes;
    carriers->num_quadrics = carriers->num_quadric_leaves = carriers->num_quadric_boxes =
        carriers->quadric_leaves_capacity = carriers->quadric_boxes_capacity = old->num_quadrics;
    edit->num_marks[PLANE] = old->num_planes;
    edit->num_marks[QUADRIC] = old->num_quadrics;
    edit->marks[PLANE] = calloc(old->num_planes + 1, 1);
    edit->marks[QUADRIC] = calloc(old->num_quadrics + 1, 1);
    carriers->renewed = calloc(edit->scene->num_leaves + 1, sizeof *carriers->renewed);
    return carriers->planes && carriers->quadric_leaves && carriers->quadric_boxes &&
           carriers->renewed &&
           edit->marks[PLANE] && edit->marks[QUADRIC];
}

static void count(struct edit *edit)
{
    const struct csg_carrier_builder *builder = edit->builder;
    struct csg_carriers *carriers = edit->carriers;
    size_t num_faces = 0;
    for (size_t i = 0; i < builder->plane_uses.num; i++)
        num_faces += builder->plane_uses.data[i];
    for (size_t i = 0; i < builder->quadric_uses.num; i++)
        num_faces += builder->quadric_uses.data[i];
    carriers->num_unused_planes = builder->free_planes.num;
    carriers->num_unused_quadrics = builder->free_quadrics.num;
    carriers->num_shared = num_faces + builder->free_planes.num + builder->free_quadrics.num -
                           carriers->num_planes - carriers->num_quadrics;
}

static bool follow(struct edit *edit)
{
    struct csg_carrier_builder *builder = edit->builder;
    builder->scene = edit->scene;
    builder->carriers = edit->carriers;
    if (!copy_carriers(edit) || !csg_carriers_allocate_faces(builder))
        return false;
    copy_faces(edit);
    if (!exchange(edit) || !settle(edit, PLANE) || !settle(edit, QUADRIC))
        return false;
    count(edit);
    csg_carriers_fill_boxes(edit->scene, edit->carriers);
    return true;
}

/* Whether all that comes has room in the index, and the rest is no speck in it. */
static bool has_room(struct edit *edit)
{
    struct csg_carrier_builder *builder = edit->builder;
    struct csg_box all = csg_box_empty;
    size_t num = 0;
    builder->scene = edit->scene;
    for (uint32_t i = 0; i < edit->scene->num_leaves; i++) {
        if (!edit->wanted[i])
            continue;
        const struct csg_box box = csg_leaf_box(&edit->scene->leaves[i]);
        all = csg_box_union(&all, &box);
        num++;
        if (is_touched(edit, i) && !csg_carrier_has_room(builder, i))
            return false;
        builder->largest_rounding =
            fmax(builder->largest_rounding, edit->scene->leaves[i].shape.rounding);
    }
    return num > 1 && csg_length(csg_sub(all.hi, all.lo)) * MOST_ROOM > builder->radius;
}

static void finish(struct edit *edit)
{
    for (int kind = 0; kind < NUM_KINDS; kind++) {
        free(edit->items[kind].data);
        free(edit->affected[kind].data);
        free(edit->created[kind].data);
        free(edit->marks[kind]);
    }
    free(edit->wanted);
}

/* NULL: memory is out, and nothing is kept any more. */
static struct csg_carriers *make(struct edit *edit)
{
    struct csg_carriers *carriers = edit->carriers = calloc(1, sizeof *carriers);
    const bool ok = carriers && follow(edit);
    edit->before->scene->carriers->kept = NULL;
    if (carriers)
        carriers->kept = edit->builder;
    else
        csg_carrier_builder_destroy(edit->builder);
    if (ok) {
        free(edit->builder->wanted);
        edit->builder->wanted = edit->wanted;
        edit->wanted = NULL;
        return carriers;
    }
    csg_carriers_destroy(carriers);
    return NULL;
}

struct csg_carriers *csg_carriers_edit(const struct csgcast_scene *scene,
                                       const struct csg_before *before)
{
    struct edit edit = {.scene = scene, .before = before, .builder = before->scene->carriers->kept};
    if (!edit.builder)
        return csg_carriers_create(scene, true);
    edit.wanted = calloc(scene->num_leaves + 1, sizeof *edit.wanted);
    if (!edit.wanted)
        return NULL;
    csg_carrier_mark_wanted(scene, edit.wanted);
    struct csg_carriers *carriers =
        has_room(&edit) ? make(&edit) : csg_carriers_create(scene, true);
    finish(&edit);
    return carriers;
}
