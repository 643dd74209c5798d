/* SPDX-License-Identifier: MIT */
#include "csg/program.h"

#include <stdlib.h>

struct compiler {
    const struct csgcast_scene *scene;
    const struct csg_tree *tree;
    uint32_t begin;
    struct csg_program_room *room; /* needs from begin on */
    struct csg_program *program;
};

uint32_t csg_node_flags(const struct csgcast_scene *scene, const struct csg_node *node)
{
    if (node->leaf >= scene->num_leaves)
        return (node->negated ? CSG_RECORD_NEGATED : 0) | CSG_RECORD_SURFACE | CSG_RECORD_BANDS;
    const struct csg_shape *shape = &scene->leaves[node->leaf].shape;
    return (node->negated ? CSG_RECORD_NEGATED : 0) | (shape->surface ? CSG_RECORD_SURFACE : 0) |
           (shape->has_quadric ? CSG_RECORD_QUADRIC : 0) |
           (shape->has_quadric && !shape->convex ? CSG_RECORD_GAP : 0);
}

bool csg_node_is_product(const struct csgcast_scene *scene, const struct csg_tree *tree,
                         uint32_t node)
{
    const struct csg_node *nodes = tree->data;
    for (uint32_t child = node + 1; child < nodes[node].end; child++)
        if (nodes[child].op != CSG_LEAF || nodes[child].negated != (nodes[node].op == CSG_OR) ||
            (child > node + 1 && nodes[child].leaf <= nodes[child - 1].leaf) ||
            csg_node_flags(scene, &nodes[child]) & (CSG_RECORD_SURFACE | CSG_RECORD_GAP))
            return false;
    return node > 0 && nodes[node].op != CSG_LEAF;
}

static bool is_product(const struct compiler *compiler, uint32_t node)
{
    return compiler->room->products && csg_node_is_product(compiler->scene, compiler->tree, node);
}

static bool is_literal(const struct compiler *compiler, uint32_t node)
{
    return compiler->tree->data[node].op == CSG_LEAF || is_product(compiler, node);
}

static uint8_t need_of(const struct compiler *compiler, uint32_t node)
{
    return compiler->room->needs.data[node - compiler->begin];
}

static uint32_t deepest_child(const struct compiler *compiler, uint32_t node)
{
    const struct csg_node *nodes = compiler->tree->data;
    uint32_t deepest = node + 1;
    for (uint32_t child = node + 1; child < nodes[node].end; child = nodes[child].end)
        if (need_of(compiler, child) > need_of(compiler, deepest))
            deepest = child;
    return deepest;
}

static uint8_t stack_need(const struct compiler *compiler, uint32_t node)
{
    const struct csg_node *nodes = compiler->tree->data;
    if (is_literal(compiler, node) || nodes[node].end == node + 1)
        return 0;
    const uint32_t first = deepest_child(compiler, node);
    uint8_t need = need_of(compiler, first);
    for (uint32_t child = node + 1; child < nodes[node].end; child = nodes[child].end) {
        if (child == first || is_literal(compiler, child))
            continue;
        const uint8_t own = (uint8_t)(need_of(compiler, child) + 1);
        need = own > need ? own : need;
    }
    return need;
}

static bool push_task(const struct compiler *compiler, uint32_t node, uint32_t flags)
{
    return csg_array_push(&compiler->room->tasks, ((struct csg_program_task){node, flags}));
}

/* Tasks run last in, first out: the operand that comes first is pushed last. */
static bool expand(const struct compiler *compiler, struct csg_program_task task)
{
    const struct csg_node *nodes = compiler->tree->data;
    const uint32_t op = nodes[task.node].op == CSG_AND ? CSG_RECORD_AND : 0;
    const uint32_t first = deepest_child(compiler, task.node);
    for (uint32_t child = task.node + 1; child < nodes[task.node].end; child = nodes[child].end) {
        if (child == first)
            continue;
        if (is_literal(compiler, child)) {
            if (!push_task(compiler, child, op))
                return false;
        } else if (!push_task(compiler, child, op | CSG_RECORD_POP) ||
                   !push_task(compiler, child, CSG_RECORD_START | CSG_RECORD_PUSH)) {
            return false;
        }
    }
    return push_task(compiler, first, task.flags);
}

static bool emit_leaf(const struct compiler *compiler, struct csg_program_task task)
{
    const struct csg_node *node = &compiler->tree->data[task.node];
    const uint32_t flags = task.flags | csg_node_flags(compiler->scene, node);
    return csg_array_push(compiler->program, ((struct csg_step){node->leaf, flags}));
}

static bool emit_product(const struct compiler *compiler, struct csg_program_task task)
{
    const struct csg_node *nodes = compiler->tree->data;
    const uint32_t end = nodes[task.node].end;
    for (uint32_t child = task.node + 1; child < end; child++) {
        const uint32_t more = child + 1 < end ? CSG_RECORD_MORE : 0;
        if (!emit_leaf(compiler, (struct csg_program_task){child, task.flags | more}))
            return false;
        task.flags &= ~(uint32_t)CSG_RECORD_PUSH;
    }
    return true;
}

static bool run(const struct compiler *compiler)
{
    if (!push_task(compiler, compiler->begin, CSG_RECORD_START))
        return false;
    struct csg_program_room *room = compiler->room;
    while (room->tasks.num) {
        const struct csg_program_task task = room->tasks.data[--room->tasks.num];
        const struct csg_node *node = &compiler->tree->data[task.node];
        bool ok;
        if (task.flags & CSG_RECORD_POP)
            ok = csg_array_push(compiler->program, ((struct csg_step){0, task.flags}));
        else if (node->op == CSG_LEAF)
            ok = emit_leaf(compiler, task);
        else if (is_product(compiler, task.node))
            ok = emit_product(compiler, task);
        else
            ok = expand(compiler, task);
        if (!ok)
            return false;
    }
    return true;
}

bool csg_program_append(struct csg_program_room *room, struct csg_program *program,
                        const struct csgcast_scene *scene, const struct csg_tree *tree,
                        uint32_t begin)
{
    const uint32_t end = tree->data[begin].end;
    if (tree->data[begin].op == CSG_LEAF) {
        const uint32_t flags = CSG_RECORD_START | csg_node_flags(scene, &tree->data[begin]);
        return csg_array_push(program, ((struct csg_step){tree->data[begin].leaf, flags}));
    }
    /* All space has no surface to see, hence no steps. */
    if (end == begin + 1)
        return true;
    const struct compiler compiler = {scene, tree, begin, room, program};
    room->tasks.num = room->needs.num = 0;
    if (!csg_array_reserve(&room->needs, end - begin))
        return false;
    for (uint32_t node = end; node-- > begin;)
        room->needs.data[node - begin] = stack_need(&compiler, node);
    return run(&compiler);
}

void csg_program_room_finish(struct csg_program_room *room)
{
    free(room->needs.data);
    free(room->tasks.data);
}
