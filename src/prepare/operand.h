/* SPDX-License-Identifier: MIT */
#ifndef CSG_PREPARE_OPERAND_H
#define CSG_PREPARE_OPERAND_H

/* One operand of the outermost union by itself, as an edit has to look at it again. */

#include "csg/object.h"
#include "csg/prune.h"

/* Memory for many. Zero-initialise it. */
struct csg_operand {
    struct csg_tree whole, pruned; /* ... and what csg_tree_prune makes of it */
    struct csg_boxes boxes;
};

void csg_operand_finish(struct csg_operand *operand);

/* Takes the operand at node begin of a tree that was simplified and not pruned. false: out of
 * memory. */
bool csg_operand_take(struct csg_operand *operand, const struct csgcast_scene *scene,
                      const struct csg_tree *tree, uint32_t begin);

/* A leaf of what is to be drawn of it; UINT32_MAX: it is nothing. */
uint32_t csg_operand_leaf(const struct csg_operand *operand, const struct csgcast_scene *scene);

/* Whether the object is what csg_scene_finish makes of the operand where structure is kept. */
bool csg_operand_is_object(const struct csg_operand *operand, const struct csgcast_scene *scene,
                           const struct csg_object *object);

#endif
