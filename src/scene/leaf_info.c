/* SPDX-License-Identifier: MIT */

/* What is told of the leaves of a scene that may be edited, and of their nodes. */

#include <string.h>

#include "scene/edits.h"

size_t csgcast_scene_num_leaves(const struct csgcast_scene *scene)
{
    return scene ? scene->num_leaves : 0;
}

bool csg_edits_has_leaf(const struct csgcast_scene *scene, size_t leaf)
{
    if (leaf < scene->num_leaves)
        return true;
    csg_log_error(&scene->log, CSGCAST_MESSAGE_ARGUMENT, "%s: there is no leaf %zu of %zu",
                  scene->name, leaf, scene->num_leaves);
    return false;
}

static void copy_matrix(const struct csg_map *map, double matrix[16])
{
    static const double last[4] = {0, 0, 0, 1};
    memcpy(matrix, map->m, sizeof map->m);
    memcpy(matrix + 12, last, sizeof last);
}

uint32_t csg_edits_count_nodes(const struct csgcast_scene *scene, const struct csg_origin *origin)
{
    const struct csg_parsed_node *nodes = scene->edits->texts.document.nodes.data;
    return origin->is_compound ? nodes[origin->node].end - origin->node : 1;
}

bool csgcast_scene_get_leaf(struct csgcast_scene *scene, size_t index, struct csgcast_leaf *info)
{
    if (!scene || !csg_edits_has_leaf(scene, index) || !csg_edits_of(scene))
        return false;
    const struct csg_leaf *leaf = &scene->leaves[index];
    const struct csg_origin *origin = &scene->edits->origins.data[index];
    *info =
        (struct csgcast_leaf){.kind = csg_kind_name(leaf->kind),
                              .line = leaf->line,
                              .column = leaf->column,
                              .first = origin->first,
                              .num = origin->num,
                              .num_nodes = csg_edits_count_nodes(scene, origin),
                              .empty = leaf->is_empty,
                              .parameters = csg_node_texts_get(&scene->edits->texts, origin->node)};
    copy_matrix(&origin->space.map, info->matrix);
    memcpy(info->color, leaf->color, sizeof info->color);
    return info->parameters || csg_log_memory(&scene->log);
}

bool csg_edits_has_node(const struct csgcast_scene *scene, size_t leaf, size_t node)
{
    const size_t num = csg_edits_count_nodes(scene, &scene->edits->origins.data[leaf]);
    if (node < num)
        return true;
    csg_log_error(&scene->log, CSGCAST_MESSAGE_ARGUMENT, "%s: leaf %zu has no node %zu of %zu",
                  scene->name, leaf, node, num);
    return false;
}

bool csgcast_scene_get_node(struct csgcast_scene *scene, size_t leaf, size_t index,
                            struct csgcast_node *info)
{
    if (!scene || !csg_edits_has_leaf(scene, leaf) || !csg_edits_of(scene) ||
        !csg_edits_has_node(scene, leaf, index))
        return false;
    struct csg_node_texts *texts = &scene->edits->texts;
    const struct csg_origin *origin = &scene->edits->origins.data[leaf];
    const uint32_t node = origin->node + (uint32_t)index;
    const struct csg_parsed_node *parsed = &texts->document.nodes.data[node];
    *info = (struct csgcast_node){.name = csg_node_texts_name(texts, node),
                                  .line = parsed->place.line,
                                  .column = parsed->place.column,
                                  .num = origin->is_compound ? parsed->end - node : 1,
                                  .parameters = csg_node_texts_get(texts, node)};
    return info->parameters || csg_log_memory(&scene->log);
}
