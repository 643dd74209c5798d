/* SPDX-License-Identifier: MIT */
#include "reference/bounds.h"

#include <stdlib.h>

#include "csg/object.h"

/* A face may lie on the carrier of another leaf, off by the rounding of both and this share of the
 * coordinates; a line that grazes a box is asked. */
#define MARGIN 1e-6

/* Fewer children are as soon asked one by one. */
enum { MIN_CROWD = 32 };

static double largest_rounding(const struct csgcast_scene *scene)
{
    double largest = 0;
    for (size_t i = 0; i < scene->num_leaves; i++)
        largest = fmax(largest, scene->leaves[i].shape.rounding);
    return largest;
}

static struct csg_box leaf_box(const struct csg_leaf *leaf, double rounding)
{
    const struct csg_box box = leaf->box;
    double size = 0;
    if (csg_box_is_empty(&box))
        return box;
    for (int i = 0; i < 8; i++)
        size = fmax(size, csg_length(csg_box_corner(&box, i)));
    return isfinite(size) ? csg_box_grown(&box, 2 * rounding + MARGIN * size) : csg_box_all;
}

static struct csg_node_bounds leaf_node(const struct csgcast_scene *scene,
                                        const struct csg_node *node, double rounding)
{
    const struct csg_box box =
        node->spare ? csg_box_empty : leaf_box(&scene->leaves[node->leaf], rounding);
    return (struct csg_node_bounds){box, node->negated, 0};
}

static struct csg_node_bounds inner_node(const struct csg_node *nodes,
                                         const struct csg_node_bounds *bounds, uint32_t node)
{
    const bool all = nodes[node].op == CSG_AND;
    struct csg_node_bounds result = {csg_box_empty, all, 0};
    for (uint32_t child = node + 1; child < nodes[node].end; child = nodes[child].end) {
        result.box = csg_box_union(&result.box, &bounds[child].box);
        result.inside =
            all ? result.inside && bounds[child].inside : result.inside || bounds[child].inside;
    }
    return result;
}

/* ---- crowds of children --------------------------------------------------------------------- */

static size_t count_children(const struct csg_node *nodes, uint32_t node)
{
    size_t num = 0;
    for (uint32_t child = node + 1; child < nodes[node].end; child = nodes[child].end)
        num++;
    return num;
}

/* Those that are what the node's operation leaves as it is come first. */
static void sort_children(struct csg_child_crowd *crowd, const struct csg_node *nodes,
                          const struct csg_node_bounds *bounds, uint32_t node)
{
    const bool neutral = nodes[node].op == CSG_AND;
    for (uint32_t child = node + 1; child < nodes[node].end; child = nodes[child].end)
        if (bounds[child].inside == neutral)
            crowd->children[crowd->num++] = child;
    for (uint32_t child = node + 1; child < nodes[node].end; child = nodes[child].end)
        if (bounds[child].inside != neutral)
            crowd->children[crowd->num + crowd->num_others++] = child;
}

static bool fill_crowd(struct csg_child_crowd *crowd, const struct csg_node *nodes,
                       const struct csg_node_bounds *bounds, uint32_t node)
{
    const size_t num = count_children(nodes, node);
    struct csg_box *boxes = malloc(num * sizeof *boxes);
    crowd->children = malloc(num * sizeof *crowd->children);
    bool ok = boxes && crowd->children;
    if (ok)
        sort_children(crowd, nodes, bounds, node);
    for (size_t i = 0; ok && i < crowd->num; i++)
        boxes[i] = bounds[crowd->children[i]].box;
    ok = ok && csg_box_tree_init(&crowd->tree, boxes, crowd->num);
    free(boxes);
    return ok;
}

static bool add_crowds(struct csg_tree_bounds *bounds, const struct csg_tree *tree, int layer)
{
    bool ok = true;
    for (uint32_t i = 0; ok && i < tree->num; i++) {
        if (tree->data[i].op == CSG_LEAF || tree->data[i].end - i < MIN_CROWD ||
            count_children(tree->data, i) < MIN_CROWD)
            continue;
        ok = csg_array_push(&bounds->crowds, (struct csg_child_crowd){.num = 0}) &&
             fill_crowd(&bounds->crowds.data[bounds->crowds.num - 1], tree->data,
                        bounds->nodes[layer], i);
        bounds->nodes[layer][i].crowd = (uint32_t)bounds->crowds.num;
    }
    return ok;
}

/* ---- all ------------------------------------------------------------------------------------ */

bool csg_tree_bounds_init(struct csg_tree_bounds *bounds, const struct csgcast_scene *scene)
{
    const double rounding = largest_rounding(scene);
    *bounds = (struct csg_tree_bounds){.nodes = {NULL}};
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++) {
        const struct csg_tree *tree = &scene->trees[layer];
        bounds->nodes[layer] = malloc((tree->num + 1) * sizeof *bounds->nodes[layer]);
        if (!bounds->nodes[layer])
            return false;
        for (size_t i = tree->num; i-- > 0;) {
            const struct csg_node *node = &tree->data[i];
            bounds->nodes[layer][i] =
                node->op == CSG_LEAF ? leaf_node(scene, node, rounding)
                                     : inner_node(tree->data, bounds->nodes[layer], (uint32_t)i);
        }
        if (!add_crowds(bounds, tree, layer))
            return false;
    }
    return true;
}

void csg_tree_bounds_finish(struct csg_tree_bounds *bounds)
{
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++)
        free(bounds->nodes[layer]);
    for (size_t i = 0; i < bounds->crowds.num; i++) {
        csg_box_tree_finish(&bounds->crowds.data[i].tree);
        free(bounds->crowds.data[i].children);
    }
    free(bounds->crowds.data);
}
