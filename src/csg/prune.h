/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_PRUNE_H
#define CSG_CSG_PRUNE_H

/* What boxes show of trees. */

#include "csg/scene.h"

/*
 * Conservative boxes of every node's set: a union's box holds its operands' boxes, an
 * intersection's is their common part, a complement has no bounds. boxes has tree->num entries.
 */
void csg_tree_boxes(const struct csgcast_scene *scene, const struct csg_tree *tree,
                    struct csg_box *boxes);

struct csg_boxes {
    struct csg_box *data;
    size_t num, capacity;
};

/* The same of an operand of the outermost union alone. room: zeroed before the first of them; has
 * the boxes of its nodes, where it is no leaf. false: out of memory. */
bool csg_operand_box(const struct csgcast_scene *scene, const struct csg_tree *tree,
                     uint32_t operand, struct csg_boxes *room, struct csg_box *box);

/* Leaves out of the tree what boxes show to be irrelevant: operands of an intersection that miss
 * it, subtrahends outside of their minuend. false: out of memory. */
bool csg_tree_prune(const struct csgcast_scene *scene, struct csg_tree *tree);

/* Whether nothing of the nodes at [begin, end) lets others show through. */
bool csg_nodes_are_opaque(const struct csgcast_scene *scene, const struct csg_node *nodes,
                          uint32_t begin, uint32_t end);

/* Objects of at most this many nodes keep their structure in scenes that are edited: those that
 * straight-line code is made for (CSG_STRAIGHT_MAX_STEPS). */
#define CSG_KEPT_MAX_NODES 24

/* Whether an operand of the outermost union is one of these, as far as its own nodes tell: small,
 * and nothing of it translucent. */
bool csg_nodes_may_stay(const struct csgcast_scene *scene, const struct csg_node *nodes,
                        uint32_t begin, uint32_t end);

/*
 * For a scene that is edited: what prune made of the model's tree is pruned; small objects of tree
 * keep the leaves that went, as spare ones, so that no edit changes their programs. But not those
 * that are translucent or under # in part: what is pruned may be several objects, which are blended
 * one by one. false: out of memory.
 */
bool csg_tree_keep_structure(const struct csgcast_scene *scene, struct csg_tree *tree,
                             const struct csg_tree *pruned);

#endif
