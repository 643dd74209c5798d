/* SPDX-License-Identifier: MIT */
#include "prepare/totals.h"

#include <math.h>
#include <stdlib.h>

#include "csg/wholes.h"
#include "prepare/framing.h"

/* Objects of a run. */
enum { RUN = 256 };

/* What is left in render() nodes is framed by itself. */
static void add_leaf(struct csg_sum *sum, const struct csgcast_scene *scene,
                     const struct csg_node *node, uint8_t layer)
{
    const struct csg_leaf *leaf = &scene->leaves[node->leaf];
    if (layer != CSG_LAYER_HIGHLIGHT)
        sum->sagitta = fmax(sum->sagitta, leaf->shape.sagitta);
    if (node->negated || csg_find_whole(scene, node->leaf))
        return;
    const struct csg_box written = csg_written_box(leaf);
    if (csg_box_is_finite(&written))
        sum->written = csg_box_union(&sum->written, &written);
}

static void add_object(struct csg_sum *sum, const struct csgcast_scene *scene,
                       const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    if (object->layer == CSG_LAYER_MODEL)
        sum->box = csg_box_union(&sum->box, &object->box);
    sum->drawn = csg_box_union(&sum->drawn, &object->box);
    for (uint32_t i = object->begin; i < object->end; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].spare)
            add_leaf(sum, scene, &nodes[i], object->layer);
}

static struct csg_sum nothing(void)
{
    return (struct csg_sum){csg_box_empty, csg_box_empty, csg_box_empty, 0};
}

static void add_run(struct csg_totals *totals, const struct csgcast_scene *scene, size_t run)
{
    struct csg_sum sum = nothing();
    for (size_t i = RUN * run; i < RUN * (run + 1) && i < scene->objects->num; i++)
        add_object(&sum, scene, &scene->objects->data[i]);
    totals->sums[run] = sum;
}

bool csg_totals_init(struct csg_totals *totals, const struct csgcast_scene *scene)
{
    totals->num = (scene->objects->num + RUN - 1) / RUN;
    totals->sums = malloc((totals->num + 1) * sizeof *totals->sums);
    for (size_t i = 0; i < totals->num && totals->sums; i++)
        add_run(totals, scene, i);
    return totals->sums != NULL;
}

void csg_totals_finish(struct csg_totals *totals)
{
    free(totals->sums);
}

void csg_totals_renew(struct csg_totals *totals, const struct csgcast_scene *scene,
                      const uint32_t *objects, size_t num)
{
    for (size_t i = 0; i < num; i++)
        if (i == 0 || objects[i] / RUN != objects[i - 1] / RUN)
            add_run(totals, scene, objects[i] / RUN);
}

struct csg_sum csg_totals_sum(const struct csg_totals *totals)
{
    struct csg_sum all = nothing();
    for (size_t i = 0; i < totals->num; i++) {
        all.box = csg_box_union(&all.box, &totals->sums[i].box);
        all.drawn = csg_box_union(&all.drawn, &totals->sums[i].drawn);
        all.written = csg_box_union(&all.written, &totals->sums[i].written);
        all.sagitta = fmax(all.sagitta, totals->sums[i].sagitta);
    }
    return all;
}

void csg_totals_put(const struct csg_totals *totals, struct csgcast_scene *scene)
{
    const struct csg_sum all = csg_totals_sum(totals);
    scene->box = all.box;
    scene->drawn = all.drawn;
    scene->info.sagitta = all.sagitta;
}
