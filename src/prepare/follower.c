/* SPDX-License-Identifier: MIT */
#include "prepare/follower.h"

#include <stdlib.h>
#include <string.h>

#include "crowd/crowd.h"
#include "prepare/follow.h"

void csg_follower_destroy(struct csg_follower *follower)
{
    if (!follower)
        return;
    free(follower->objects);
    free(follower->operands);
    free(follower->members);
    free(follower->marks);
    csg_totals_finish(&follower->totals);
    free(follower);
}

static void find_objects(struct csg_follower *follower, const struct csgcast_scene *scene)
{
    for (uint32_t i = 0; i < scene->objects->num; i++) {
        const struct csg_object *object = &scene->objects->data[i];
        const struct csg_node *nodes = scene->trees[object->layer].data;
        for (uint32_t j = object->begin; j < object->end; j++)
            if (nodes[j].op == CSG_LEAF)
                follower->objects[nodes[j].leaf] = i;
    }
}

static void find_operands(struct csg_follower *follower, const struct csg_tree *tree)
{
    for (uint32_t i = csg_tree_first_operand(tree); i < tree->num; i = tree->data[i].end)
        for (uint32_t j = i; j < tree->data[i].end; j++)
            if (tree->data[j].op == CSG_LEAF) {
                uint32_t *operand = &follower->operands[tree->data[j].leaf];
                follower->can &= *operand == CSG_NOWHERE || *operand == i;
                *operand = i;
            }
}

/* What % and # draw is in two layers. */
static void leave_out(struct csg_follower *follower, const struct csg_tree *trees)
{
    for (int layer = CSG_LAYER_MODEL + 1; layer < CSG_NUM_LAYERS; layer++)
        for (size_t i = 0; i < trees[layer].num; i++)
            if (trees[layer].data[i].op == CSG_LEAF)
                follower->operands[trees[layer].data[i].leaf] = CSG_NOWHERE;
}

static bool fill(struct csg_follower *follower, const struct csgcast_scene *scene,
                 const struct csg_before *before)
{
    const size_t num = scene->num_leaves;
    follower->can = !scene->is_distributed; /* its parts depend on all of the object */
    if (!follower->can)
        return true;
    follower->objects = malloc((num + 1) * sizeof *follower->objects);
    follower->operands = malloc((num + 1) * sizeof *follower->operands);
    follower->members = malloc((scene->objects->num + 1) * sizeof *follower->members);
    follower->marks = calloc(scene->objects->num + 1, 1);
    if (!follower->objects || !follower->operands || !follower->members || !follower->marks)
        return false;
    memset(follower->objects, 0xff, num * sizeof *follower->objects);
    memset(follower->operands, 0xff, num * sizeof *follower->operands);
    find_objects(follower, scene);
    find_operands(follower, &before->trees[CSG_LAYER_MODEL]);
    leave_out(follower, before->trees);
    csg_crowd_list_members(scene->crowd, follower->members);
    return csg_totals_init(&follower->totals, scene);
}

struct csg_follower *csg_follower_of(struct csgcast_scene *scene, const struct csg_before *before)
{
    if (scene->follower)
        return scene->follower;
    struct csg_follower *follower = calloc(1, sizeof *follower);
    if (follower && fill(follower, scene, before))
        return scene->follower = follower;
    csg_follower_destroy(follower);
    return NULL;
}
