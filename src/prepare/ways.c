/* SPDX-License-Identifier: MIT */
#include "prepare/ways.h"

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

/* ---- handed to OpenSCAD -------------------------------------------------------------------- */

/* The places of leaves in the text. */
struct places {
    size_t num;
    uint64_t *data; /* ascending */
};

static uint64_t place_of(uint32_t line, uint32_t column)
{
    return (uint64_t)line << 32 | column;
}

static int compare_places(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* Of what OpenSCAD made. data is NULL: out of memory. */
static struct places list_places(const struct csgcast_scene *scene)
{
    struct places places = {0, malloc((scene->num_leaves + 1) * sizeof *places.data)};
    for (size_t i = 0; i < scene->num_leaves && places.data; i++) {
        const struct csg_leaf *leaf = &scene->leaves[i];
        if (leaf->kind == CSG_KIND_OPENSCAD)
            places.data[places.num++] = place_of(leaf->line, leaf->column);
    }
    if (places.num > 1)
        qsort(places.data, places.num, sizeof *places.data, compare_places);
    return places;
}

static size_t num_before(const struct places *places, uint64_t place)
{
    size_t lo = 0, hi = places->num;
    while (lo < hi) {
        const size_t mid = lo + (hi - lo) / 2;
        if (places->data[mid] < place)
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo;
}

static bool add_nodes(struct csgcast_scene *scene, const struct places *places)
{
    bool ok = true;
    for (size_t i = 0; i < scene->handed_off.num && ok; i++) {
        const struct csg_handed_off_node *node = &scene->handed_off.data[i];
        const uint64_t place = place_of(node->line, node->column);
        const struct csgcast_scene_way entry = {
            .way = CSGCAST_WAY_OPENSCAD,
            .name = node->name,
            .reason = node->reason,
            .num_nodes = 1,
            .num_leaves = num_before(places, place + 1) - num_before(places, place),
            .line = node->line,
            .column = node->column,
            .seconds = node->seconds,
            .cached = node->is_cached,
        };
        ok = csg_array_push(&scene->ways, entry);
    }
    return ok;
}

static bool add_handed_off(struct csgcast_scene *scene)
{
    if (scene->handed_off.num == 0)
        return true;
    const struct places places = list_places(scene);
    const bool ok = places.data && add_nodes(scene, &places);
    free(places.data);
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
