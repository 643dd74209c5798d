/* SPDX-License-Identifier: MIT */
#ifndef CSG_CELLS_LEAF_H
#define CSG_CELLS_LEAF_H

/*
 * What cells ask of leaves in box after box: one line of a cache each, where the leaf itself, its
 * carriers and their quadrics lie far apart.
 */

#include "csg/object.h"

struct csg_cell_leaf {
    struct csg_box box;
    double radius; /* of a ball, whose center is that of the box; else 0 */
    bool is_box;   /* it is all of its box */
};

/* By leaf of the scene; those of the object are filled in. NULL: out of memory. */
struct csg_cell_leaf *csg_cell_leaves_create(const struct csgcast_scene *scene,
                                             const struct csg_object *object);

/* What is known of a leaf's set in the box, as csg_side_of_leaf has it. */
uint8_t csg_cell_leaf_side(const struct csgcast_scene *scene, const struct csg_cell_leaf *leaves,
                           uint32_t leaf, const struct csg_box *box);

/* Whether its quadric may pass through the box, as csg_side_quadric_varies has it. */
bool csg_cell_leaf_quadric_varies(const struct csgcast_scene *scene,
                                  const struct csg_cell_leaf *leaves, uint32_t leaf,
                                  const struct csg_box *box);

#endif
