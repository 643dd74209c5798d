/* SPDX-License-Identifier: MIT */
#include "csg/ways.h"

#include <stdlib.h>

enum { num_ways = CSGCAST_WAY_OPENSCAD + 1 };

/* Leaves of one kind that come about in one way. */
struct group {
    size_t num_nodes, num_leaves;
    uint32_t line, column;           /* of the first */
    uint32_t last_line, last_column; /* leaves of a node follow each other */
};

struct summary {
    struct group groups[num_ways][CSG_NUM_LEAF_KINDS];
};

static enum csgcast_way way_of(const struct csg_leaf *leaf)
{
    if (leaf->kind == CSG_KIND_OPENSCAD)
        return CSGCAST_WAY_OPENSCAD;
    if (leaf->shape.surface)
        return CSGCAST_WAY_MESH;
    return leaf->shape.facetted ? CSGCAST_WAY_FACETTED : CSGCAST_WAY_EXACT;
}

static bool is_earlier(const struct csg_leaf *leaf, const struct group *group)
{
    return leaf->line < group->line || (leaf->line == group->line && leaf->column < group->column);
}

static void add_leaf(struct summary *summary, const struct csg_leaf *leaf)
{
    struct group *group = &summary->groups[way_of(leaf)][leaf->kind];
    const bool is_same = group->num_leaves > 0 && leaf->line == group->last_line &&
                         leaf->column == group->last_column;
    if (group->num_leaves == 0 || is_earlier(leaf, group)) {
        group->line = leaf->line;
        group->column = leaf->column;
    }
    group->num_leaves++;
    group->num_nodes += !is_same;
    group->last_line = leaf->line;
    group->last_column = leaf->column;
}

static void add_tree(struct summary *summary, const struct csgcast_scene *scene,
                     const struct csg_tree *tree)
{
    for (size_t i = 0; i < tree->num; i++)
        if (tree->data[i].op == CSG_LEAF)
            add_leaf(summary, &scene->leaves[tree->data[i].leaf]);
}

static const char *reason_of(enum csgcast_way way, enum csg_kind kind)
{
    if (way == CSGCAST_WAY_FACETTED)
        return kind == CSG_KIND_HULL || kind == CSG_KIND_MINKOWSKI
                   ? "made of the facets of what is in it"
                   : "--facets=as-written, a $fn that means a polygon, or a twist";
    return way == CSGCAST_WAY_MESH ? "a surface of triangles" : NULL;
}

static bool add_groups(struct csgcast_scene *scene, const struct summary *summary)
{
    bool ok = true;
    for (int way = 0; way < CSGCAST_WAY_OPENSCAD; way++) {
        for (int kind = 0; kind < CSG_NUM_LEAF_KINDS && ok; kind++) {
            const struct group *group = &summary->groups[way][kind];
            const struct csgcast_scene_way entry = {
                .way = (enum csgcast_way)way,
                .name = csg_kind_name((enum csg_kind)kind),
                .reason = reason_of((enum csgcast_way)way, (enum csg_kind)kind),
                .num_nodes = group->num_nodes,
                .num_leaves = group->num_leaves,
                .line = group->line,
                .column = group->column,
            };
            ok = group->num_leaves == 0 || csg_array_push(&scene->ways, entry);
        }
    }
    return ok;
}

static size_t count_leaves_at(const struct csgcast_scene *scene, uint32_t line, uint32_t column)
{
    size_t num = 0;
    for (size_t i = 0; i < scene->num_leaves; i++)
        num += scene->leaves[i].kind == CSG_KIND_OPENSCAD && scene->leaves[i].line == line &&
               scene->leaves[i].column == column;
    return num;
}

static bool add_handed_off(struct csgcast_scene *scene)
{
    bool ok = true;
    for (size_t i = 0; i < scene->handed_off.num && ok; i++) {
        const struct csg_handed_off_node *node = &scene->handed_off.data[i];
        const struct csgcast_scene_way entry = {
            .way = CSGCAST_WAY_OPENSCAD,
            .name = node->name,
            .reason = node->reason,
            .num_nodes = 1,
            .num_leaves = count_leaves_at(scene, node->line, node->column),
            .line = node->line,
            .column = node->column,
            .seconds = node->seconds,
            .cached = node->is_cached,
        };
        ok = csg_array_push(&scene->ways, entry);
    }
    return ok;
}

bool csg_ways_fill(struct csgcast_scene *scene)
{
    struct summary *summary = calloc(1, sizeof *summary);
    if (!summary)
        return false;
    scene->ways = (struct csg_scene_ways){0}; /* those of before an edit are still in use */
    add_tree(summary, scene, &scene->trees[CSG_LAYER_MODEL]);
    add_tree(summary, scene, &scene->trees[CSG_LAYER_BACKGROUND]);
    const bool ok = add_groups(scene, summary) && add_handed_off(scene);
    free(summary);
    scene->info.num_handed_off = scene->handed_off.num;
    scene->info.num_ways = scene->ways.num;
    scene->info.ways = scene->ways.data;
    return ok;
}
