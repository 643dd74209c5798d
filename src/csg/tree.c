/* SPDX-License-Identifier: MIT */
#include "csg/tree.h"

#include <stdlib.h>
#include <string.h>

static struct csg_fold fold_leaf(const struct csg_node *node, const uint8_t *known)
{
    const uint8_t leaf = known && !node->spare ? known[node->leaf] : CSG_VARIES;
    if (leaf == CSG_VARIES)
        return (struct csg_fold){CSG_VARIES, false};
    const bool empty = (leaf == CSG_NOTHING) != node->negated;
    return (struct csg_fold){empty ? CSG_NOTHING : CSG_EVERYTHING, false};
}

/* The neutral constant disappears from a node, the absorbing one decides it. */
static struct csg_fold fold_node(const struct csg_tree *tree, const struct csg_fold *folds,
                                 uint32_t i)
{
    const struct csg_node *node = &tree->data[i];
    const uint8_t neutral = node->op == CSG_OR ? CSG_NOTHING : CSG_EVERYTHING;
    uint32_t num_varying = 0;
    for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end) {
        if (folds[child].constant == CSG_VARIES)
            num_varying++;
        else if (folds[child].constant != neutral)
            return (struct csg_fold){folds[child].constant, false};
    }
    return (struct csg_fold){num_varying ? CSG_VARIES : neutral, num_varying == 1};
}

static void close_nodes(struct csg_tree_room *out, uint32_t old_index)
{
    while (out->open.num && out->open.data[out->open.num - 1].old_end <= old_index)
        out->tree.data[out->open.data[--out->open.num].index].end = (uint32_t)out->tree.num;
}

static bool is_transparent(const struct csg_tree_room *out, const struct csg_node *node,
                           bool single)
{
    if (node->op == CSG_LEAF)
        return false;
    if (single)
        return true;
    return out->open.num && out->tree.data[out->open.data[out->open.num - 1].index].op == node->op;
}

static bool emit(struct csg_tree_room *out, const struct csg_node *node)
{
    const uint32_t index = (uint32_t)out->tree.num;
    struct csg_node copy = *node;
    copy.end = index + 1;
    if (!csg_array_push(&out->tree, copy))
        return false;
    return node->op == CSG_LEAF ||
           csg_array_push(&out->open, ((struct csg_open_node){index, node->end}));
}

static bool emit_all(struct csg_tree_room *out, const struct csg_tree *tree,
                     const struct csg_fold *folds)
{
    for (uint32_t i = 0; i < tree->num;) {
        const struct csg_node *node = &tree->data[i];
        close_nodes(out, i);
        if (folds[i].constant != CSG_VARIES) {
            i = node->end;
            continue;
        }
        if (!is_transparent(out, node, folds[i].single) && !emit(out, node))
            return false;
        i++;
    }
    close_nodes(out, (uint32_t)tree->num);
    return true;
}

/* All space is the one constant that needs a node: AND without children. */
static bool emit_constant(struct csg_tree_room *out, uint8_t constant)
{
    const struct csg_node everything = {.op = CSG_AND, .end = 1};
    return constant == CSG_NOTHING || csg_array_push(&out->tree, everything);
}

bool csg_tree_simplify_to(struct csg_tree_room *room, const struct csg_tree *tree,
                          const uint8_t *known)
{
    room->folds.num = room->open.num = room->tree.num = 0;
    if (tree->num == 0)
        return true;
    if (!csg_array_reserve(&room->folds, tree->num) || !csg_array_reserve(&room->tree, tree->num))
        return false;
    struct csg_fold *folds = room->folds.data;
    for (size_t i = tree->num; i-- > 0;)
        folds[i] = tree->data[i].op == CSG_LEAF ? fold_leaf(&tree->data[i], known)
                                                : fold_node(tree, folds, (uint32_t)i);
    return folds[0].constant == CSG_VARIES ? emit_all(room, tree, folds)
                                           : emit_constant(room, folds[0].constant);
}

bool csg_tree_simplify_in(struct csg_tree_room *room, struct csg_tree *tree, const uint8_t *known)
{
    if (!csg_tree_simplify_to(room, tree, known))
        return false;
    const struct csg_tree old = *tree;
    *tree = room->tree;
    room->tree = old;
    return true;
}

void csg_tree_room_finish(struct csg_tree_room *room)
{
    free(room->folds.data);
    free(room->open.data);
    free(room->tree.data);
}

bool csg_tree_simplify(struct csg_tree *tree, const uint8_t *known)
{
    struct csg_tree_room room = {0};
    const bool ok = csg_tree_simplify_in(&room, tree, known);
    csg_tree_room_finish(&room);
    return ok;
}

bool csg_tree_copy(const struct csg_tree *tree, struct csg_tree *copy)
{
    if (!csg_array_reserve(copy, tree->num + 1))
        return false;
    if (tree->num)
        memcpy(copy->data, tree->data, tree->num * sizeof *tree->data);
    copy->num = tree->num;
    return true;
}

bool csg_tree_append(struct csg_tree *tree, const struct csg_node *nodes, uint32_t begin,
                     uint32_t end)
{
    const uint32_t shift = (uint32_t)tree->num - begin;
    if (!csg_array_reserve(tree, end - begin))
        return false;
    for (uint32_t i = begin; i < end; i++) {
        tree->data[tree->num] = nodes[i];
        tree->data[tree->num++].end += shift;
    }
    return true;
}

size_t csg_tree_count_leaves(const struct csg_tree *tree)
{
    size_t num = 0;
    for (size_t i = 0; i < tree->num; i++)
        num += tree->data[i].op == CSG_LEAF;
    return num;
}

size_t csg_tree_count_operands(const struct csg_tree *tree)
{
    size_t num = 0;
    for (uint32_t i = csg_tree_first_operand(tree); i < tree->num; i = tree->data[i].end)
        num++;
    return num;
}

size_t csg_tree_depth(const struct csg_tree *tree, bool *out_of_memory)
{
    CSG_ARRAY(uint32_t) ends = {0};
    size_t depth = 0;
    *out_of_memory = false;
    for (uint32_t i = 0; i < tree->num && !*out_of_memory; i++) {
        while (ends.num && ends.data[ends.num - 1] <= i)
            ends.num--;
        if (tree->data[i].op == CSG_LEAF)
            depth = ends.num > depth ? ends.num : depth;
        else
            *out_of_memory = !csg_array_push(&ends, tree->data[i].end);
    }
    free(ends.data);
    return depth;
}
