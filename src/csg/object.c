/* SPDX-License-Identifier: MIT */
#include "csg/object.h"

#include <stdlib.h>

#include "csg/prune.h"
#include "csg/wholes.h"

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

static bool split_layer(const struct csgcast_scene *scene, uint8_t layer,
                        struct csg_objects *objects)
{
    const struct csg_tree *tree = &scene->trees[layer];
    struct csg_boxes room = {0};
    bool ok = csg_array_reserve(objects, csg_tree_count_operands(tree));
    for (uint32_t i = csg_tree_first_operand(tree); i < tree->num && ok; i = tree->data[i].end) {
        struct csg_object *object = &objects->data[objects->num++];
        *object = (struct csg_object){layer, layer, false, i, tree->data[i].end, csg_box_empty};
        ok = csg_operand_box(scene, tree, i, &room, &object->box);
    }
    free(room.data);
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

/* What is subtracted shows in neither: only a # of its own draws it. */
static void mark_leaves(const struct csg_tree *tree, uint32_t begin, uint32_t end, uint8_t mark,
                        uint8_t *marks)
{
    for (uint32_t i = begin; i < end; i++)
        if (tree->data[i].op == CSG_LEAF && !tree->data[i].negated)
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
            object->hidden = highlight->data[j].op != CSG_LEAF || highlight->data[j].negated ||
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
