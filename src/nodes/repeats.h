/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_REPEATS_H
#define CSG_NODES_REPEATS_H

/*
 * Compounds with the same text become the same part: a file that calls a module many times has its
 * hulls as often. What was met once before is kept the second time, and copied from then on.
 */

#include "csg/part.h"
#include "nodes/walk.h"

struct csg_repeats;

/* NULL: out of memory. */
struct csg_repeats *csg_repeats_create(void);
void csg_repeats_destroy(struct csg_repeats *repeats);

/* As the compound of ops, the node's row, with its arguments. */
bool csg_repeats_read(struct csg_walk *walk, uint32_t node, const struct csg_node_ops *ops,
                      bool in_boolean, struct csg_part *part);

#endif
