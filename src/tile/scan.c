/* SPDX-License-Identifier: MIT */
#include "tile/scan.h"

#include <stdlib.h>

/* A bound costs a record: one for so many operands, and none for a few. */
#define OPERANDS_PER_BOUND 3
#define MIN_OPERANDS 6

void csg_scan_finish(struct csg_scan *scan)
{
    free(scan->program.data);
    csg_program_room_finish(&scan->room);
    free(scan->bounds.data);
    free(scan->starts.data);
    free(scan->operands.data);
}

/* Before its start a node's set holds everything: a complement until its solid begins. */
static double start_of(const struct csg_scan *scan, const struct csg_terms *terms,
                       const struct csg_tree *tree, const struct csg_leaf_range *ranges, uint32_t i)
{
    const struct csg_node *node = &tree->data[i];
    if (node->op == CSG_LEAF)
        return node->negated ? ranges[terms->index[node->leaf]].entry.lo : -INFINITY;
    const bool all = node->op == CSG_AND;
    double start = all ? INFINITY : -INFINITY;
    for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end) {
        const double own = scan->starts.data[child];
        start = all ? csg_smaller(start, own) : csg_larger(start, own);
    }
    return start;
}

/* The start, then the place in the tree: the same order everywhere. */
static int compare_operands(const void *a, const void *b)
{
    const struct csg_scan_operand *x = a, *y = b;
    if (x->start != y->start)
        return x->start < y->start ? -1 : 1;
    return x->node < y->node ? -1 : x->node > y->node;
}

/* csg_choose's order: solids before complements, then the order of the file. Chains of leaves ask
 * for it. */
static double rank_of(const struct csg_node *node)
{
    return (double)node->leaf + (node->negated ? 0x1p32 : 0);
}

/* A few, as nearly always: without a call of qsort's for each comparison. */
static void sort_few(struct csg_scan *scan)
{
    struct csg_scan_operand *operands = scan->operands.data;
    for (size_t i = 1; i < scan->operands.num; i++) {
        const struct csg_scan_operand operand = operands[i];
        size_t j = i;
        for (; j > 0 && compare_operands(&operand, &operands[j - 1]) < 0; j--)
            operands[j] = operands[j - 1];
        operands[j] = operand;
    }
}

/* The operands of the outermost intersection, in their order. */
static bool list_operands(struct csg_scan *scan, const struct csg_tree *tree, bool *only_leaves)
{
    scan->operands.num = 0;
    *only_leaves = true;
    for (uint32_t child = 1; child < tree->num; child = tree->data[child].end) {
        const struct csg_scan_operand operand = {rank_of(&tree->data[child]), child};
        *only_leaves &= tree->data[child].op == CSG_LEAF;
        if (!csg_array_push(&scan->operands, operand))
            return false;
    }
    return true;
}

static bool sort_by_start(struct csg_scan *scan, const struct csg_terms *terms,
                          const struct csg_tree *tree, const struct csg_leaf_range *ranges)
{
    scan->starts.num = 0;
    if (!csg_array_reserve(&scan->starts, tree->num))
        return false;
    for (size_t i = tree->num; i-- > 0;)
        scan->starts.data[i] = start_of(scan, terms, tree, ranges, (uint32_t)i);
    for (size_t i = 0; i < scan->operands.num; i++)
        scan->operands.data[i].start = scan->starts.data[scan->operands.data[i].node];
    qsort(scan->operands.data, scan->operands.num, sizeof *scan->operands.data, compare_operands);
    return true;
}

static bool add_step(struct csg_scan *scan, uint32_t flags, double bound)
{
    const size_t at = scan->program.num;
    if (!csg_array_push(&scan->program, ((struct csg_step){0, flags})) ||
        !csg_array_reserve(&scan->bounds, at + 1 - scan->bounds.num))
        return false;
    scan->bounds.data[at] = bound;
    scan->bounds.num = at + 1;
    return true;
}

/* The flags of a leaf's step, as csg_node_flags: what this asks of the scene the terms know. */
static uint32_t leaf_flags(const struct csg_terms *terms, const struct csg_node *node)
{
    const uint32_t flags = csg_terms_of(terms, node->leaf)->flags & ~(uint32_t)CSG_RECORD_NEGATED;
    return flags | (node->negated ? CSG_RECORD_NEGATED : 0);
}

/* One operand of the outermost intersection, or a tree that is one leaf, behind what is there. */
static bool add_operand(struct csg_scan *scan, const struct csg_terms *terms,
                        const struct csg_tree *tree, uint32_t i)
{
    const struct csg_node *node = &tree->data[i];
    const size_t first = scan->program.num;
    if (node->op == CSG_LEAF) {
        const uint32_t place = first == 0 ? CSG_RECORD_START : CSG_RECORD_AND;
        const struct csg_step step = {node->leaf, place | leaf_flags(terms, node)};
        return csg_array_push(&scan->program, step);
    }
    if (!csg_program_append(&scan->room, &scan->program, terms->scene, tree, i))
        return false;
    if (first == 0)
        return true;
    struct csg_step *steps = scan->program.data;
    if (csg_node_is_product(terms->scene, tree, i)) {
        for (size_t j = first; j < scan->program.num; j++)
            steps[j].flags = (steps[j].flags & ~(uint32_t)CSG_RECORD_START) | CSG_RECORD_AND;
        return true;
    }
    steps[first].flags |= CSG_RECORD_PUSH;
    return add_step(scan, CSG_RECORD_POP | CSG_RECORD_AND, 0);
}

static bool add_operands(struct csg_scan *scan, const struct csg_terms *terms,
                         const struct csg_tree *tree, bool bounded)
{
    double bound = -INFINITY;
    size_t last = 1;
    for (size_t i = 0; i < scan->operands.num; i++) {
        const struct csg_scan_operand *operand = &scan->operands.data[i];
        if (bounded && i >= last + OPERANDS_PER_BOUND - 1 && operand->start > bound) {
            bound = operand->start;
            last = i;
            if (!add_step(scan, CSG_RECORD_BOUND, bound))
                return false;
        }
        if (!add_operand(scan, terms, tree, operand->node))
            return false;
    }
    return true;
}

bool csg_scan_fill(struct csg_scan *scan, const struct csg_terms *terms,
                   const struct csg_tree *tree, const struct csg_leaf_range *ranges, bool bounded)
{
    bool only_leaves;
    scan->room.products = true;
    scan->program.num = scan->bounds.num = 0;
    if (tree->data[0].op == CSG_LEAF)
        return add_operand(scan, terms, tree, 0);
    if (!bounded || tree->data[0].op != CSG_AND)
        return csg_program_append(&scan->room, &scan->program, terms->scene, tree, 0);
    if (!list_operands(scan, tree, &only_leaves))
        return false;
    if (scan->operands.num >= MIN_OPERANDS)
        return sort_by_start(scan, terms, tree, ranges) && add_operands(scan, terms, tree, true);
    if (!only_leaves)
        return csg_program_append(&scan->room, &scan->program, terms->scene, tree, 0);
    sort_few(scan);
    return add_operands(scan, terms, tree, false);
}
