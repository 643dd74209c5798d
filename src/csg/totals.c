/* SPDX-License-Identifier: MIT */
#include "csg/totals.h"

#include <math.h>
#include <stdlib.h>

#include "csg/framing.h"

/* Objects of a run. */
enum { RUN = 256 };

static void add_leaf(struct csg_sum *sum, const struct csg_leaf *leaf, bool negated)
{
    sum->sagitta = fmax(sum->sagitta, leaf->shape.sagitta);
    if (negated)
        return;
    const struct csg_box written = csg_written_box(leaf);
    if (csg_box_is_finite(&written))
        sum->written = csg_box_union(&sum->written, &written);
}

static void add_object(struct csg_sum *sum, const struct csgcast_scene *scene,
                       const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    sum->box = csg_box_union(&sum->box, &object->box);
    for (uint32_t i = object->begin; i < object->end; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].spare)
            add_leaf(sum, &scene->leaves[nodes[i].leaf], nodes[i].negated);
}

static struct csg_sum nothing(void)
{
    return (struct csg_sum){csg_box_empty, csg_box_empty, 0};
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

void csg_totals_renew(struct csg_totals *totals, const struct csgcast_scene *scene, uint32_t object)
{
    add_run(totals, scene, object / RUN);
}

struct csg_box csg_totals_box(const struct csg_totals *totals)
{
    struct csg_box box = csg_box_empty;
    for (size_t i = 0; i < totals->num; i++)
        box = csg_box_union(&box, &totals->sums[i].box);
    return box;
}

void csg_totals_put(const struct csg_totals *totals, struct csgcast_scene *scene)
{
    struct csg_sum all = nothing();
    for (size_t i = 0; i < totals->num; i++) {
        all.box = csg_box_union(&all.box, &totals->sums[i].box);
        all.written = csg_box_union(&all.written, &totals->sums[i].written);
        all.sagitta = fmax(all.sagitta, totals->sums[i].sagitta);
    }
    scene->box = scene->drawn = all.box;
    scene->written = all.written;
    scene->info.sagitta = all.sagitta;
}
