/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_WALK_H
#define CSG_NODES_WALK_H

/* The walk over the nodes that makes the leaves: what it hands to those that read single nodes. */

#include "nodes/build.h"

/* A resize() whose children are being read, and what it does to them. */
struct csg_resized {
    uint32_t node;
    struct csg_map map;
    const struct csg_resized *outer;
};

struct csg_walk {
    struct csg_builder *builder;
    struct csg_arguments arguments;    /* of the node at hand */
    int depth;                         /* of compounds inside of compounds */
    const struct csg_resized *resized; /* the innermost one; NULL: none */
    bool is_operand;     /* another compound works on what is read, and wants convex pieces of it */
    bool points_only;    /* of what is read only the points matter, as for a hull */
    bool is_see_through; /* what is read shows what is behind it: %, #, a translucent colour */
    bool was_placed;     /* something read since this was false depends on what is around it */
};

static inline const struct csg_parsed_node *csg_walk_node(const struct csg_walk *walk,
                                                          uint32_t node)
{
    return &walk->builder->document->nodes.data[node];
}

/* The row of a node's name in the table of nodes; NULL when there is none. */
const struct csg_node_ops *csg_walk_ops(const struct csg_walk *walk, uint32_t node);

/* false, with the message. */
static inline bool csg_walk_no_memory(const struct csg_walk *walk)
{
    return csg_log_memory(&walk->builder->report->log);
}

/* The arguments of a node, valid until the next call. false, with a message, when memory is out. */
bool csg_walk_args(struct csg_walk *walk, uint32_t node, const char *name, const char *parameters,
                   struct csg_args *args);

/* A warning for each argument that the node does not have. */
void csg_warn_of_strange_names(const struct csg_args *args);

/* Says that the node, which has that name, uses what this version lacks: an error, or a warning
 * with --skip-unsupported. The node is then left out. */
void csg_walk_unsupported(struct csg_walk *walk, uint32_t node, const char *format, ...)
    CSG_PRINTF(3, 4);

/* The same of what openscad could not make either: it is not asked. */
void csg_walk_refuse(struct csg_walk *walk, uint32_t node, const char *format, ...)
    CSG_PRINTF(3, 4);

/* "file:line:column: node: text" */
void csg_walk_warning(struct csg_walk *walk, uint32_t node, const char *format, ...)
    CSG_PRINTF(3, 4);
/* The convex pieces that an extruded polygon may be made of, see plane/extrude.h. */
size_t csg_walk_max_pieces(const struct csg_walk *walk, bool in_boolean);

/* From a node's own space into that space, its rounding as well. false: nothing is left there. */
bool csg_space_place(const struct csg_space *space, struct csg_shape *shape);

/* Whether the node is a difference or intersection that has something to do. */
bool csg_walk_is_boolean(const struct csg_walk *walk, uint32_t node);

#endif
