/* SPDX-License-Identifier: MIT */

/* Which faces of surfaces have carriers after an edit: those that another solid comes near. */

#include <stdlib.h>
#include <string.h>

#include "carrier/change.h"
#include "carrier/nearness.h"
#include "csg/object.h"

struct boxes {
    struct csg_box *data;
    size_t num, capacity;
};

/* Where a leaf that has changed was, and is. */
static bool add_boxes(const struct csg_carrier_change *change, uint32_t leaf, struct boxes *boxes)
{
    const struct csg_shape *shape = csg_shape_before(change, leaf);
    if (!csg_is_touched(change, leaf))
        return true;
    return (!change->builder->wanted[leaf] ||
            csg_array_push(boxes, csg_box_map(&shape->frame, &shape->bounds))) &&
           (!change->wanted[leaf] || csg_array_push(boxes, change->scene->leaves[leaf].box));
}

static bool list_boxes(const struct csg_carrier_change *change, struct boxes *boxes)
{
    const struct csg_before *before = change->before;
    const size_t num = change->is_same ? before->num : change->scene->num_leaves;
    bool ok = true;
    for (uint32_t i = 0; i < num && ok; i++)
        ok = add_boxes(change, change->is_same ? before->leaves[i] : i, boxes);
    return ok;
}

static bool is_near(const struct csg_carrier_change *change, uint32_t leaf,
                    const struct boxes *boxes)
{
    const struct csg_box around =
        csg_nearness_around(change->scene, leaf, change->builder->remote.rounding);
    for (size_t i = 0; i < boxes->num; i++)
        if (csg_box_overlaps(&boxes->data[i], &around))
            return true;
    return false;
}

/* Whether a surface that has not changed has other faces that are near. */
static bool has_other_faces(const struct csg_carrier_change *change, uint32_t leaf,
                            const uint8_t *near)
{
    const uint8_t *old = change->builder->remote.near[leaf];
    const struct csg_surface *surface = change->scene->leaves[leaf].shape.surface;
    return !near != !old || (near && memcmp(near, old, surface->planes.num) != 0);
}

static bool find_near(const struct csg_carrier_change *change, uint32_t leaf, uint8_t **near)
{
    const struct csg_remote *remote = &change->builder->remote;
    const struct csg_remote_edit edit = {change->before, change->wanted, change->builder->wanted};
    return change->is_same && !csg_is_touched(change, leaf)
               ? csg_remote_follow_one(change->scene, &edit, remote->rounding, leaf,
                                       remote->near[leaf], near)
               : csg_remote_find_one(change->scene, change->wanted, remote->rounding, leaf, near);
}

static bool meet(struct csg_carrier_change *change, uint32_t leaf)
{
    const struct csg_carrier_builder *builder = change->builder;
    const struct csg_shape *shape = &change->scene->leaves[leaf].shape;
    const bool touched = csg_is_touched(change, leaf);
    struct csg_met_surface met = {.leaf = leaf};
    if (change->wanted[leaf] && shape->surface && !find_near(change, leaf, &met.near))
        return false;
    bool ok = true;
    if (touched || has_other_faces(change, leaf, met.near)) {
        const bool is_placed = !met.near || (!touched && builder->placed[leaf]);
        if (!is_placed)
            met.placed = csg_placed_faces_create(shape);
        ok = (is_placed || met.placed) && csg_array_push(&change->met, met);
        if (ok)
            return true;
    }
    free(met.near);
    csg_placed_faces_destroy(met.placed);
    return ok;
}

bool csg_carrier_meet_surfaces(struct csg_carrier_change *change)
{
    struct boxes boxes = {0};
    if (!change->builder->placed)
        return true;
    bool ok = list_boxes(change, &boxes);
    for (uint32_t i = 0; i < change->scene->num_leaves && ok; i++) {
        if (csg_is_touched(change, i)
                ? csg_shape_before(change, i)->surface || change->scene->leaves[i].shape.surface
                : change->wanted[i] && change->scene->leaves[i].shape.surface &&
                      is_near(change, i, &boxes))
            ok = meet(change, i);
    }
    free(boxes.data);
    return ok;
}

/* The builder of a scene that had no surface has no room for what is near. */
static bool has_new_surfaces(const struct csg_carrier_change *change)
{
    for (size_t i = 0; i < change->before->num; i++)
        if (change->scene->leaves[change->before->leaves[i]].shape.surface)
            return true;
    return false;
}

/* What is near depends on the largest rounding of all leaves. */
static bool has_same_rounding(const struct csg_carrier_change *change)
{
    double rounding = 0;
    for (size_t i = 0; i < change->scene->num_leaves; i++)
        if (change->wanted[i])
            rounding = fmax(rounding, change->scene->leaves[i].shape.rounding);
    return csg_remote_rounding(rounding) == change->builder->remote.rounding;
}

bool csg_carrier_has_room_for_met(const struct csg_carrier_change *change)
{
    const struct csg_carrier_builder *builder = change->builder;
    if (!builder->placed)
        return !has_new_surfaces(change);
    for (size_t i = 0; i < change->met.num; i++) {
        const struct csg_met_surface *met = &change->met.data[i];
        const struct csg_placed_faces *placed =
            met->placed ? met->placed : builder->placed[met->leaf];
        if (met->near && !csg_carrier_has_room_for_faces(builder, placed, met->near,
                                                         &change->scene->leaves[met->leaf].shape))
            return false;
    }
    return has_same_rounding(change);
}

void csg_carrier_put_near(struct csg_carrier_change *change)
{
    change->is_near_put = true;
    for (size_t i = 0; i < change->met.num; i++) {
        struct csg_met_surface *met = &change->met.data[i];
        uint8_t **near = &change->builder->remote.near[met->leaf];
        free(*near);
        *near = met->near;
    }
}

void csg_carrier_put_placed(struct csg_carrier_change *change)
{
    for (size_t i = 0; i < change->met.num; i++) {
        struct csg_met_surface *met = &change->met.data[i];
        struct csg_placed_faces **placed = &change->builder->placed[met->leaf];
        if (met->placed || !met->near) {
            csg_placed_faces_destroy(*placed);
            *placed = met->placed;
        }
        met->placed = NULL;
    }
}
