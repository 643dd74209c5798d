/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_MEMBERSHIP_H
#define CSG_PLANE_MEMBERSHIP_H

/*
 * Whether a point is in a drawing, kept up to date while the point steps over one edge after the
 * other: counters on the way to the root, as in Algorithm 4 of Ranta 2006, generalised to any tree.
 */

#include "plane/drawing.h"

struct csg_membership_node;

struct csg_membership {
    struct csg_membership_node *nodes; /* of the subtree */
    size_t num;
    uint32_t *node_of; /* by figure: its node in the subtree */
};

/* The point begins outside of all figures of the subtree at node. false: out of memory. */
bool csg_membership_init(struct csg_membership *membership, const struct csg_drawing *drawing,
                         uint32_t node);
void csg_membership_finish(struct csg_membership *membership);

/* The point steps to the right over an edge of that figure, whose contour comes down or goes up
 * there. */
void csg_membership_step(struct csg_membership *membership, uint32_t figure, bool is_down);

bool csg_membership_is_inside(const struct csg_membership *membership);

#endif
