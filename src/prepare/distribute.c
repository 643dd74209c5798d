/* SPDX-License-Identifier: MIT */
#include "prepare/distribute.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "carrier/side.h"
#include "csg/prune.h"
#include "mesh/surface.h"

/* Below this many operands one object in tiles is drawn as soon. */
#define MIN_OPERANDS 32

/*
 * What is drawn in addition: the nodes that the cuts add, in those of the object, at all pixels of
 * the parts that are still cut, in the object's. Measured on real files: above this it does not
 * pay.
 */
#define MAX_EXTRA 2.0
/* How many times as many nodes as before the parts may have, */
#define MAX_GROWTH 3
/* ... and how many leaves may be looked at for it. */
#define MAX_LOOKS 2e7

/* A surface is projected for each part that it cuts: so many triangles of it take as long as a
 * node. */
#define TRIANGLES_A_NODE 16

/* Unions within the operands of unions are distributed in turn. */
#define MAX_PASSES 8

/* Parts have what matters in their box and so far around it, in sizes of the object, as keys are
 * rounded. */
#define MARGIN 1e-4

struct distributor {
    const struct csgcast_scene *scene;
    const struct csg_tree *from;
    const struct csg_object *object;
    uint32_t wide; /* node of the object's union that is distributed */
    double margin;
    double overlap;        /* of the parts that are cut: half their boxes' areas */
    size_t surfaces;       /* in them: nodes' worth of triangles */
    struct csg_box *boxes; /* of the nodes of from */
    uint8_t *known;        /* by leaf */
    struct csg_tree part, to;
    bool distributed; /* some object was */
};

/* Operands of a union that is worth it; 0: it has one without end. */
static size_t count_bounded(const struct distributor *at, uint32_t node)
{
    const struct csg_node *nodes = at->from->data;
    size_t num = 0;
    for (uint32_t i = node + 1; i < nodes[node].end; i = nodes[i].end, num++)
        if (!csg_box_is_finite(&at->boxes[i]) && !csg_box_is_empty(&at->boxes[i]))
            return 0;
    return num;
}

/* The object's widest union; its number of operands. */
static size_t find_wide(struct distributor *at)
{
    const struct csg_node *nodes = at->from->data;
    size_t most = 0;
    if (nodes[at->object->begin].op != CSG_AND)
        return 0;
    for (uint32_t i = at->object->begin + 1; i < at->object->end; i = nodes[i].end) {
        const size_t num = nodes[i].op == CSG_OR ? count_bounded(at, i) : 0;
        if (num > most) {
            most = num;
            at->wide = i;
        }
    }
    return most;
}

/* A subtrahend that is away from there takes nothing away: the fold would leave it out. */
static bool is_away(const struct distributor *at, const struct csg_node *node,
                    const struct csg_box *around)
{
    const struct csg_leaf *leaf = &at->scene->leaves[node->leaf];
    return node->op == CSG_LEAF && node->negated && !node->spare && !leaf->shape.surface &&
           csg_side_of_box(&leaf->box, around) == CSG_NOTHING;
}

/* The part of one operand, with all that it is cut by around it. */
static bool gather(struct distributor *at, uint32_t operand, const struct csg_box *around)
{
    const struct csg_node *nodes = at->from->data;
    const struct csg_node *root = &nodes[at->object->begin];
    at->part.num = 0;
    bool ok = csg_array_push(&at->part, *root) &&
              csg_tree_append(&at->part, nodes, operand, nodes[operand].end);
    for (uint32_t i = at->object->begin + 1; i < at->object->end && ok; i = nodes[i].end)
        ok = i == at->wide || is_away(at, &nodes[i], around) ||
             csg_tree_append(&at->part, nodes, i, nodes[i].end);
    if (ok)
        at->part.data[0].end = (uint32_t)at->part.num;
    return ok;
}

static uint8_t side_of(const struct distributor *at, uint32_t leaf, const struct csg_box *around)
{
    if (!at->scene->leaves[leaf].shape.surface)
        return csg_side_of_leaf(at->scene, leaf, csg_side_is_box(at->scene, leaf), around);
    const struct csg_box box = at->scene->leaves[leaf].box;
    const struct csg_box common = csg_box_intersection(&box, around);
    return csg_box_is_empty(&common) ? CSG_NOTHING : CSG_VARIES;
}

/* Of what cuts the operand that which matters in its box; its own leaves stay. */
static bool fold(struct distributor *at, uint32_t operand, const struct csg_box *around)
{
    const uint32_t own = 1 + at->from->data[operand].end - operand;
    for (uint32_t i = (uint32_t)at->part.num; i-- > 1;)
        if (at->part.data[i].op == CSG_LEAF)
            at->known[at->part.data[i].leaf] =
                i < own ? CSG_VARIES : side_of(at, at->part.data[i].leaf, around);
    return csg_tree_simplify(&at->part, at->known);
}

/* What the surfaces in a part that is cut cost. */
static size_t weigh_surfaces(const struct distributor *at)
{
    size_t num = 0;
    for (size_t i = 0; i < at->part.num; i++) {
        const struct csg_node *node = &at->part.data[i];
        const struct csg_surface *surface =
            node->op == CSG_LEAF ? at->scene->leaves[node->leaf].shape.surface : NULL;
        num += surface ? surface->triangles.num / TRIANGLES_A_NODE : 0;
    }
    return num;
}

static bool add_part(struct distributor *at, uint32_t operand, uint32_t minuend)
{
    const struct csg_box box = csg_box_intersection(&at->boxes[operand], &at->object->box);
    if (csg_box_is_empty(&box))
        return true;
    const struct csg_box around = csg_box_grown(&box, at->margin);
    if (!gather(at, operand, &around) || !fold(at, operand, &around))
        return false;
    if (at->part.num == 0)
        return true;
    if (at->part.data[0].op != CSG_LEAF)
        at->part.data[0].leaf = minuend;
    if (at->part.num > at->from->data[operand].end - operand) {
        at->overlap += csg_box_half_area(&box);
        at->surfaces += weigh_surfaces(at);
    }
    return csg_tree_append(&at->to, at->part.data, 0, (uint32_t)at->part.num);
}

static bool pays(const struct distributor *at, size_t num_nodes)
{
    const double before = at->object->end - at->object->begin;
    const double growth = fmax((double)num_nodes / before - 1, 0);
    return growth * at->overlap <= MAX_EXTRA * csg_box_half_area(&at->object->box);
}

static bool add_parts(struct distributor *at, size_t num)
{
    const struct csg_node *nodes = at->from->data;
    const struct csg_object *object = at->object;
    const size_t begin = at->to.num, most = begin + MAX_GROWTH * (object->end - object->begin);
    const uint32_t cuts = object->end - object->begin - (nodes[at->wide].end - at->wide);
    const struct csg_leaf *minuend = csg_object_minuend(at->scene, object);
    const uint32_t number = minuend ? (uint32_t)(minuend - at->scene->leaves) + 1 : 0;
    bool fits = (double)num * cuts < MAX_LOOKS;
    at->margin = MARGIN * csg_length(csg_sub(object->box.hi, object->box.lo));
    at->overlap = 0;
    at->surfaces = 0;
    for (uint32_t i = at->wide + 1; i < nodes[at->wide].end && fits; i = nodes[i].end) {
        if (!add_part(at, i, number))
            return false;
        fits = at->to.num + at->surfaces <= most;
    }
    if (fits && pays(at, at->to.num - begin)) {
        at->distributed = true;
        return true;
    }
    at->to.num = begin;
    return csg_tree_append(&at->to, nodes, object->begin, object->end);
}

static bool add_object(struct distributor *at)
{
    const size_t num = find_wide(at);
    const struct csg_node *nodes = at->from->data;
    const uint32_t begin = at->object->begin, end = at->object->end;
    if (num >= MIN_OPERANDS && csg_box_is_finite(&at->object->box) &&
        csg_nodes_are_opaque(at->scene, nodes, begin, end))
        return add_parts(at, num);
    return csg_tree_append(&at->to, nodes, begin, end);
}

static bool add_objects(struct distributor *at)
{
    const struct csg_objects *objects = at->scene->objects;
    bool ok = csg_array_push(&at->to, ((struct csg_node){.op = CSG_OR}));
    for (size_t i = 0; i < objects->num && ok; i++) {
        at->object = &objects->data[i];
        ok = at->object->layer != CSG_LAYER_MODEL || add_object(at);
    }
    if (ok)
        at->to.data[0].end = (uint32_t)at->to.num;
    return ok && csg_tree_simplify(&at->to, NULL);
}

static bool find_parts(struct distributor *at, const struct csgcast_scene *scene)
{
    at->scene = scene;
    at->from = &scene->trees[CSG_LAYER_MODEL];
    at->boxes = malloc((at->from->num + 1) * sizeof *at->boxes);
    at->known = malloc(scene->num_leaves + 1);
    if (at->boxes)
        csg_tree_boxes(scene, at->from, at->boxes);
    const bool ok = at->boxes && at->known && add_objects(at);
    free(at->boxes);
    free(at->known);
    free(at->part.data);
    return ok;
}

bool csg_distribute_may(const struct csg_tree *tree, const struct csg_object *object)
{
    const struct csg_node *nodes = tree->data;
    if (object->layer != CSG_LAYER_MODEL || object->end - object->begin <= MIN_OPERANDS ||
        nodes[object->begin].op != CSG_AND)
        return false;
    for (uint32_t i = object->begin + 1; i < object->end; i = nodes[i].end) {
        size_t num = 0;
        for (uint32_t j = i + 1; j < nodes[i].end && nodes[i].op == CSG_OR; j = nodes[j].end)
            num++;
        if (num >= MIN_OPERANDS)
            return true;
    }
    return false;
}

static bool is_wanted(const struct csgcast_scene *scene)
{
    const struct csg_tree *tree = &scene->trees[CSG_LAYER_MODEL];
    if (scene->trees[CSG_LAYER_HIGHLIGHT].num)
        return false;
    for (size_t i = 0; i < scene->objects->num; i++) {
        if (csg_distribute_may(tree, &scene->objects->data[i]))
            return true;
    }
    return false;
}

/* done: nothing was distributed. */
static bool pass(struct csgcast_scene *scene, bool *done)
{
    struct distributor at = {0};
    struct csg_tree *tree = &scene->trees[CSG_LAYER_MODEL];
    const bool found = find_parts(&at, scene);
    *done = !at.distributed;
    if (!found || *done) {
        free(at.to.data);
        return found;
    }
    free(tree->data);
    *tree = at.to;
    scene->is_distributed = true;
    scene->info.num_objects -= scene->objects->num;
    scene->objects->num = 0;
    const bool ok = csg_objects_split(scene, scene->objects);
    scene->info.num_objects += scene->objects->num; /* fewer than these, where there are spares */
    return ok;
}

bool csg_distribute(struct csgcast_scene *scene)
{
    bool done = false;
    for (int i = 0; i < MAX_PASSES && !done && is_wanted(scene); i++)
        if (!pass(scene, &done))
            return false;
    return true;
}
