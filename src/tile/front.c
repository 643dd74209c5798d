/* SPDX-License-Identifier: MIT */
#include "tile/front.h"

struct front {
    const struct csg_terms *terms;
    const struct csg_tree *tree;
    const struct csg_leaf_range *ranges;
    double *keys; /* by node */
};

static const struct csg_leaf_range *range_of(const struct front *front, uint32_t leaf)
{
    return &front->ranges[front->terms->index[leaf]];
}

/* The first key from key on at which the leaf's literal is certainly true for all rays of the tile;
 * INFINITY: there is none. */
static double next_of_leaf(const struct csg_leaf_range *leaf, bool negated, double key)
{
    if (negated)
        return key < leaf->entry.lo || key > leaf->exit.hi || leaf->entry.lo > leaf->exit.hi
                   ? key
                   : csg_behind(leaf->exit.hi);
    const double begin = key > leaf->entry.hi ? key : csg_behind(leaf->entry.hi);
    return csg_is_solid(leaf) && begin < leaf->exit.lo ? begin : INFINITY;
}

/* Of a node; no later than that: the key itself only where it is certainly true there. */
static double next_of_node(const struct front *front, uint32_t begin, double key)
{
    const struct csg_tree *tree = front->tree;
    double *keys = front->keys;
    for (uint32_t i = tree->data[begin].end; i-- > begin;) {
        const struct csg_node *node = &tree->data[i];
        if (node->op == CSG_LEAF) {
            keys[i] = next_of_leaf(range_of(front, node->leaf), node->negated, key);
            continue;
        }
        const bool all = node->op == CSG_AND;
        keys[i] = all ? key : INFINITY;
        for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end)
            keys[i] = all ? csg_larger(keys[i], keys[child]) : csg_smaller(keys[i], keys[child]);
    }
    return keys[begin];
}

/* The same for the whole tree; operands of an intersection are asked where those before them got
 * to. */
static double next_of_tree(const struct front *front, double key, double far)
{
    const struct csg_tree *tree = front->tree;
    if (tree->data[0].op != CSG_AND)
        return next_of_node(front, 0, key);
    for (uint32_t child = 1; child < tree->num && key < far; child = tree->data[child].end) {
        const struct csg_node *node = &tree->data[child];
        key = node->op == CSG_LEAF ? next_of_leaf(range_of(front, node->leaf), node->negated, key)
                                   : next_of_node(front, child, key);
    }
    return key;
}

bool csg_front_find(const struct csg_terms *terms, const struct csg_tree *tree,
                    const struct csg_leaf_range *ranges, double *room, double *key)
{
    const struct front front = {terms, tree, ranges, room};
    double at = -(double)CSG_KEY_MAX;
    for (int i = 0; i < CSG_FRONT_JUMPS && at < *key; i++) {
        const double next = next_of_tree(&front, at, *key);
        if (next == at) {
            *key = at;
            return true;
        }
        at = next;
    }
    return false;
}
