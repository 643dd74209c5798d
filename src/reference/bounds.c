/* SPDX-License-Identifier: MIT */
#include "reference/bounds.h"

#include <stdlib.h>

#include "csg/object.h"

/* A face may lie on the carrier of another leaf, off by the rounding of both and this share of the
 * coordinates; a line that grazes a box is asked. */
#define MARGIN 1e-6

static double largest_rounding(const struct csgcast_scene *scene)
{
    double largest = 0;
    for (size_t i = 0; i < scene->num_leaves; i++)
        largest = fmax(largest, scene->leaves[i].shape.rounding);
    return largest;
}

static struct csg_box leaf_box(const struct csg_leaf *leaf, double rounding)
{
    const struct csg_box box = csg_leaf_box(leaf);
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
    return (struct csg_node_bounds){box, node->negated};
}

static struct csg_node_bounds inner_node(const struct csg_node *nodes,
                                         const struct csg_node_bounds *bounds, uint32_t node)
{
    const bool all = nodes[node].op == CSG_AND;
    struct csg_node_bounds result = {csg_box_empty, all};
    for (uint32_t child = node + 1; child < nodes[node].end; child = nodes[child].end) {
        result.box = csg_box_union(&result.box, &bounds[child].box);
        result.inside =
            all ? result.inside && bounds[child].inside : result.inside || bounds[child].inside;
    }
    return result;
}

bool csg_tree_bounds_init(struct csg_tree_bounds *bounds, const struct csgcast_scene *scene)
{
    const double rounding = largest_rounding(scene);
    *bounds = (struct csg_tree_bounds){{NULL}};
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++) {
        const struct csg_tree *tree = &scene->trees[layer];
        bounds->nodes[layer] = malloc((tree->num + 1) * sizeof *bounds->nodes[layer]);
        if (!bounds->nodes[layer])
            return false;
        for (size_t i = tree->num; i-- > 0;) {
            const struct csg_node *node = &tree->data[i];
            bounds->nodes[layer][i] =
                node->op == CSG_LEAF
                    ? leaf_node(scene, node, rounding)
                    : inner_node(tree->data, bounds->nodes[layer], (uint32_t)i);
        }
    }
    return true;
}

void csg_tree_bounds_finish(struct csg_tree_bounds *bounds)
{
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++)
        free(bounds->nodes[layer]);
}
