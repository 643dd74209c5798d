/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_EDIT_H
#define CSG_CARRIER_EDIT_H

/*
 * Carriers after an edit. Only faces of leaves that have changed, come or gone, and those that lie
 * on carriers which that can concern, get their carriers anew: a face's carrier depends on the
 * faces before it (csg_rank) that it may coincide with, and on nothing else.
 */

#include "carrier/carrier.h"

/* What an edit starts from. */
struct csg_before {
    const struct csgcast_scene *scene;     /* with its leaves as they are now */
    const uint32_t *changed;               /* by leaf: 0, or the place + 1 of its shape in shapes */
    const struct csg_shape *const *shapes; /* as they were */
    const uint32_t *leaves;                /* that have changed, one for each shape */
    size_t num;
    const struct csg_tree *trees; /* by layer: simplified, but for what boxes show */
    /* Where the objects are those that were there (prepare/follow.h), the box of all; else NULL. */
    const struct csg_box *box;
};

/*
 * The carriers of the scene, whose leaves and objects are those after the edit: the same as
 * csg_carriers_create makes, but for carriers' numbers. What was kept goes to them; where that does
 * not do they are created, or, with before->box, left to be. NULL: out of memory, or left.
 */
struct csg_carriers *csg_carriers_edit(const struct csgcast_scene *scene,
                                       const struct csg_before *before);

#endif
