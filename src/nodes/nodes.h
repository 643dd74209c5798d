/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_NODES_H
#define CSG_NODES_NODES_H

/*
 * The nodes of a scene text that are no single solids. A new node is one row in the table of
 * nodes.c: its role in the Boolean tree, and what it does to its children.
 */

#include "common/linear.h"
#include "solids/solid.h"

enum csg_role {
    CSG_ROLE_SOLID,    /* a kind of csg_solids */
    CSG_ROLE_FIGURE,   /* two-dimensional: square, circle, polygon */
    CSG_ROLE_FLATTEN,  /* two-dimensional: makes a new drawing of the one in it */
    CSG_ROLE_COMPOUND, /* becomes several shapes; what is in it is read with it */
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
    bool is_marked;  /* below % or # */
    bool is_empty;   /* the map collapses or destroys what is in it */
    bool is_crowded; /* the text has CSG_EXTRUDE_CROWD extrusions or more */
    float color[4];
    bool has_color; /* color is one that inner colours cannot replace */
};

struct csg_drawing;
struct csg_part;
struct csg_walk;

/* Changes the space of the children. false: a message was given. */
typedef bool csg_enter_fn(const struct csg_args *args, struct csg_space *space);

/* Adds a figure to a drawing, or an empty union where it is empty. false, with a message, when
 * memory is out. */
typedef bool csg_figure_fn(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                           const struct csg_space *space, struct csg_drawing *drawing);

/* In a drawing: replaces the nodes from draw on, the union of what is in the node, by what the node
 * makes of it. false, with a message, when memory is out. */
typedef bool csg_flatten_fn(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                            struct csg_drawing *drawing, uint32_t draw);

/* Fills a part, several shapes under a Boolean tree, in the node's own space; what is empty or was
 * reported leaves it empty. in_boolean: see struct csg_space. false, with a message, when memory is
 * out. */
typedef bool csg_compound_fn(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                             bool in_boolean, struct csg_part *part);

struct csg_node_ops {
    const char *name;
    enum csg_role role;
    const char *parameters;    /* in positional order, see csg_args; NULL: none */
    uint8_t dimension;         /* 2 or 3; 0: that of what is in it */
    uint8_t wants;             /* 2 or 3: what must be in it; 0: of its own dimension */
    enum csg_kind kind;        /* COMPOUND: of its leaves */
    bool is_whole;             /* what is in it is of one colour, its cut faces too */
    bool shows_marks;          /* # and % directly in it show, though it becomes one mesh */
    csg_enter_fn *enter;       /* NULL: nothing to change */
    csg_figure_fn *figure;     /* FIGURE */
    csg_flatten_fn *flatten;   /* NULL: not in a drawing */
    csg_compound_fn *compound; /* COMPOUND */
};

extern const struct csg_space csg_space_world;

/* The row with that name; NULL when there is none. */
const struct csg_node_ops *csg_node_find(const char *name, size_t length);

/* The name of a node or solid that looks most like this one; NULL when none does. */
const char *csg_node_suggest(const char *name, size_t length);

#endif
