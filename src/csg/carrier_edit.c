/* SPDX-License-Identifier: MIT */
#include "csg/carrier_edit.h"

#include <stdlib.h>
#include <string.h>

#include "csg/carrier_change.h"
#include "csg/object.h"

/* The index is made anew for scenes that have become so many times smaller than it. */
#define MOST_ROOM 16

/* Leaves that are out keep no carriers, and those that come have none yet. */
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
        if (carriers->renewed[i]) {
            for (uint32_t j = 0; j < num; j++)
                faces[j].carrier = CSG_NO_CARRIER;
            continue;
        }
        memcpy(faces, &old->faces[old->face_begin[i]], num * sizeof *faces);
        carriers->quadric_faces[i] = old->quadric_faces[i];
        carriers->sheets[i] = old->sheets[i];
    }
}

static void *copy_of(const void *data, size_t num, size_t size)
{
    void *copy = malloc((num + 1) * size);
    if (copy && num)
        memcpy(copy, data, num * size);
    return copy;
}

static bool start_work(struct csg_carrier_work *work, size_t num_carriers)
{
    work->num_marks = num_carriers;
    work->marks = calloc(num_carriers + 1, 1);
    return work->marks != NULL;
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

static void count(const struct csg_carrier_builder *builder, struct csg_carriers *carriers)
{
    size_t num_faces = 0;
    for (int kind = 0; kind < CSG_NUM_FACE_KINDS; kind++)
        for (size_t i = 0; i < builder->lists[kind].uses.num; i++)
            num_faces += builder->lists[kind].uses.data[i];
    carriers->num_unused_planes = builder->lists[CSG_PLANE].free.num;
    carriers->num_unused_quadrics = builder->lists[CSG_QUADRIC].free.num;
    carriers->num_shared = num_faces + carriers->num_unused_planes +
                           carriers->num_unused_quadrics - carriers->num_planes -
                           carriers->num_quadrics;
}

static bool follow(struct csg_carrier_change *change)
{
    struct csg_carrier_builder *builder = change->builder;
    builder->scene = change->scene;
    builder->carriers = change->carriers;
    if (!copy_carriers(change) || !csg_carriers_allocate_faces(builder))
        return false;
    copy_faces(change);
    if (!csg_carrier_exchange(change) || !csg_carrier_settle(change, CSG_PLANE) ||
        !csg_carrier_settle(change, CSG_QUADRIC))
        return false;
    count(builder, change->carriers);
    return csg_carriers_fill_boxes(change->scene, change->carriers);
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
        const struct csg_box box = csg_leaf_box(&change->scene->leaves[i]);
        all = csg_box_union(&all, &box);
        num++;
        if (csg_is_touched(change, i) && !csg_carrier_has_room(builder, i))
            return false;
        builder->largest_rounding =
            fmax(builder->largest_rounding, change->scene->leaves[i].shape.rounding);
    }
    return num > 1 && csg_length(csg_sub(all.hi, all.lo)) * MOST_ROOM > builder->radius;
}

static void finish(struct csg_carrier_change *change)
{
    for (int kind = 0; kind < CSG_NUM_FACE_KINDS; kind++) {
        free(change->work[kind].items.data);
        free(change->work[kind].affected.data);
        free(change->work[kind].created.data);
        free(change->work[kind].marks);
    }
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

struct csg_carriers *csg_carriers_edit(const struct csgcast_scene *scene,
                                       const struct csg_before *before)
{
    struct csg_carrier_change change = {
        .scene = scene, .before = before, .builder = before->scene->carriers->kept};
    if (!change.builder)
        return csg_carriers_create(scene, true);
    change.wanted = calloc(scene->num_leaves + 1, sizeof *change.wanted);
    if (!change.wanted)
        return NULL;
    csg_carrier_mark_wanted(scene, change.wanted);
    struct csg_carriers *carriers =
        has_room(&change) ? make(&change) : csg_carriers_create(scene, true);
    finish(&change);
    return carriers;
}
