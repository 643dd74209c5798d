/* SPDX-License-Identifier: MIT */
#include "csg/membership.h"

#include <stdlib.h>

bool csg_object_contains(const struct csgcast_scene *scene, const struct csg_object *object,
                         struct csg_vec3 point)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    bool *values = malloc((object->end - object->begin) * sizeof *values);
    if (!values)
        return true;
    for (uint32_t i = object->end; i-- > object->begin;) {
        const struct csg_node *node = &nodes[i];
        bool value = node->op == CSG_AND;
        if (node->op == CSG_LEAF)
            value = (!node->spare &&
                     csg_shape_contains(&scene->leaves[node->leaf].shape, point)) != node->negated;
        else
            for (uint32_t child = i + 1; child < node->end; child = nodes[child].end)
                value = node->op == CSG_AND ? value && values[child - object->begin]
                                            : value || values[child - object->begin];
        values[i - object->begin] = value;
    }
    const bool inside = values[0];
    free(values);
    return inside;
}
