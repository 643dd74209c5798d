/* SPDX-License-Identifier: MIT */
#ifndef CSG_PREPARE_FOLLOWER_H
#define CSG_PREPARE_FOLLOWER_H

/* Where the leaves of an edited scene are. For follow.c. */

#include "carrier/edit.h"
#include "prepare/totals.h"

#define CSG_NOWHERE UINT32_MAX

struct csg_follower {
    bool can;          /* else each edit makes everything anew */
    uint32_t *objects; /* by leaf: the one that it is in */
    /* By leaf: the node of before->trees where its operand of the model begins. NOWHERE: it is in
     * none, or under % or #, and its edits cannot be followed. */
    uint32_t *operands;
    uint32_t *members; /* by object, of the crowd */
    uint8_t *marks;    /* by object, 0 between edits */
    struct csg_totals totals;
};

/* The scene's; made where there is none yet. NULL: out of memory. */
struct csg_follower *csg_follower_of(struct csgcast_scene *scene, const struct csg_before *before);

#endif
