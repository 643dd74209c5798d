/* SPDX-License-Identifier: MIT */
#include "csg/object.h"

#include <stdlib.h>
#include <string.h>

#include "csg/gather.h"
#include "mesh/surface.h"

const struct csg_leaf *csg_object_minuend(const struct csgcast_scene *scene,
                                          const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    if (object->begin < object->end && nodes[object->begin].op != CSG_LEAF &&
        nodes[object->begin].leaf)
        return &scene->leaves[nodes[object->begin].leaf - 1];
    for (uint32_t i = object->begin; i < object->end; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].negated && !nodes[i].spare)
            return &scene->leaves[nodes[i].leaf];
    return NULL;
}

bool csg_object_is_one_node(const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    uint32_t first = UINT32_MAX;
    for (uint32_t i = object->begin; i < object->end; i++) {
        if (nodes[i].op != CSG_LEAF || nodes[i].spare)
            continue;
        if (first == UINT32_MAX)
            first = nodes[i].leaf;
        else if (!csg_is_same_node(scene, first, nodes[i].leaf))
            return false;
    }
    return first != UINT32_MAX;
}

static struct csg_box node_box(const struct csg_tree *tree, const struct csg_box *boxes,
                               uint32_t i)
{
    const struct csg_node *node = &tree->data[i];
    struct csg_box box = node->op == CSG_OR ? csg_box_empty : csg_box_all;
    for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end)
        box = node->op == CSG_OR ? csg_box_union(&box, &boxes[child])
                                 : csg_box_intersection(&box, &boxes[child]);
    return box;
}

void csg_tree_boxes(const struct csgcast_scene *scene, const struct csg_tree *tree,
                    struct csg_box *boxes)
{
    for (size_t i = tree->num; i-- > 0;) {
        const struct csg_node *node = &tree->data[i];
        if (node->op != CSG_LEAF)
            boxes[i] = node_box(tree, boxes, (uint32_t)i);
        else if (node->negated)
            boxes[i] = csg_box_all;
        else
            boxes[i] = node->spare ? csg_box_empty : csg_leaf_box(&scene->leaves[node->leaf]);
    }
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

/* Walks down with the box in which a node matters and marks the leaves that do. */
static void mark_relevant(const struct csgcast_scene *scene, const struct csg_tree *tree,
                            const struct csg_box *boxes, struct csg_box *contexts, uint8_t *known)
{
    const bool among_sheets = has_sheets(scene, tree);
    contexts[0] = boxes[0];
    for (uint32_t i = 0; i < tree->num; i++) {
        const struct csg_node *node = &tree->data[i];
        if (node->op == CSG_LEAF) {
            const struct csg_box box = csg_leaf_box(&scene->leaves[node->leaf]);
            if (is_relevant(&box, &contexts[i], among_sheets))
                known[node->leaf] = CSG_VARIES; /* also where another copy of it is irrelevant */
            continue;
        }
        const struct csg_box inside = csg_box_intersection(&contexts[i], &boxes[i]);
        for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end)
            contexts[child] = inside;
    }
}

bool csg_tree_prune(const struct csgcast_scene *scene, struct csg_tree *tree)
{
    if (tree->num == 0)
        return true;
    struct csg_box *boxes = malloc(2 * tree->num * sizeof *boxes);
    uint8_t *known = malloc(scene->num_leaves + 1);
    bool ok = boxes && known;
    if (ok) {
        memset(known, CSG_NOTHING, scene->num_leaves + 1);
        csg_tree_boxes(scene, tree, boxes);
        mark_relevant(scene, tree, boxes, boxes + tree->num, known);
        ok = csg_tree_simplify(tree, known);
    }
    free(boxes);
    free(known);
    return ok;
}

/* One operand of the outermost union: kept whole, with what does not show as spares, or crowded. */
static void mark_operand(struct csg_node *nodes, uint32_t begin, uint32_t end, const uint8_t *known)
{
    const bool small = end - begin <= CSG_KEPT_MAX_NODES;
    for (uint32_t i = begin; i < end; i++)
        if (nodes[i].op == CSG_LEAF) {
            nodes[i].spare = small && known[nodes[i].leaf] == CSG_NOTHING;
            nodes[i].crowded = !small;
        }
}

bool csg_tree_keep_structure(const struct csgcast_scene *scene, struct csg_tree *tree,
                             const struct csg_tree *pruned)
{
    uint8_t *known = malloc(scene->num_leaves + 1);
    if (!known)
        return false;
    memset(known, CSG_NOTHING, scene->num_leaves + 1);
    for (size_t i = 0; i < pruned->num; i++)
        if (pruned->data[i].op == CSG_LEAF)
            known[pruned->data[i].leaf] = CSG_VARIES;
    for (uint32_t i = csg_tree_first_operand(tree); i < tree->num; i = tree->data[i].end)
        mark_operand(tree->data, i, tree->data[i].end, known);
    const bool ok = csg_tree_simplify(tree, known);
    free(known);
    return ok;
}

static bool is_crowded(const struct csg_tree *tree, uint32_t begin)
{
    for (uint32_t i = begin; i < tree->data[begin].end; i++)
        if (tree->data[i].op == CSG_LEAF)
            return tree->data[i].crowded;
    return false;
}

static bool split_layer(const struct csgcast_scene *scene, uint8_t layer,
                        struct csg_objects *objects)
{
    const struct csg_tree *tree = &scene->trees[layer];
    struct csg_box *boxes = malloc((tree->num + 1) * sizeof *boxes);
    if (!boxes)
        return false;
    csg_tree_boxes(scene, tree, boxes);
    bool ok = true;
    for (uint32_t i = csg_tree_first_operand(tree); i < tree->num && ok; i = tree->data[i].end) {
        const struct csg_object object = {layer, layer, false, is_crowded(tree, i), i,
                                          tree->data[i].end, boxes[i]};
        ok = csg_array_push(objects, object);
    }
    free(boxes);
    return ok;
}

/* Marks of leaves, by what is known of them so far. */
enum { UNDER_HIGHLIGHT = 1, PAINTED = 2 };

static bool is_highlighted(const struct csg_tree *tree, const struct csg_object *object,
                           const uint8_t *marks)
{
    for (uint32_t i = object->begin; i < object->end; i++)
        if (tree->data[i].op == CSG_LEAF && !tree->data[i].negated && !tree->data[i].spare &&
            !(marks[tree->data[i].leaf] & UNDER_HIGHLIGHT))
            return false;
    return true;
}

static void mark_leaves(const struct csg_tree *tree, uint32_t begin, uint32_t end, uint8_t mark,
                        uint8_t *marks)
{
    for (uint32_t i = begin; i < end; i++)
        if (tree->data[i].op == CSG_LEAF)
            marks[tree->data[i].leaf] |= mark;
}

/* Where # is on all of the model, OpenSCAD draws the model as well. */
static bool is_all_painted(const struct csg_objects *objects)
{
    for (size_t i = 0; i < objects->num; i++)
        if (objects->data[i].layer == CSG_LAYER_MODEL &&
            objects->data[i].paint != CSG_LAYER_HIGHLIGHT)
            return false;
    return true;
}

static void unpaint(struct csg_objects *objects)
{
    for (size_t i = 0; i < objects->num; i++)
        objects->data[i].paint = objects->data[i].layer;
}

static void paint_highlights(const struct csgcast_scene *scene, struct csg_objects *objects,
                             uint8_t *marks)
{
    const struct csg_tree *highlight = &scene->trees[CSG_LAYER_HIGHLIGHT];
    mark_leaves(highlight, 0, (uint32_t)highlight->num, UNDER_HIGHLIGHT, marks);
    for (size_t i = 0; i < objects->num; i++) {
        struct csg_object *object = &objects->data[i];
        const struct csg_tree *tree = &scene->trees[object->layer];
        if (object->layer == CSG_LAYER_MODEL && is_highlighted(tree, object, marks)) {
            object->paint = CSG_LAYER_HIGHLIGHT;
            mark_leaves(tree, object->begin, object->end, PAINTED, marks);
        }
    }
    if (is_all_painted(objects)) {
        unpaint(objects);
        return;
    }
    for (size_t i = 0; i < objects->num; i++) {
        struct csg_object *object = &objects->data[i];
        object->hidden = object->layer == CSG_LAYER_HIGHLIGHT;
        for (uint32_t j = object->begin; j < object->end && object->hidden; j++)
            object->hidden = highlight->data[j].op != CSG_LEAF ||
                             marks[highlight->data[j].leaf] & PAINTED;
    }
}

bool csg_objects_split(const struct csgcast_scene *scene, struct csg_objects *objects)
{
    for (uint8_t layer = 0; layer < CSG_NUM_LAYERS; layer++)
        if (!split_layer(scene, layer, objects))
            return false;
    if (scene->trees[CSG_LAYER_HIGHLIGHT].num == 0)
        return true;
    uint8_t *marks = calloc(scene->num_leaves + 1, sizeof *marks);
    if (marks)
        paint_highlights(scene, objects, marks);
    free(marks);
    return marks != NULL;
}
