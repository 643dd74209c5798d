/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_NODES_H
#define CSG_SCENE_NODES_H

/*
 * The nodes of a scene text that are no solids. A new node is one row in the table of nodes.c: its
 * role in the Boolean tree, and what it does to the space of its children.
 */

#include "common/linear.h"
#include "solids/value.h"

enum csg_role {
    CSG_ROLE_SOLID, /* a kind of csg_solids */
    CSG_ROLE_UNION,
    CSG_ROLE_DIFFERENCE,
    CSG_ROLE_INTERSECTION,
    CSG_ROLE_UNSUPPORTED, /* OpenSCAD has it, this version does not */
    CSG_ROLE_UNKNOWN,
};

/* What a node's children inherit. */
struct csg_space {
    struct csg_map map; /* to the world */
    /* Bounds the error of each entry of map that comes from numbers rounded in the file, counting
     * only matrices below a Boolean: a common map of all its operands moves them alike. */
    double error[3][4];
    bool in_boolean; /* below a difference or intersection of several operands */
    bool is_empty;   /* the map collapses or destroys what is in it */
    float color[4];
    bool has_color; /* color is one that inner colours cannot replace */
};

struct csg_node_ops {
    const char *name;
    enum csg_role role;
    const char *parameters; /* in positional order, see csg_args; NULL: none */
    /* Changes the space of the children. false: a message was given. NULL: nothing to change. */
    bool (*enter)(const struct csg_args *args, struct csg_space *space);
};

extern const struct csg_space csg_space_world;

/* The row with that name; NULL when there is none. */
const struct csg_node_ops *csg_node_find(const char *name, size_t length);

/* The name of a node or solid that looks most like this one; NULL when none does. */
const char *csg_node_suggest(const char *name, size_t length);

#endif
