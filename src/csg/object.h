/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_OBJECT_H
#define CSG_CSG_OBJECT_H

/* Objects: the operands of the outermost union. Each is drawn by itself; the depth buffer unites.
 */

#include "csg/scene.h"

struct csg_object {
    uint8_t layer;       /* enum csg_layer */
    uint8_t paint;       /* the layer whose colours it takes: HIGHLIGHT where # is on all of it */
    bool hidden;         /* of the highlight layer, and drawn already as part of such an object */
    uint32_t begin, end; /* nodes of scene->trees[layer] */
    struct csg_box box;  /* of the Boolean result, conservative */
};

struct csg_objects {
    struct csg_object *data;
    size_t num, capacity;
};

/*
 * Splits the simplified trees. An object whose solids, but for subtracted ones, are all under # is
 * painted as a highlight and hides its copies in that layer, as OpenSCAD's preview has it, but
 * where that would be all objects.
 * false: out of memory.
 */
bool csg_objects_split(const struct csgcast_scene *scene, struct csg_objects *objects);

/* The object's first solid that is not subtracted: what its cuts were made in; NULL: none. */
const struct csg_leaf *csg_object_minuend(const struct csgcast_scene *scene,
                                          const struct csg_object *object);

/* Whether the object is one node, such as an extrusion, or in one render(): OpenSCAD's preview has
 * a mesh of it, not a product of solids. */
bool csg_object_is_one_node(const struct csgcast_scene *scene, const struct csg_object *object);

/* The box of one leaf in world space. */
static inline struct csg_box csg_leaf_box(const struct csg_leaf *leaf)
{
    return leaf->box;
}

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

size_t csg_count_operands(const struct csg_tree *tree);

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
