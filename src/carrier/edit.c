/* SPDX-License-Identifier: MIT */
#include "carrier/edit.h"

#include <stdlib.h>
#include <string.h>

#include "carrier/change.h"
#include "csg/object.h"

/* The index is made anew for scenes that have become so many times smaller than it. */
#define MOST_ROOM 16

/* Where more than this part of the leaves change, as all do in an animation, the carriers of all
 * are sooner found anew than those of the changed ones taken out of the index and put into it.
 * Surfaces of triangles do not count: most of their faces are near nothing and in no index. */
#define MAX_PART 2

static void *copy_of(const void *data, size_t num, size_t size)
{
    void *copy = malloc((num + 1) * size);
    if (copy && num)
        memcpy(copy, data, num * size);
    return copy;
}

/* Of objects that are the same: leaves neither come nor go, and have as many faces. */
static bool copy_same_faces(struct csg_carrier_change *change)
{
    const struct csg_before *before = change->before;
    const struct csg_carriers *old = before->scene->carriers;
    struct csg_carriers *carriers = change->carriers;
    const size_t num = change->scene->num_leaves;
    carriers->face_begin = copy_of(old->face_begin, num + 1, sizeof *old->face_begin);
    carriers->faces = copy_of(old->faces, old->face_begin[num], sizeof *old->faces);
    carriers->quadric_faces = copy_of(old->quadric_faces, num, sizeof *old->quadric_faces);
    carriers->sheets = copy_of(old->sheets, num, sizeof *old->sheets);
    if (!carriers->face_begin || !carriers->faces || !carriers->quadric_faces || !carriers->sheets)
        return false;
    for (size_t i = 0; i < before->num; i++) {
        const uint32_t leaf = before->leaves[i];
        carriers->renewed[leaf] = true;
        carriers->quadric_faces[leaf].carrier = CSG_NO_CARRIER;
        for (uint32_t j = old->face_begin[leaf]; j < old->face_begin[leaf + 1]; j++)
            carriers->faces[j].carrier = CSG_NO_CARRIER;
    }
    return true;
}

/* Leaves that are out keep no carriers, and those that come have none yet, nor have surfaces whose
 * faces have all been remote. */
static void copy_faces(struct csg_carrier_change *change)
{
    const struct csg_carriers *old = change->before->scene->carriers;
    struct csg_carriers *carriers = change->carriers;
    for (uint32_t i = 0; i < change->scene->num_leaves; i++) {
        struct csg_face *faces = &carriers->faces[carriers->face_begin[i]];
        const uint32_t num = carriers->face_begin[i + 1] - carriers->face_begin[i];
        carriers->renewed[i] = csg_is_touched(change, i);
        if (!change->wanted[i])
            continue;
        if (carriers->renewed[i] || old->face_begin[i + 1] - old->face_begin[i] != num)
            for (uint32_t j = 0; j < num; j++)
                faces[j].carrier = CSG_NO_CARRIER;
        else
            memcpy(faces, &old->faces[old->face_begin[i]], num * sizeof *faces);
        if (carriers->renewed[i])
            continue;
        carriers->quadric_faces[i] = old->quadric_faces[i];
        carriers->sheets[i] = old->sheets[i];
    }
}

static bool start_work(struct csg_carrier_work *work, size_t num_carriers)
{
    work->num_marks = num_carriers;
    work->marks = calloc(num_carriers + 1, 1);
    work->suspected = calloc(num_carriers + 1, sizeof *work->suspected);
    return work->marks && work->suspected;
}

/* The carriers are those of before, for now. */
static bool copy_carriers(struct csg_carrier_change *change)
{
    const struct csg_carriers *old = change->before->scene->carriers;
    struct csg_carriers *carriers = change->carriers;
    carriers->planes = copy_of(old->planes, old->num_planes, sizeof *old->planes);
    carriers->quadric_leaves =
        copy_of(old->quadric_leaves, old->num_quadrics, sizeof *old->quadric_leaves);
    carriers->num_planes = carriers->planes_capacity = old->num_planes;
    carriers->num_quadrics = carriers->quadric_leaves_capacity = old->num_quadrics;
    carriers->renewed = calloc(change->scene->num_leaves + 1, sizeof *carriers->renewed);
    return carriers->planes && carriers->quadric_leaves && carriers->renewed &&
           start_work(&change->work[CSG_PLANE], old->num_planes) &&
           start_work(&change->work[CSG_QUADRIC], old->num_quadrics);
}

static void count_own(const struct csg_carrier_change *change)
{
    change->carriers->num_own = 0;
    for (uint32_t i = 0; change->builder->placed && i < change->scene->num_leaves; i++)
        if (change->wanted[i] && change->scene->leaves[i].shape.surface)
            csg_carrier_count_own(change->builder, i);
}

static void count(const struct csg_carrier_change *change)
{
    const struct csg_carrier_builder *builder = change->builder;
    struct csg_carriers *carriers = change->carriers;
    size_t num_faces = 0;
    for (int kind = 0; kind < CSG_NUM_FACE_KINDS; kind++)
        for (size_t i = 0; i < builder->lists[kind].uses.num; i++)
            num_faces += builder->lists[kind].uses.data[i];
    carriers->num_unused_planes = builder->lists[CSG_PLANE].free.num;
    carriers->num_unused_quadrics = builder->lists[CSG_QUADRIC].free.num;
    carriers->num_shared = num_faces + carriers->num_unused_planes + carriers->num_unused_quadrics -
                           carriers->num_planes - carriers->num_quadrics;
    count_own(change);
}

/* Whether no leaf but those that changed has other carriers, and none shares a quadric that one of
 * those has left. */
static bool are_alone(const struct csg_carrier_change *change)
{
    const struct csg_before *before = change->before;
    const struct csg_carriers *old = before->scene->carriers, *carriers = change->carriers;
    size_t num = 0;
    for (size_t i = 0; i < change->scene->num_leaves; i++)
        num += carriers->renewed[i];
    for (size_t i = 0; i < before->num && num == before->num; i++) {
        const uint32_t left = old->quadric_faces[before->leaves[i]].carrier;
        if (left != CSG_NO_CARRIER && left != carriers->quadric_faces[before->leaves[i]].carrier &&
            change->builder->lists[CSG_QUADRIC].uses.data[left] > 0)
            return false;
    }
    return num == before->num;
}

/* Whether quadrics needed no boxes, as all of each that can be seen is the leaf it came from, and
 * still need none. */
static bool need_no_boxes(const struct csg_carrier_change *change)
{
    const struct csg_before *before = change->before;
    const struct csg_carriers *carriers = change->carriers;
    if (before->scene->carriers->quadric_boxes || !before->box || !are_alone(change))
        return false;
    for (size_t i = 0; i < before->num; i++) {
        const uint32_t carrier = carriers->quadric_faces[before->leaves[i]].carrier;
        if (carrier != CSG_NO_CARRIER && carriers->quadric_leaves[carrier] != before->leaves[i])
            return false;
    }
    return true;
}

/* Whether surfaces have places for faces that have come near. */
static bool have_same_faces(const struct csg_carrier_change *change)
{
    const struct csg_carriers *old = change->before->scene->carriers;
    for (size_t i = 0; i < change->met.num; i++) {
        const struct csg_met_surface *met = &change->met.data[i];
        if (met->near && old->face_begin[met->leaf] == old->face_begin[met->leaf + 1])
            return false;
    }
    return true;
}

static bool follow(struct csg_carrier_change *change)
{
    struct csg_carrier_builder *builder = change->builder;
    builder->scene = change->scene;
    builder->carriers = change->carriers;
    const bool same = change->is_same = change->is_same && have_same_faces(change);
    csg_carrier_put_near(change);
    if (!copy_carriers(change) ||
        !(same ? copy_same_faces(change) : csg_carriers_allocate_faces(builder)))
        return false;
    if (!same)
        copy_faces(change);
    if (!csg_carrier_exchange(change) || !csg_carrier_settle(change, CSG_PLANE) ||
        !csg_carrier_settle(change, CSG_QUADRIC))
        return false;
    count(change);
    return need_no_boxes(change) || csg_carriers_fill_boxes(change->scene, change->carriers);
}

static bool is_speck(const struct csg_carrier_change *change, const struct csg_box *all)
{
    return !(csg_length(csg_sub(all->hi, all->lo)) * MOST_ROOM > change->builder->radius);
}

/* The same of objects that are the same, whose box is within that of their leaves. */
static bool has_same_room(struct csg_carrier_change *change)
{
    struct csg_carrier_builder *builder = change->builder;
    const struct csg_before *before = change->before;
    if (!change->is_same || !csg_box_is_finite(before->box) || is_speck(change, before->box))
        return false;
    builder->scene = change->scene;
    for (size_t i = 0; i < before->num; i++) {
        const uint32_t leaf = before->leaves[i];
        if (change->wanted[leaf] && !csg_carrier_has_room(builder, leaf))
            return false;
        if (change->wanted[leaf])
            builder->largest_rounding =
                fmax(builder->largest_rounding, change->scene->leaves[leaf].shape.rounding);
    }
    return true;
}

/* Whether all that comes has room in the index, and the rest is no speck in it. */
static bool has_room(struct csg_carrier_change *change)
{
    struct csg_carrier_builder *builder = change->builder;
    struct csg_box all = csg_box_empty;
    size_t num = 0;
    builder->scene = change->scene;
    for (uint32_t i = 0; i < change->scene->num_leaves; i++) {
        if (!change->wanted[i])
            continue;
        const struct csg_box box = change->scene->leaves[i].box;
        all = csg_box_union(&all, &box);
        num++;
        if (csg_is_touched(change, i) && !csg_carrier_has_room(builder, i))
            return false;
        builder->largest_rounding =
            fmax(builder->largest_rounding, change->scene->leaves[i].shape.rounding);
    }
    return num > 1 && !is_speck(change, &all);
}

static void finish(struct csg_carrier_change *change)
{
    for (int kind = 0; kind < CSG_NUM_FACE_KINDS; kind++) {
        free(change->work[kind].items.data);
        free(change->work[kind].affected.data);
        free(change->work[kind].created.data);
        free(change->work[kind].suspects.data);
        free(change->work[kind].suspected);
        free(change->work[kind].marks);
    }
    for (size_t i = 0; i < change->met.num; i++) {
        if (!change->is_near_put)
            free(change->met.data[i].near);
        csg_placed_faces_destroy(change->met.data[i].placed);
    }
    free(change->met.data);
    free(change->wanted);
}

/* NULL: memory is out, and nothing is kept any more. */
static struct csg_carriers *make(struct csg_carrier_change *change)
{
    struct csg_carriers *carriers = change->carriers = calloc(1, sizeof *carriers);
    const bool ok = carriers && follow(change);
    change->before->scene->carriers->kept = NULL;
    if (carriers)
        carriers->kept = change->builder;
    else
        csg_carrier_builder_destroy(change->builder);
    if (ok) {
        free(change->builder->wanted);
        change->builder->wanted = change->wanted;
        change->wanted = NULL;
        return carriers;
    }
    csg_carriers_destroy(carriers);
    return NULL;
}

static bool are_most(const struct csgcast_scene *scene, const struct csg_before *before)
{
    size_t num = 0;
    for (size_t i = 0; i < before->num; i++)
        num += !scene->leaves[before->leaves[i]].shape.surface;
    return num > scene->num_leaves / MAX_PART;
}

/* Of objects that are the same as well everything would be made anew with the carriers, these
 * included. */
static struct csg_carriers *create(const struct csg_carrier_change *change, bool keeps)
{
    return change->before->box ? NULL : csg_carriers_create(change->scene, keeps);
}

struct csg_carriers *csg_carriers_edit(const struct csgcast_scene *scene,
                                       const struct csg_before *before)
{
    struct csg_carrier_change change = {.scene = scene,
                                        .before = before,
                                        .builder = before->scene->carriers->kept,
                                        .is_same = before->box != NULL};
    if (are_most(scene, before))
        return create(&change, false);
    if (!change.builder)
        return create(&change, true);
    change.wanted = calloc(scene->num_leaves + 1, sizeof *change.wanted);
    if (!change.wanted)
        return NULL;
    if (change.is_same)
        memcpy(change.wanted, change.builder->wanted, scene->num_leaves * sizeof *change.wanted);
    else
        csg_carrier_mark_wanted(scene, change.wanted);
    struct csg_carriers *carriers = NULL;
    if (csg_carrier_meet_surfaces(&change))
        carriers =
            (has_same_room(&change) || has_room(&change)) && csg_carrier_has_room_for_met(&change)
                ? make(&change)
                : create(&change, true);
    finish(&change);
    return carriers;
}
