/* SPDX-License-Identifier: MIT */
#include "prepare/operand.h"

#include <stdlib.h>

void csg_operand_finish(struct csg_operand *operand)
{
    free(operand->whole.data);
    free(operand->pruned.data);
    free(operand->boxes.data);
}

bool csg_operand_take(struct csg_operand *operand, const struct csgcast_scene *scene,
                      const struct csg_tree *tree, uint32_t begin)
{
    const uint32_t end = tree->data[begin].end;
    operand->whole.num = operand->pruned.num = 0;
    return csg_tree_append(&operand->whole, tree->data, begin, end) &&
           csg_tree_append(&operand->pruned, tree->data, begin, end) &&
           csg_tree_prune(scene, &operand->pruned);
}

static bool is_kept(const struct csg_operand *operand, const struct csgcast_scene *scene)
{
    const struct csg_tree *whole = &operand->whole;
    return csg_nodes_may_stay(scene, whole->data, 0, (uint32_t)whole->num);
}

uint32_t csg_operand_leaf(const struct csg_operand *operand, const struct csgcast_scene *scene)
{
    const struct csg_tree *tree = is_kept(operand, scene) ? &operand->whole : &operand->pruned;
    for (size_t i = 0; i < tree->num; i++)
        if (tree->data[i].op == CSG_LEAF)
            return tree->data[i].leaf;
    return UINT32_MAX;
}

static bool has_leaf(const struct csg_tree *tree, uint32_t leaf)
{
    for (size_t i = 0; i < tree->num; i++)
        if (tree->data[i].op == CSG_LEAF && tree->data[i].leaf == leaf)
            return true;
    return false;
}

bool csg_operand_is_object(const struct csg_operand *operand, const struct csgcast_scene *scene,
                           const struct csg_object *object)
{
    const bool kept = is_kept(operand, scene);
    const struct csg_tree *tree = kept ? &operand->whole : &operand->pruned;
    const struct csg_node *nodes = scene->trees[object->layer].data + object->begin;
    const struct csg_tree *pruned = &operand->pruned;
    const bool is_everything = pruned->num == 1 && pruned->data[0].op != CSG_LEAF;
    if (object->end - object->begin != tree->num || is_everything)
        return false;
    for (size_t i = 0; i < tree->num; i++)
        if (!csg_node_is_same(&tree->data[i], 0, &nodes[i], object->begin) ||
            (nodes[i].op == CSG_LEAF && kept &&
             nodes[i].spare == has_leaf(&operand->pruned, nodes[i].leaf)))
            return false;
    return true;
}
