/* SPDX-License-Identifier: MIT */
#include "scene/reading.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/load.h"

/* The space around the node, but for where that puts it. */
static struct csg_space own_space(const struct csg_patch *patch)
{
    struct csg_space space = patch->origin.space;
    space.map = csg_map_identity;
    memset(space.error, 0, sizeof space.error);
    space.is_empty = false;
    memcpy(space.color, patch->leaf.color, sizeof space.color);
    return space;
}

/* Reads the nodes from begin on, below end. space: around them; NULL: the world. */
static bool read_nodes(struct csg_reading *reading, const struct csgcast_scene *scene,
                       uint32_t begin, uint32_t end, const struct csg_space *space,
                       struct csg_report *report)
{
    struct csg_excerpt excerpt = {0};
    const struct csg_build_source source = {.document = &excerpt.document,
                                            .params = &scene->source->params,
                                            .space = space,
                                            .origins = &reading->origins,
                                            .text = &scene->edits->text,
                                            .report = report};
    if (csg_excerpt_init(&excerpt, &scene->edits->texts, begin, end))
        reading->scene = csg_scene_read_nodes(&source);
    else
        csg_log_memory(&report->log);
    csg_excerpt_finish(&excerpt);
    return csg_report_finish(report) && reading->scene;
}

/* Faces that are not plane are cut by what is around the node: then all of the text is read. root
 * gets what the node is in what was read. */
static bool read_node(struct csg_reading *reading, const struct csgcast_scene *scene,
                      const struct csg_patch *patch, uint32_t *root)
{
    const struct csg_document *document = &scene->edits->texts.document;
    const uint32_t node = patch->origin.node;
    const struct csg_space space = own_space(patch);
    struct csg_report report;
    char file[48];
    snprintf(file, sizeof file, "<edit of leaf %u>", (unsigned)patch->index);
    csg_report_init(&report, &scene->log, file);
    *root = 0;
    if (!read_nodes(reading, scene, node, document->nodes.data[node].end, &space, &report))
        return false;
    if (!reading->origins.are_placed)
        return true;
    csg_reading_finish(reading);
    *root = node;
    csg_report_init(&report, &csg_log_silent, file); /* it has been said */
    return read_nodes(reading, scene, 0, (uint32_t)document->nodes.num, NULL, &report) ||
           csg_log_memory(&scene->log);
}

struct csg_node csg_reading_node(const struct csg_reading *reading, uint32_t i,
                                 const struct csg_part_place *place, uint32_t first)
{
    const bool negated = place->negated != reading->negated;
    struct csg_node node = reading->part[i];
    node.end += place->at - reading->part_begin;
    if (node.op == CSG_LEAF) {
        node.leaf += first - reading->begin;
        node.negated = node.negated != negated;
    } else if (negated) {
        node.op = node.op == CSG_OR ? CSG_AND : CSG_OR;
    }
    return node;
}

static int compare_places(const void *a, const void *b)
{
    const struct csg_part_place *x = a, *y = b;
    if (x->layer != y->layer)
        return x->layer < y->layer ? -1 : 1;
    return x->node < y->node ? -1 : x->node > y->node;
}

/* In the order of a tree nodes come as in the text. */
static const struct csg_part_place *find_place(const struct csg_origins *origins, uint32_t node)
{
    const struct csg_part_place *found = NULL;
    for (uint8_t layer = 0; layer < CSG_NUM_LAYERS && origins->places.num > 0 && !found; layer++) {
        const struct csg_part_place key = {.node = node, .layer = layer};
        found =
            bsearch(&key, origins->places.data, origins->places.num, sizeof key, compare_places);
    }
    return found;
}

static bool is_alike(const struct csg_reading *reading, const struct csg_edits *edits,
                     uint32_t node)
{
    const struct csg_part_place *place = find_place(&edits->origins, node);
    if (!place) /* a solid among drawings is in no tree */
        return reading->num == reading->num_before;
    const struct csg_node *nodes = edits->whole[place->layer].data + place->at;
    const uint32_t num = reading->part_end - reading->part_begin;
    bool same = reading->num == reading->num_before && nodes->end - place->at == num;
    for (uint32_t i = 0; i < num && same; i++) {
        const struct csg_node read = csg_reading_node(reading, i, place, reading->first);
        same = csg_node_is_same(&read, 0, &nodes[i], 0);
    }
    return same;
}

static uint32_t find_leaf(const struct csg_origins *origins, uint32_t node)
{
    uint32_t i = 0;
    while (i < origins->num && origins->data[i].node != node)
        i++;
    return i;
}

bool csg_reading_init(struct csg_reading *reading, const struct csgcast_scene *scene,
                      const struct csg_patch *patch)
{
    uint32_t root;
    *reading = (struct csg_reading){
        .first = patch->origin.first, .num_before = patch->origin.num, .is_alike = true};
    if (!read_node(reading, scene, patch, &root))
        return false;
    const struct csg_part_place *place = find_place(&reading->origins, root);
    reading->begin = find_leaf(&reading->origins, root);
    if (!place || reading->begin == reading->origins.num)
        return true;
    reading->num = reading->origins.data[reading->begin].num;
    reading->part = reading->scene->trees[place->layer].data + place->at;
    reading->part_begin = place->at;
    reading->part_end = reading->part->end;
    reading->negated = place->negated;
    reading->is_alike = is_alike(reading, scene->edits, patch->origin.node);
    return true;
}

void csg_reading_finish(struct csg_reading *reading)
{
    csg_origins_finish(&reading->origins);
    csgcast_scene_destroy(reading->scene);
    reading->scene = NULL;
}
