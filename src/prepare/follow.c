/* SPDX-License-Identifier: MIT */
#include "prepare/follow.h"

#include <stdlib.h>
#include <string.h>

#include "carrier/builder.h"
#include "carrier/kin.h"
#include "cells/store.h"
#include "common/order.h"
#include "crowd/crowd.h"
#include "csg/prune.h"
#include "prepare/distribute.h"
#include "prepare/follower.h"
#include "prepare/framing.h"
#include "prepare/operand.h"
#include "prepare/scene.h"
#include "sharpness/sharpness.h"

/* Of edits of more than this part of the leaves all is made anew, on all cores. */
#define MAX_PART 8

struct numbers {
    uint32_t *data;
    size_t num, capacity;
};

struct follow {
    struct csgcast_scene *scene;
    const struct csg_before *before;
    struct csg_follower *follower;
    struct numbers objects;          /* that are concerned */
    CSG_ARRAY(struct csg_box) boxes; /* of the first of them: as they were */
    struct csg_sharpness *sharp;     /* of all of them */
    struct csg_operand operand;
    struct csg_box written; /* as it was */
    bool joins; /* some object may share carriers with others that it did not share them with */
};

static bool add_object(struct follow *follow, uint32_t object)
{
    if (object == CSG_NOWHERE || follow->follower->marks[object])
        return true;
    follow->follower->marks[object] = 1;
    return csg_array_push(&follow->objects, object);
}

/* The leaf may have to be found in other objects, too. */
static bool add_object_of(struct follow *follow, size_t leaf)
{
    const struct csg_follower *follower = follow->follower;
    return (follower->objects[leaf] == CSG_NOWHERE || follower->operands[leaf] != CSG_NOWHERE) &&
           add_object(follow, follower->objects[leaf]);
}

/* ---- what has the structure that it had ---------------------------------------------------- */

/* Programs and counts do not tell them apart. */
static bool is_alike(const struct csg_shape *a, const struct csg_shape *b)
{
    return a->surface == b->surface && a->num_planes == b->num_planes &&
           a->has_quadric == b->has_quadric && a->facetted == b->facetted && a->convex == b->convex;
}

static bool are_leaves_alike(struct follow *follow)
{
    const struct csg_before *before = follow->before;
    for (size_t i = 0; i < before->num; i++) {
        struct csg_leaf *leaf = &follow->scene->leaves[before->leaves[i]];
        if (!is_alike(before->shapes[before->changed[before->leaves[i]] - 1], &leaf->shape) ||
            follow->follower->operands[before->leaves[i]] == CSG_NOWHERE)
            return false;
        csg_leaf_fill_box(leaf);
    }
    return true;
}

/* The operands of the leaves that changed, each once. */
static bool list_operands(const struct follow *follow, struct numbers *operands)
{
    size_t num = 0;
    for (size_t i = 0; i < follow->before->num; i++)
        if (!csg_array_push(operands, follow->follower->operands[follow->before->leaves[i]]))
            return false;
    qsort(operands->data, operands->num, sizeof *operands->data, csg_compare_indices);
    for (size_t i = 0; i < operands->num; i++)
        if (num == 0 || operands->data[i] != operands->data[num - 1])
            operands->data[num++] = operands->data[i];
    operands->num = num;
    return true;
}

static bool keeps_structure(struct follow *follow, uint32_t operand)
{
    struct csgcast_scene *scene = follow->scene;
    if (!csg_operand_take(&follow->operand, scene, &follow->before->trees[CSG_LAYER_MODEL],
                          operand))
        return false;
    const uint32_t leaf = csg_operand_leaf(&follow->operand, scene);
    const uint32_t index = leaf == UINT32_MAX ? CSG_NOWHERE : follow->follower->objects[leaf];
    if (index == CSG_NOWHERE)
        return false;
    struct csg_object *object = &scene->objects->data[index];
    const struct csg_box box = object->box;
    return csg_operand_is_object(&follow->operand, scene, object) &&
           !csg_distribute_may(&scene->trees[object->layer], object) && add_object(follow, index) &&
           csg_array_push(&follow->boxes, box) &&
           csg_operand_box(scene, &scene->trees[object->layer], object->begin,
                           &follow->operand.boxes, &object->box);
}

static bool keep_structure(struct follow *follow)
{
    struct numbers operands = {0};
    bool ok = are_leaves_alike(follow) && list_operands(follow, &operands);
    for (size_t i = 0; i < operands.num && ok; i++)
        ok = keeps_structure(follow, operands.data[i]);
    free(operands.data);
    return ok;
}

/* ---- carriers ------------------------------------------------------------------------------ */

/* The quadrics of the objects that are known to be concerned. */
static void mark_quadrics(const struct follow *follow, const struct csg_carriers *carriers,
                          uint8_t *marks)
{
    for (size_t i = 0; i < follow->boxes.num; i++) {
        const struct csg_object *object = &follow->scene->objects->data[follow->objects.data[i]];
        const struct csg_node *nodes = follow->scene->trees[object->layer].data;
        for (uint32_t j = object->begin; j < object->end; j++)
            if (nodes[j].op == CSG_LEAF && !nodes[j].spare &&
                carriers->quadric_faces[nodes[j].leaf].carrier != CSG_NO_CARRIER)
                marks[carriers->quadric_faces[nodes[j].leaf].carrier] = 1;
    }
}

/* The objects that share a quadric with those, or did: what can be seen of it may be another part
 * now. */
static bool add_sharers(struct follow *follow, const struct csg_carriers *old)
{
    const struct csg_carriers *carriers = follow->scene->carriers;
    const size_t num = old->num_quadrics + carriers->num_quadrics;
    uint8_t *marks = calloc(num + 1, 1);
    bool ok = marks != NULL;
    if (ok) {
        mark_quadrics(follow, old, marks);
        mark_quadrics(follow, carriers, marks);
    }
    for (size_t i = 0; i < follow->scene->num_leaves && ok; i++) {
        const uint32_t carrier = carriers->quadric_faces[i].carrier;
        if (carrier != CSG_NO_CARRIER && marks[carrier])
            ok = add_object_of(follow, i);
    }
    free(marks);
    return ok;
}

static bool add_renewed(struct follow *follow)
{
    const bool *renewed = follow->scene->carriers->renewed;
    const size_t num = follow->scene->num_leaves;
    for (size_t i = 0; i < num; i++) {
        const bool *next = memchr(renewed + i, true, num - i);
        if (!next)
            return true;
        i = (size_t)(next - renewed);
        follow->joins |= !follow->before->changed[i];
        if (!add_object_of(follow, i))
            return false;
    }
    return true;
}

/* The box of all objects as they are now. */
static struct csg_box renew_totals(struct follow *follow)
{
    csg_totals_renew(&follow->follower->totals, follow->scene, follow->objects.data,
                     follow->boxes.num);
    return csg_totals_sum(&follow->follower->totals).drawn;
}

static bool find_kin(const struct follow *follow, const struct csg_carriers *carriers, bool *found)
{
    return csg_carrier_find_kin(follow->scene, carriers, follow->before->changed,
                                follow->objects.data, follow->boxes.num, found);
}

/* The scene gets its new carriers, and old what it had. */
static bool renew_carriers(struct follow *follow, struct csg_carriers **old)
{
    struct csgcast_scene *scene = follow->scene;
    const bool had_shared = scene->carriers->num_shared > 0;
    bool had_kin, has_kin;
    if (!find_kin(follow, scene->carriers, &had_kin))
        return false;
    const struct csg_box box = renew_totals(follow);
    struct csg_before before = *follow->before;
    before.box = &box;
    struct csg_carriers *carriers = csg_carriers_edit(scene, &before);
    if (!carriers)
        return false;
    *old = scene->carriers;
    scene->carriers = carriers;
    const bool has_shared = carriers->num_shared > 0;
    if (!find_kin(follow, carriers, &has_kin))
        return false;
    follow->joins = had_kin || has_kin;
    return add_renewed(follow) && (!(had_shared || has_shared) || add_sharers(follow, *old));
}

/* ---- what follows from both ---------------------------------------------------------------- */

/* It is asked of what is left in render() nodes, which depends on carriers. */
static bool frame(struct follow *follow)
{
    follow->scene->written = csg_totals_sum(&follow->follower->totals).written;
    return csg_framing_finish(follow->scene);
}

static bool measure(struct follow *follow)
{
    follow->sharp = malloc((follow->objects.num + 1) * sizeof *follow->sharp);
    return follow->sharp && csg_sharpness_measure(follow->scene, follow->objects.data,
                                                  follow->objects.num, follow->sharp);
}

static void swap_sharpness(struct follow *follow)
{
    csg_sharpness_swap(follow->scene->sharpness, follow->objects.data, follow->objects.num,
                       follow->sharp);
}

static bool renew_crowd(struct follow *follow)
{
    struct csgcast_scene *scene = follow->scene;
    if (!follow->joins && csg_crowd_follow(scene->crowd, scene, follow->objects.data,
                                           follow->objects.num, follow->follower->members))
        return true;
    struct csg_crowd *crowd = csg_crowd_create(scene);
    if (!crowd)
        return false;
    csg_crowd_destroy(scene->crowd);
    scene->crowd = crowd;
    csg_crowd_list_members(crowd, follow->follower->members);
    return true;
}

static void renew_rest(struct follow *follow)
{
    struct csgcast_scene *scene = follow->scene;
    for (size_t i = 0; i < follow->objects.num; i++)
        csg_cells_store_renew(scene->cells, follow->objects.data[i]);
    csg_totals_put(&follow->follower->totals, scene);
    csg_scene_fill_carrier_info(scene);
}

/* ---- the whole ----------------------------------------------------------------------------- */

static bool renew(struct follow *follow)
{
    struct csgcast_scene *scene = follow->scene;
    struct csg_carriers *old = NULL;
    bool ok = renew_carriers(follow, &old) && frame(follow) && measure(follow);
    if (ok) {
        swap_sharpness(follow);
        ok = renew_crowd(follow);
        if (!ok)
            swap_sharpness(follow);
    }
    if (!ok && old) {
        struct csg_carriers *made = scene->carriers;
        scene->carriers = old;
        old = made;
    }
    csg_carriers_destroy(old);
    return ok;
}

static void finish(struct follow *follow, bool done)
{
    for (size_t i = 0; i < follow->objects.num; i++)
        follow->follower->marks[follow->objects.data[i]] = 0;
    for (size_t i = 0; i < follow->boxes.num && !done; i++)
        follow->scene->objects->data[follow->objects.data[i]].box = follow->boxes.data[i];
    if (!done)
        follow->scene->written = follow->written;
    free(follow->objects.data);
    free(follow->boxes.data);
    free(follow->sharp);
    csg_operand_finish(&follow->operand);
}

bool csg_follow(struct csgcast_scene *scene, const struct csg_before *before)
{
    if (!scene->keeps_structure || !scene->carriers->kept ||
        before->num > scene->num_leaves / MAX_PART + 1)
        return false;
    struct follow follow = {.scene = scene,
                            .before = before,
                            .follower = csg_follower_of(scene, before),
                            .written = scene->written};
    if (!follow.follower || !follow.follower->can)
        return false;
    const bool done = keep_structure(&follow) && renew(&follow);
    if (done)
        renew_rest(&follow);
    finish(&follow, done);
    if (!done) { /* its totals may be those after the edit */
        csg_follower_destroy(scene->follower);
        scene->follower = NULL;
    }
    return done;
}

void csg_follow_colors(struct csgcast_scene *scene, const uint32_t *leaves, size_t num)
{
    const struct csg_follower *follower = scene->follower;
    if (!follower || !follower->can) {
        csg_crowd_recolor(scene->crowd, scene);
        return;
    }
    for (size_t i = 0; i < num; i++) {
        const uint32_t object = follower->objects[leaves[i]];
        if (object != CSG_NOWHERE && follower->operands[leaves[i]] == CSG_NOWHERE)
            csg_crowd_recolor(scene->crowd, scene); /* it may be in other objects, too */
        else if (object != CSG_NOWHERE)
            csg_crowd_recolor_object(scene->crowd, scene, object, follower->members[object]);
    }
}
