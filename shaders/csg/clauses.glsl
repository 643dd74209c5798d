/* SPDX-License-Identifier: MIT */
/*
 * A chain whose literals are in clauses: an intersection of unions of literals, or a union of
 * intersections, which is the complement of an intersection of unions of complements. It can begin
 * only where some literal does, so of those few keys the first one at which it holds is the answer.
 * The literals that hold are bits, in the order of the slots; src/shader/chain.c unrolls the rest.
 */

bool csg_clause_negated(vec3 head)
{
    return (int(head.x) & CSG_CHAIN_NEGATED) != 0;
}

/* The literals that are in one clause with that of head. */
int csg_clause_of(vec3 head)
{
    return int(head.x) / CSG_CHAIN_CLAUSE & ((1 << CSG_CLAUSE_LITERALS) - 1);
}

/* All literals where the clauses are intersections: what holds is then to be complemented. */
int csg_clause_flip(vec3 head)
{
    int any = CSG_RECORD_ANY / CSG_RECORD_CLAUSE * CSG_CHAIN_CLAUSE;
    return (int(head.x) & any) != 0 ? (1 << CSG_CLAUSE_LITERALS) - 1 : 0;
}

/* Smaller is preferred, of literals that change at once. */
int csg_clause_order(vec3 head)
{
    return int(head.x) / (CSG_RECORD_ORDER / CSG_RECORD_CLAUSE * CSG_CHAIN_CLAUSE) & 7;
}

/* The literal's bit where it holds just after k, and just before. */
int csg_clause_after(bool negated, csg_span span, float k, int bit)
{
    return (span.key.x <= k && k < span.key.y) != negated ? bit : 0;
}

int csg_clause_before(bool negated, csg_span span, float k, int bit)
{
    return (span.key.x < k && k <= span.key.y) != negated ? bit : 0;
}

/* Where the literal begins to hold. */
float csg_clause_begin(bool negated, csg_span span)
{
    return negated ? span.key.y : span.key.x;
}
