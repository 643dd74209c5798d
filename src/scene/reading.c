/* SPDX-License-Identifier: MIT */
#include "scene/reading.h"

#include <stdio.h>
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

static bool read_node(struct csg_reading *reading, const struct csgcast_scene *scene,
                      const struct csg_patch *patch, const struct csg_document *document)
{
    const struct csg_space space = own_space(patch);
    struct csg_report report;
    char file[48];
    snprintf(file, sizeof file, "<edit of leaf %u>", (unsigned)patch->index);
    csg_report_init(&report, &scene->log, file);
    reading->scene =
        csg_scene_read_nodes(document, &scene->source->params, &space, &reading->origins, &report);
    return csg_report_finish(&report) && reading->scene;
}

/* The part is the same set wherever it stands; there it may be complemented. */
static bool is_same_node(const struct csg_reading *reading, const struct csg_node *part,
                         const struct csg_node *node, const struct csg_part_place *place)
{
    struct csg_node same = *part;
    same.end += place->at - reading->part_begin;
    if (part->op == CSG_LEAF) {
        same.leaf += reading->first;
        same.negated = part->negated != place->negated;
    } else if (place->negated) {
        same.op = part->op == CSG_OR ? CSG_AND : CSG_OR;
    }
    return csg_node_is_same(&same, 0, node, 0);
}

static const struct csg_part_place *find_place(const struct csg_origins *origins, uint32_t node)
{
    size_t i = 0;
    while (i < origins->places.num && origins->places.data[i].node != node)
        i++;
    return i < origins->places.num ? &origins->places.data[i] : NULL;
}

static bool is_alike(const struct csg_reading *reading, const struct csg_edits *edits,
                     uint32_t node)
{
    const struct csg_part_place *place = find_place(&edits->origins, node);
    const struct csg_node *nodes = edits->whole[place->layer].data + place->at;
    const uint32_t num = reading->part_end - reading->part_begin;
    bool same = reading->num == reading->num_before && nodes->end - place->at == num;
    for (uint32_t i = 0; i < num && same; i++)
        same = is_same_node(reading, &reading->part[i], &nodes[i], place);
    return same;
}

bool csg_reading_init(struct csg_reading *reading, const struct csgcast_scene *scene,
                      const struct csg_patch *patch)
{
    const struct csg_edits *edits = scene->edits;
    const uint32_t node = patch->origin.node;
    struct csg_excerpt excerpt = {0};
    *reading = (struct csg_reading){
        .first = patch->origin.first, .num_before = patch->origin.num, .is_alike = true};
    const bool ok =
        csg_excerpt_init(&excerpt, &edits->texts, node, edits->texts.document.nodes.data[node].end)
            ? read_node(reading, scene, patch, &excerpt.document)
            : csg_log_memory(&scene->log);
    csg_excerpt_finish(&excerpt);
    const struct csg_part_place *place = ok ? find_place(&reading->origins, 0) : NULL;
    if (!place || reading->origins.num == 0 || reading->origins.data[0].node != 0)
        return ok;
    reading->num = reading->origins.data[0].num;
    reading->part = reading->scene->trees[place->layer].data + place->at;
    reading->part_begin = place->at;
    reading->part_end = reading->part->end;
    reading->is_alike = is_alike(reading, edits, node);
    return true;
}

void csg_reading_finish(struct csg_reading *reading)
{
    csg_origins_finish(&reading->origins);
    csgcast_scene_destroy(reading->scene);
}
