/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_COMPOUNDS_H
#define CSG_NODES_COMPOUNDS_H

/*
 * Nodes that become a part: several shapes under a Boolean tree. Each is the compound of a
 * csg_node_ops: it fills part in the node's own space; what is empty or was reported leaves it
 * empty. in_boolean: see struct csg_space. false, with a message, when memory is out.
 */

#include "csg/part.h"
#include "nodes/walk.h"

bool csg_compound_linear_extrude(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                                 bool in_boolean, struct csg_part *part);
bool csg_compound_rotate_extrude(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                                 bool in_boolean, struct csg_part *part);
bool csg_compound_polyhedron(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                             bool in_boolean, struct csg_part *part);
bool csg_compound_hull(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       bool in_boolean, struct csg_part *part);
bool csg_compound_minkowski(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                            bool in_boolean, struct csg_part *part);
bool csg_compound_resize(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                         bool in_boolean, struct csg_part *part);
bool csg_compound_import(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                         bool in_boolean, struct csg_part *part);
bool csg_compound_surface(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                          bool in_boolean, struct csg_part *part);
/* A drawing by itself, as a slab. */
bool csg_compound_slab(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       bool in_boolean, struct csg_part *part);

#endif
