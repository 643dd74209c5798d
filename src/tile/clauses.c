/* SPDX-License-Identifier: MIT */
#include "tile/clauses.h"

/* The literals in the order of their steps. */
struct literals {
    struct literal {
        struct csg_step *step;
        uint32_t clause; /* bits of literals */
    } data[CSG_CLAUSE_LITERALS];
    size_t num;
};

static bool list_literals(struct csg_program *program, struct literals *literals)
{
    for (size_t i = 0; i < program->num; i++) {
        if (program->data[i].flags & CSG_RECORD_POP)
            continue;
        if (literals->num == CSG_CLAUSE_LITERALS)
            return false;
        literals->data[literals->num++] = (struct literal){&program->data[i], 0};
    }
    return true;
}

static uint32_t bit_of(const struct literals *literals, uint32_t leaf)
{
    for (size_t i = 0; i < literals->num; i++)
        if (literals->data[i].step->leaf == leaf)
            return UINT32_C(1) << i;
    return 0;
}

/* The literals of one operand of the root; 0: they are no clause, or stand there already. */
static uint32_t clause_of(const struct literals *literals, const struct csg_tree *tree,
                          uint32_t node)
{
    uint32_t clause = 0;
    for (uint32_t i = node; i < tree->data[node].end; i++) {
        if (i == node && tree->data[i].op != CSG_LEAF)
            continue;
        const uint32_t bit =
            tree->data[i].op == CSG_LEAF ? bit_of(literals, tree->data[i].leaf) : 0;
        if (bit == 0 || clause & bit)
            return 0;
        clause |= bit;
    }
    return clause;
}

/* false: the tree is none of clauses, or has a leaf twice. */
static bool find_clauses(struct literals *literals, const struct csg_tree *tree)
{
    uint32_t all = 0;
    for (uint32_t child = 1; child < tree->num; child = tree->data[child].end) {
        const uint32_t clause = clause_of(literals, tree, child);
        if (clause == 0 || clause & all)
            return false;
        all |= clause;
        for (size_t i = 0; i < literals->num; i++)
            if (clause >> i & 1)
                literals->data[i].clause = clause;
    }
    return true;
}

static uint32_t order_of(const struct literals *literals, size_t i)
{
    uint32_t order = 0;
    for (size_t j = 0; j < literals->num; j++)
        order += csg_step_rank(literals->data[j].step) < csg_step_rank(literals->data[i].step);
    return order;
}

void csg_clauses_mark(struct csg_program *program, const struct csg_tree *tree)
{
    struct literals literals = {.num = 0};
    if (!list_literals(program, &literals) || !find_clauses(&literals, tree))
        return;
    uint32_t marks[CSG_CLAUSE_LITERALS];
    for (size_t i = 0; i < literals.num; i++)
        marks[i] = CSG_RECORD_CLAUSE * literals.data[i].clause +
                   CSG_RECORD_ORDER * order_of(&literals, i) +
                   (tree->data[0].op == CSG_AND ? 0 : CSG_RECORD_ANY);
    for (size_t i = 0; i < literals.num; i++)
        literals.data[i].step->flags |= marks[i];
}
