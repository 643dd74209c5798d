/* SPDX-License-Identifier: MIT */
#include "csg/stack.h"

#include <stdlib.h>
#include <string.h>

bool csg_stack_may_have(const struct csg_shape *shape)
{
    return (shape->radii[0] > 0 || shape->radii[1] > 0) && shape->num_planes == 2;
}

struct finder {
    const struct csgcast_scene *scene;
    const struct csg_node *nodes; /* of the object */
    uint32_t num, base;           /* base: what ends count from */
    struct csg_stacks *stacks;
    CSG_ARRAY(uint32_t) open; /* nodes of the new tree that wait for their end, */
    CSG_ARRAY(uint32_t) ends; /* ... and that in the old one */
};

static uint32_t end_of(const struct finder *finder, uint32_t i)
{
    return finder->nodes[i].end - finder->base;
}

static const struct csg_shape *shape_of(const struct finder *finder, uint32_t leaf)
{
    return &finder->scene->leaves[leaf].shape;
}

static bool is_frustum(const struct finder *finder, uint32_t i, bool negated)
{
    const struct csg_node *node = &finder->nodes[i];
    if (node->op != CSG_LEAF || node->spare || node->negated != negated)
        return false;
    return csg_stack_may_have(shape_of(finder, node->leaf));
}

static bool is_same_turn(const struct finder *finder, uint32_t a, uint32_t b)
{
    const struct csg_leaf *x = &finder->scene->leaves[a], *y = &finder->scene->leaves[b];
    return x->line == y->line && x->column == y->column &&
           memcmp(&x->shape.frame, &y->shape.frame, sizeof x->shape.frame) == 0;
}

/* The two have the same levels. */
static bool is_level(const struct finder *finder, uint32_t a, uint32_t b)
{
    const struct csg_box *x = &shape_of(finder, a)->bounds, *y = &shape_of(finder, b)->bounds;
    return x->lo.z == y->lo.z && x->hi.z == y->hi.z;
}

/* Whether operand i of a node is a ring: of a union a frustum less another one, or the complement
 * of that, of an intersection. */
static bool find_ring(const struct finder *finder, uint32_t i, uint8_t op, struct csg_ring *ring)
{
    const struct csg_node *node = &finder->nodes[i];
    const bool negated = op == CSG_AND;
    *ring = (struct csg_ring){node->leaf, CSG_NO_LEAF};
    if (is_frustum(finder, i, negated))
        return true;
    if (node->op == CSG_LEAF || node->op == op || end_of(finder, i) != i + 3 ||
        !is_frustum(finder, i + 1, negated) || !is_frustum(finder, i + 2, !negated))
        return false;
    *ring = (struct csg_ring){finder->nodes[i + 1].leaf, finder->nodes[i + 2].leaf};
    return is_same_turn(finder, ring->outer, ring->inner) &&
           is_level(finder, ring->outer, ring->inner);
}

/* Takes the run of rings that begins at operand i of a node that ends at end; where it becomes a
 * stack, *next is what follows it. */
static bool find_run(struct finder *finder, uint32_t i, uint32_t end, uint8_t op, uint32_t *next)
{
    struct csg_stacks *stacks = finder->stacks;
    const uint32_t first = (uint32_t)stacks->rings.num;
    struct csg_ring ring;
    for (*next = i; *next < end && find_ring(finder, *next, op, &ring);
         *next = end_of(finder, *next)) {
        if (stacks->rings.num > first &&
            !is_same_turn(finder, ring.outer, stacks->rings.data[first].outer))
            break;
        if (!csg_array_push(&stacks->rings, ring))
            return false;
    }
    const uint32_t num = (uint32_t)stacks->rings.num - first;
    if (num >= CSG_STACK_MIN_RINGS)
        return csg_array_push(&stacks->list, ((struct csg_stack){first, num, op == CSG_AND}));
    stacks->rings.num = first;
    *next = i;
    return true;
}

static bool add_node(struct finder *finder, const struct csg_node *node)
{
    struct csg_node copy = *node;
    copy.end = (uint32_t)finder->stacks->tree.num + 1;
    return csg_array_push(&finder->stacks->tree, copy);
}

static void close_nodes(struct finder *finder, uint32_t i)
{
    struct csg_tree *tree = &finder->stacks->tree;
    while (finder->ends.num && finder->ends.data[finder->ends.num - 1] <= i) {
        finder->ends.num--;
        tree->data[finder->open.data[--finder->open.num]].end = (uint32_t)tree->num;
    }
}

/* Adds the node, or the stack that begins there; *next: what comes next. */
static bool visit(struct finder *finder, uint32_t i, uint32_t *next)
{
    const struct csg_node *node = &finder->nodes[i];
    const size_t num_stacks = finder->stacks->list.num;
    *next = i;
    if (finder->open.num) {
        const uint8_t op = finder->stacks->tree.data[finder->open.data[finder->open.num - 1]].op;
        if (!find_run(finder, i, finder->ends.data[finder->ends.num - 1], op, next))
            return false;
    }
    if (finder->stacks->list.num > num_stacks) {
        const struct csg_node stack = {.op = CSG_LEAF,
                                       .negated = finder->stacks->list.data[num_stacks].negated,
                                       .leaf = (uint32_t)(finder->scene->num_leaves + num_stacks)};
        return add_node(finder, &stack);
    }
    *next = i + 1;
    const uint32_t index = (uint32_t)finder->stacks->tree.num;
    return add_node(finder, node) &&
           (node->op == CSG_LEAF || (csg_array_push(&finder->open, index) &&
                                     csg_array_push(&finder->ends, end_of(finder, i))));
}

bool csg_stacks_find(struct csg_stacks *stacks, const struct csgcast_scene *scene,
                     const struct csg_object *object)
{
    struct finder finder = {.scene = scene,
                            .nodes = scene->trees[object->layer].data + object->begin,
                            .num = object->end - object->begin,
                            .base = object->begin,
                            .stacks = stacks};
    bool ok = true;
    stacks->list.num = stacks->rings.num = stacks->tree.num = 0;
    if (finder.num <= CSG_STACK_MIN_RINGS)
        return true;
    for (uint32_t i = 0; i < finder.num && ok;) {
        close_nodes(&finder, i);
        ok = visit(&finder, i, &i);
    }
    close_nodes(&finder, finder.num);
    if (stacks->list.num == 0)
        stacks->tree.num = 0;
    free(finder.open.data);
    free(finder.ends.data);
    return ok;
}

void csg_stacks_finish(struct csg_stacks *stacks)
{
    free(stacks->list.data);
    free(stacks->rings.data);
    free(stacks->tree.data);
    *stacks = (struct csg_stacks){0};
}
