/* SPDX-License-Identifier: MIT */
#include "csg/prune.h"

#include <stdlib.h>
#include <string.h>

#include "mesh/surface.h"

/* boxes: of the nodes from begin on. */
static struct csg_box node_box(const struct csg_tree *tree, uint32_t begin,
                               const struct csg_box *boxes, uint32_t i)
{
    const struct csg_node *node = &tree->data[i];
    struct csg_box box = node->op == CSG_OR ? csg_box_empty : csg_box_all;
    for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end)
        box = node->op == CSG_OR ? csg_box_union(&box, &boxes[child - begin])
                                 : csg_box_intersection(&box, &boxes[child - begin]);
    return box;
}

static struct csg_box literal_box(const struct csgcast_scene *scene, const struct csg_node *node)
{
    if (node->negated)
        return csg_box_all;
    return node->spare ? csg_box_empty : scene->leaves[node->leaf].box;
}

static void subtree_boxes(const struct csgcast_scene *scene, const struct csg_tree *tree,
                          uint32_t begin, uint32_t end, struct csg_box *boxes)
{
    for (uint32_t i = end; i-- > begin;) {
        const struct csg_node *node = &tree->data[i];
        boxes[i - begin] =
            node->op == CSG_LEAF ? literal_box(scene, node) : node_box(tree, begin, boxes, i);
    }
}

void csg_tree_boxes(const struct csgcast_scene *scene, const struct csg_tree *tree,
                    struct csg_box *boxes)
{
    subtree_boxes(scene, tree, 0, (uint32_t)tree->num, boxes);
}

bool csg_operand_box(const struct csgcast_scene *scene, const struct csg_tree *tree,
                     uint32_t operand, struct csg_boxes *room, struct csg_box *box)
{
    const struct csg_node *node = &tree->data[operand];
    room->num = 0;
    if (node->op == CSG_LEAF) {
        *box = literal_box(scene, node);
        return true;
    }
    if (!csg_array_reserve(room, node->end - operand))
        return false;
    subtree_boxes(scene, tree, operand, node->end, room->data);
    *box = room->data[0];
    return true;
}

/* Solids have volume: boxes that merely touch have nothing in common. */
static bool is_disjoint(const struct csg_box *a, const struct csg_box *b)
{
    const struct csg_box common = csg_box_intersection(a, b);
    return !(common.lo.x < common.hi.x && common.lo.y < common.hi.y && common.lo.z < common.hi.z);
}

/* Sheets, which are surfaces that are not closed, show even where they have no volume, as in
 * OpenSCAD's preview. */
static bool has_sheets(const struct csgcast_scene *scene, const struct csg_tree *tree)
{
    for (uint32_t i = 0; i < tree->num; i++) {
        const struct csg_node *node = &tree->data[i];
        const struct csg_surface *surface =
            node->op == CSG_LEAF ? scene->leaves[node->leaf].shape.surface : NULL;
        if (surface && surface->open && !node->negated)
            return true;
    }
    return false;
}

static bool is_relevant(const struct csg_box *box, const struct csg_box *context, bool among_sheets)
{
    return among_sheets ? csg_box_overlaps(box, context) : !is_disjoint(box, context);
}

/* What is left of a tree where boxes have spoken. */
struct pruner {
    const struct csgcast_scene *scene;
    const struct csg_tree *tree;
    bool among_sheets;
    struct csg_boxes boxes, contexts; /* of the nodes of an operand; where they matter */
    uint8_t *known;                   /* by leaf */
    size_t num_marked;
};

static void mark_leaf(struct pruner *pruner, uint32_t leaf, const struct csg_box *context)
{
    const struct csg_box box = pruner->scene->leaves[leaf].box;
    if (!is_relevant(&box, context, pruner->among_sheets))
        return;
    pruner->known[leaf] = CSG_VARIES; /* also where another copy of it is irrelevant */
    pruner->num_marked++;
}

/* Walks down an operand of the outermost union with the box in which a node matters and marks the
 * leaves that do. */
static bool mark_relevant(struct pruner *pruner, uint32_t operand)
{
    const struct csg_tree *tree = pruner->tree;
    const uint32_t end = tree->data[operand].end;
    struct csg_box box;
    if (!csg_operand_box(pruner->scene, tree, operand, &pruner->boxes, &box) ||
        !csg_array_reserve(&pruner->contexts, end - operand))
        return false;
    struct csg_box *contexts = pruner->contexts.data;
    contexts[0] = csg_box_all;
    for (uint32_t i = operand; i < end; i++) {
        const struct csg_node *node = &tree->data[i];
        if (node->op == CSG_LEAF) {
            mark_leaf(pruner, node->leaf, &contexts[i - operand]);
            continue;
        }
        const struct csg_box inside =
            csg_box_intersection(&contexts[i - operand], &pruner->boxes.data[i - operand]);
        for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end)
            contexts[child - operand] = inside;
    }
    return true;
}

static bool mark_all(struct pruner *pruner)
{
    const struct csg_tree *tree = pruner->tree;
    pruner->among_sheets = has_sheets(pruner->scene, tree);
    memset(pruner->known, CSG_NOTHING, pruner->scene->num_leaves + 1);
    for (uint32_t i = csg_tree_first_operand(tree); i < tree->num; i = tree->data[i].end)
        if (!mark_relevant(pruner, i))
            return false;
    return true;
}

bool csg_tree_prune(const struct csgcast_scene *scene, struct csg_tree *tree)
{
    if (tree->num == 0)
        return true;
    struct pruner pruner = {.scene = scene, .tree = tree, .known = malloc(scene->num_leaves + 1)};
    const bool ok =
        pruner.known && mark_all(&pruner) &&
        (pruner.num_marked == csg_tree_count_leaves(tree) || csg_tree_simplify(tree, pruner.known));
    free(pruner.known);
    free(pruner.boxes.data);
    free(pruner.contexts.data);
    return ok;
}

bool csg_nodes_are_opaque(const struct csgcast_scene *scene, const struct csg_node *nodes,
                          uint32_t begin, uint32_t end)
{
    for (uint32_t i = begin; i < end; i++)
        if (nodes[i].op == CSG_LEAF && csg_leaf_is_translucent(&scene->leaves[nodes[i].leaf]))
            return false;
    return true;
}

bool csg_nodes_may_stay(const struct csgcast_scene *scene, const struct csg_node *nodes,
                        uint32_t begin, uint32_t end)
{
    return end - begin <= CSG_KEPT_MAX_NODES && csg_nodes_are_opaque(scene, nodes, begin, end);
}

static void mark_known(const struct csg_tree *tree, uint8_t mark, uint8_t *known)
{
    for (size_t i = 0; i < tree->num; i++)
        if (tree->data[i].op == CSG_LEAF)
            known[tree->data[i].leaf] = mark;
}

static bool is_kept(const struct csgcast_scene *scene, const struct csg_tree *tree, uint32_t begin,
                    const uint8_t *highlighted)
{
    const uint32_t end = tree->data[begin].end;
    for (uint32_t i = begin; i < end; i++)
        if (tree->data[i].op == CSG_LEAF && highlighted[tree->data[i].leaf])
            return false;
    return csg_nodes_may_stay(scene, tree->data, begin, end);
}

/* One operand of the outermost union, which stays whole: what does not show becomes spare. */
static void mark_spares(struct csg_tree *tree, uint32_t begin, const uint8_t *known)
{
    for (uint32_t i = begin; i < tree->data[begin].end; i++)
        if (tree->data[i].op == CSG_LEAF)
            tree->data[i].spare = known[tree->data[i].leaf] == CSG_NOTHING;
}

bool csg_tree_keep_structure(const struct csgcast_scene *scene, struct csg_tree *tree,
                             const struct csg_tree *pruned)
{
    uint8_t *known = malloc(scene->num_leaves + 1), *highlighted = calloc(scene->num_leaves + 1, 1);
    bool ok = known && highlighted;
    if (ok) {
        memset(known, CSG_NOTHING, scene->num_leaves + 1);
        mark_known(pruned, CSG_VARIES, known);
        mark_known(&scene->trees[CSG_LAYER_HIGHLIGHT], true, highlighted);
        for (uint32_t i = csg_tree_first_operand(tree); i < tree->num; i = tree->data[i].end)
            if (is_kept(scene, tree, i, highlighted))
                mark_spares(tree, i, known);
        ok = csg_tree_simplify(tree, known);
    }
    free(known);
    free(highlighted);
    return ok;
}
