/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_STACK_H
#define CSG_CSG_STACK_H

/*
 * Stacks: what a turned profile (plane/revolve.h) is cut into, rings about one axis, each a frustum
 * without another one between two levels. As leaves of a tree they are many, all over each other on
 * the screen; their faces together are one surface of which a ray meets a few.
 */

#include "csg/object.h"

/* Fewer rings stay as they are. */
#define CSG_STACK_MIN_RINGS 6

#define CSG_NO_LEAF UINT32_MAX

struct csg_ring {
    uint32_t outer, inner; /* leaves; inner may be CSG_NO_LEAF */
};

struct csg_stack {
    uint32_t first_ring, num_rings; /* from below, and, within one level, from the axis */
    bool negated;
};

/* Zero-initialise it. */
struct csg_stacks {
    CSG_ARRAY(struct csg_stack) list;
    CSG_ARRAY(struct csg_ring) rings;
    struct csg_tree tree; /* the object's, from 0, in which a stack is one leaf: the scene's number
                           * of leaves and its place in list; empty where there is no stack */
};

/* Whether it is a frustum of a ring. */
bool csg_stack_may_have(const struct csg_shape *shape);

/* How many leaves a tree with stacks can have. */
static inline size_t csg_stacks_room(size_t num_leaves)
{
    return num_leaves + num_leaves / CSG_STACK_MIN_RINGS + 1;
}

/* Replaces stacks by those of an object. false: out of memory. */
bool csg_stacks_find(struct csg_stacks *stacks, const struct csgcast_scene *scene,
                     const struct csg_object *object);
void csg_stacks_finish(struct csg_stacks *stacks);

#endif
