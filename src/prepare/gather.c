/* SPDX-License-Identifier: MIT */
#include "prepare/gather.h"

#include <math.h>
#include <stdlib.h>

#include "csg/wholes.h"
#include "sharpness/wall.h"

/* Rings so many times as wide as what is turned is across: more is spared of the picture that each
 * of them goes round than a pixel of all of them costs more (measured). */
#define RING_WIDTHS 8

/* ... where they are at least this part of the leaves of the scene: of many profiles each is small
 * in the picture. */
#define RING_PART 3

/* A ring that is drawn in double costs as much as so many bands, about (measured). */
#define RINGS_FOR_DOUBLE 32

struct gatherer {
    const struct csgcast_scene *scene;
    uint8_t layer;
    uint8_t *highlighted; /* by leaf */
    struct csg_tree to;
};

static uint32_t first_leaf(const struct csg_tree *tree, uint32_t i)
{
    while (i < tree->num && tree->data[i].op != CSG_LEAF)
        i++;
    return i < tree->num ? tree->data[i].leaf : 0;
}

static bool is_see_through(const struct gatherer *gatherer, uint32_t leaf)
{
    return gatherer->layer != CSG_LAYER_MODEL || gatherer->highlighted[leaf] ||
           csg_leaf_is_translucent(&gatherer->scene->leaves[leaf]);
}

/* Whether all leaves of a subtree are of one node with that one. */
static bool is_of_node(const struct gatherer *gatherer, const struct csg_tree *tree, uint32_t i,
                       uint32_t leaf)
{
    for (uint32_t j = i; j < tree->data[i].end; j++)
        if (tree->data[j].op == CSG_LEAF &&
            !csg_is_same_node(gatherer->scene, leaf, tree->data[j].leaf))
            return false;
    return true;
}

/* Operands that are rings of one turned profile. */
struct rings {
    uint32_t num, num_fine;           /* leaves; those that float does not hold by themselves */
    uint32_t num_outer, num_inner;    /* frusta, and those that are taken from them */
    double lo, hi, largest, smallest; /* what is turned, along the axis and across it */
};

static void add_ring_leaf(struct rings *rings, const struct csg_leaf *leaf, bool is_inner,
                          double size)
{
    const struct csg_shape *shape = &leaf->shape;
    const double *radii = shape->radii;
    rings->num++;
    rings->num_fine += csg_wall_is_fine(leaf, size);
    rings->num_outer += !is_inner;
    rings->num_inner += is_inner;
    rings->lo = fmin(rings->lo, shape->bounds.lo.z);
    rings->hi = fmax(rings->hi, shape->bounds.hi.z);
    rings->largest = fmax(rings->largest, fmax(radii[0], radii[1]));
    if (is_inner)
        rings->smallest = fmin(rings->smallest, fmin(radii[0], radii[1]));
}

/* Whether the rings are far around the axis: each by itself is drawn in a rectangle that is empty
 * but for its border. */
static bool are_wide(const struct rings *rings, size_t num_leaves)
{
    const double across = rings->largest - rings->smallest + rings->hi - rings->lo;
    return rings->num_outer >= CSG_STACK_MIN_RINGS && rings->num_inner == rings->num_outer &&
           RING_PART * rings->num >= num_leaves && rings->largest > RING_WIDTHS * across;
}

/*
 * Whether the operands [begin, end), if they are rings of a turned profile, are one object. Those
 * that float would not hold each by itself cost as much in double as many of the bands that all of
 * them are together.
 */
static bool are_joined_rings(const struct gatherer *gatherer, const struct csg_tree *tree,
                             uint32_t begin, uint32_t end)
{
    const struct csg_leaf *leaves = gatherer->scene->leaves;
    struct rings rings = {.lo = INFINITY, .hi = -INFINITY, .smallest = INFINITY};
    struct csg_box box = csg_box_empty;
    for (uint32_t i = begin; i < end; i++)
        if (tree->data[i].op == CSG_LEAF && !tree->data[i].negated)
            box = csg_box_union(&box, &leaves[tree->data[i].leaf].box);
    const double size = csg_length(csg_sub(box.hi, box.lo));
    for (uint32_t i = begin; i < end; i++) {
        if (tree->data[i].op != CSG_LEAF)
            continue;
        const struct csg_leaf *leaf = &leaves[tree->data[i].leaf];
        if (!csg_stack_may_have(&leaf->shape))
            return false;
        add_ring_leaf(&rings, leaf, tree->data[i].negated, size);
    }
    return rings.num >= CSG_STACK_MIN_RINGS && (rings.num_fine > rings.num / RINGS_FOR_DOUBLE ||
                                                are_wide(&rings, gatherer->scene->num_leaves));
}

/* The operands from i on that are one node's. */
static uint32_t end_of_node(const struct gatherer *gatherer, const struct csg_tree *tree,
                            uint32_t i)
{
    const uint32_t leaf = first_leaf(tree, i);
    uint32_t end = tree->data[i].end;
    if (is_of_node(gatherer, tree, i, leaf))
        while (end < tree->num && is_of_node(gatherer, tree, end, leaf))
            end = tree->data[end].end;
    return end;
}

/* The end of the run of operands from i on that are gathered, or, *alone, each stay by themselves.
 */
static uint32_t end_of_run(const struct gatherer *gatherer, const struct csg_tree *tree, uint32_t i,
                           bool *alone)
{
    const uint32_t leaf = first_leaf(tree, i);
    const bool see_through = is_see_through(gatherer, leaf);
    const bool is_ring = csg_stack_may_have(&gatherer->scene->leaves[leaf].shape);
    const uint32_t end =
        see_through || is_ring ? end_of_node(gatherer, tree, i) : tree->data[i].end;
    *alone = end == tree->data[i].end || !(see_through || are_joined_rings(gatherer, tree, i, end));
    return end;
}

static bool open_union(struct csg_tree *tree, uint32_t end)
{
    const struct csg_node node = {.op = CSG_OR, .end = end};
    return csg_array_push(tree, node);
}

/* The outermost union anew, with a union in it for each run of more than one operand. */
static bool gather(struct gatherer *gatherer, const struct csg_tree *tree)
{
    struct csg_tree *to = &gatherer->to;
    bool ok = open_union(to, 0);
    for (uint32_t i = 1, end; i < tree->num && ok; i = end) {
        bool alone;
        end = end_of_run(gatherer, tree, i, &alone);
        ok = (alone || open_union(to, (uint32_t)to->num + 1 + end - i)) &&
             csg_tree_append(to, tree->data, i, end);
    }
    if (ok)
        to->data[0].end = (uint32_t)to->num;
    return ok;
}

static bool may_gather(const struct gatherer *gatherer, const struct csg_tree *tree)
{
    for (size_t i = 0; i < tree->num; i++)
        if (tree->data[i].op == CSG_LEAF &&
            (is_see_through(gatherer, tree->data[i].leaf) ||
             csg_stack_may_have(&gatherer->scene->leaves[tree->data[i].leaf].shape)))
            return true;
    return false;
}

static bool gather_layer(struct gatherer *gatherer, struct csg_tree *tree)
{
    if (tree->num == 0 || tree->data[0].op != CSG_OR || !may_gather(gatherer, tree))
        return true;
    gatherer->to = (struct csg_tree){0};
    const bool ok = gather(gatherer, tree);
    if (ok && gatherer->to.num > tree->num) {
        const struct csg_tree old = *tree;
        *tree = gatherer->to;
        gatherer->to = old;
    }
    free(gatherer->to.data);
    return ok;
}

bool csg_gather_nodes(struct csgcast_scene *scene)
{
    const struct csg_tree *highlight = &scene->trees[CSG_LAYER_HIGHLIGHT];
    struct gatherer gatherer = {.scene = scene, .highlighted = calloc(scene->num_leaves + 1, 1)};
    bool ok = gatherer.highlighted != NULL;
    for (size_t i = 0; i < highlight->num && ok; i++)
        if (highlight->data[i].op == CSG_LEAF)
            gatherer.highlighted[highlight->data[i].leaf] = 1;
    for (; gatherer.layer < CSG_NUM_LAYERS && ok; gatherer.layer++)
        ok = gather_layer(&gatherer, &scene->trees[gatherer.layer]);
    free(gatherer.highlighted);
    return ok;
}
