/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_TREE_H
#define CSG_CSG_TREE_H

/*
 * The Boolean tree: n-ary unions (OR) and intersections (AND) over literals, a literal being a
 * leaf or its complement. A difference a - b - c is AND(a, not b, not c): complements are pushed
 * to the leaves by De Morgan while the tree is built, which keeps its size.
 *
 * Nodes lie in pre-order; the children of node i are i + 1, nodes[i + 1].end, ... below
 * nodes[i].end. No walk over a tree recurses.
 */

#include <stdint.h>

#include "common/array.h"

enum csg_op { CSG_LEAF, CSG_OR, CSG_AND };

struct csg_node {
    uint8_t op;    /* enum csg_op */
    bool negated;  /* LEAF: the complement of the leaf */
    bool spare;    /* LEAF: stays for the tree's structure, and counts as nothing */
    uint32_t leaf; /* LEAF: index of the leaf; AND: of a part, see prepare/distribute.h, the minuend
                    * of the whole + 1, else 0 */
    uint32_t end;  /* one past the last node of this subtree */
};

/* No nodes: the empty set. OR without children is the empty set, AND without children all space. */
struct csg_tree {
    struct csg_node *data;
    size_t num, capacity;
};

/* What is known of a set. */
enum csg_known { CSG_VARIES, CSG_NOTHING, CSG_EVERYTHING };

/*
 * Replaces the tree by an equal one without constants, nodes of one child and nodes whose parent
 * has the same op. known[leaf], where known is not NULL, is the enum csg_known of each leaf; spare
 * ones stay all the same. false: out of memory.
 */
bool csg_tree_simplify(struct csg_tree *tree, const uint8_t *known);

/* What a subtree is once the constants below it are known. */
struct csg_fold {
    uint8_t constant; /* enum csg_known */
    bool single;      /* a Boolean node with one child that varies */
};

/* Nodes of a new tree that are still open, innermost last. */
struct csg_open_node {
    uint32_t index;   /* in the new tree */
    uint32_t old_end; /* in the old one */
};

/* Memory for many simplifications. Zero-initialise it. */
struct csg_tree_room {
    CSG_ARRAY(struct csg_fold) folds;
    CSG_ARRAY(struct csg_open_node) open;
    struct csg_tree tree; /* takes the new nodes, and then gets the old ones' memory */
};

bool csg_tree_simplify_in(struct csg_tree_room *room, struct csg_tree *tree, const uint8_t *known);

/* Leaves the tree as it is; the simpler one is the room's, until the next call. */
bool csg_tree_simplify_to(struct csg_tree_room *room, const struct csg_tree *tree,
                          const uint8_t *known);

void csg_tree_room_finish(struct csg_tree_room *room);

/* copy, zeroed before, becomes an equal tree. false: out of memory. */
bool csg_tree_copy(const struct csg_tree *tree, struct csg_tree *copy);

/* Appends a copy of whole subtrees, nodes [begin, end) of another tree. false: out of memory. */
bool csg_tree_append(struct csg_tree *tree, const struct csg_node *nodes, uint32_t begin,
                     uint32_t end);

/* The first operand of the outermost union; the next ones are at their ends, below tree->num. */
static inline uint32_t csg_tree_first_operand(const struct csg_tree *tree)
{
    return tree->num && tree->data[0].op == CSG_OR ? 1 : 0;
}

/* Whether two nodes are the same in subtrees that begin there, whether or not they are spare. */
static inline bool csg_node_is_same(const struct csg_node *a, uint32_t a_begin,
                                    const struct csg_node *b, uint32_t b_begin)
{
    return a->op == b->op && a->negated == b->negated && a->leaf == b->leaf &&
           a->end - a_begin == b->end - b_begin;
}

size_t csg_tree_count_leaves(const struct csg_tree *tree);

/* Of the outermost union. */
size_t csg_tree_count_operands(const struct csg_tree *tree);

/* Levels of Boolean nodes; 0 for one leaf. */
size_t csg_tree_depth(const struct csg_tree *tree, bool *out_of_memory);

#endif
