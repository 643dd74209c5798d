/* SPDX-License-Identifier: MIT */
#include "csg/gather.h"

#include <stdlib.h>

#include "csg/wholes.h"

struct gatherer {
    const struct csgcast_scene *scene;
    uint8_t layer;
    uint8_t *highlighted; /* by leaf */
    struct csg_tree to;
};

bool csg_is_same_node(const struct csgcast_scene *scene, uint32_t a, uint32_t b)
{
    const struct csg_leaf *x = &scene->leaves[a], *y = &scene->leaves[b];
    const struct csg_whole *whole = csg_find_whole(scene, a);
    return (x->line == y->line && x->column == y->column) ||
           (whole && b >= whole->begin && b < whole->end);
}

static uint32_t first_leaf(const struct csg_tree *tree, uint32_t i)
{
    while (i < tree->num && tree->data[i].op != CSG_LEAF)
        i++;
    return i < tree->num ? tree->data[i].leaf : 0;
}

static bool is_see_through(const struct gatherer *gatherer, uint32_t leaf)
{
    return gatherer->layer != CSG_LAYER_MODEL || gatherer->highlighted[leaf] ||
           csg_leaf_is_translucent(&gatherer->scene->leaves[leaf]);
}

/* Whether all leaves of a subtree are of one node with that one. */
static bool is_of_node(const struct gatherer *gatherer, const struct csg_tree *tree, uint32_t i,
                       uint32_t leaf)
{
    for (uint32_t j = i; j < tree->data[i].end; j++)
        if (tree->data[j].op == CSG_LEAF &&
            !csg_is_same_node(gatherer->scene, leaf, tree->data[j].leaf))
            return false;
    return true;
}

/* The end of the operands from i on that are one node's. */
static uint32_t end_of_run(const struct gatherer *gatherer, const struct csg_tree *tree, uint32_t i)
{
    const uint32_t leaf = first_leaf(tree, i);
    uint32_t end = tree->data[i].end;
    if (!is_see_through(gatherer, leaf) || !is_of_node(gatherer, tree, i, leaf))
        return end;
    while (end < tree->num && is_of_node(gatherer, tree, end, leaf))
        end = tree->data[end].end;
    return end;
}

static bool open_union(struct csg_tree *tree, uint32_t end)
{
    const struct csg_node node = {.op = CSG_OR, .end = end};
    return csg_array_push(tree, node);
}

/* The outermost union anew, with a union in it for each run of more than one operand. */
static bool gather(struct gatherer *gatherer, const struct csg_tree *tree)
{
    struct csg_tree *to = &gatherer->to;
    bool ok = open_union(to, 0);
    for (uint32_t i = 1, end; i < tree->num && ok; i = end) {
        end = end_of_run(gatherer, tree, i);
        const bool several = end > tree->data[i].end;
        ok = (!several || open_union(to, (uint32_t)to->num + 1 + end - i)) &&
             csg_tree_append(to, tree->data, i, end);
    }
    if (ok)
        to->data[0].end = (uint32_t)to->num;
    return ok;
}

static bool has_see_through(const struct gatherer *gatherer, const struct csg_tree *tree)
{
    for (size_t i = 0; i < tree->num; i++)
        if (tree->data[i].op == CSG_LEAF && is_see_through(gatherer, tree->data[i].leaf))
            return true;
    return false;
}

static bool gather_layer(struct gatherer *gatherer, struct csg_tree *tree)
{
    if (tree->num == 0 || tree->data[0].op != CSG_OR || !has_see_through(gatherer, tree))
        return true;
    gatherer->to = (struct csg_tree){0};
    const bool ok = gather(gatherer, tree);
    if (ok && gatherer->to.num > tree->num) {
        const struct csg_tree old = *tree;
        *tree = gatherer->to;
        gatherer->to = old;
    }
    free(gatherer->to.data);
    return ok;
}

bool csg_gather_nodes(struct csgcast_scene *scene)
{
    const struct csg_tree *highlight = &scene->trees[CSG_LAYER_HIGHLIGHT];
    struct gatherer gatherer = {.scene = scene, .highlighted = calloc(scene->num_leaves + 1, 1)};
    bool ok = gatherer.highlighted != NULL;
    for (size_t i = 0; i < highlight->num && ok; i++)
        if (highlight->data[i].op == CSG_LEAF)
            gatherer.highlighted[highlight->data[i].leaf] = 1;
    for (; gatherer.layer < CSG_NUM_LAYERS && ok; gatherer.layer++)
        ok = gather_layer(&gatherer, &scene->trees[gatherer.layer]);
    free(gatherer.highlighted);
    return ok;
}
