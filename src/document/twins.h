/* SPDX-License-Identifier: MIT */
#ifndef CSG_DOCUMENT_TWINS_H
#define CSG_DOCUMENT_TWINS_H

/*
 * Twins: nodes with the same name and arguments, byte for byte, and those are long. A mesh that a
 * model has a thousand times stands a thousand times in its text; what was read of one of them is
 * known of the others.
 */

#include "common/array.h"
#include "document/lexer.h"

/* A node that was read. */
struct csg_twin {
    size_t at, length; /* from its name to the ')' */
    uint32_t node;
    uint32_t num_lines; /* that end within */
    size_t line_begin;  /* of the last one of these, counted from at */
    size_t num_rounded; /* numbers in it that may be rounded */
    uint32_t before;    /* the one before with the same beginning; UINT32_MAX: none */
};

/* Zero-initialise it. */
struct csg_twins {
    CSG_ARRAY(struct csg_twin) all;
    CSG_ARRAY(uint32_t) last; /* by hash of the beginning: place in all + 1; 0: none */
};

void csg_twins_finish(struct csg_twins *twins);

/* What was read and stands at byte at as well; NULL: nothing is known to. */
const struct csg_twin *csg_twins_find(const struct csg_twins *twins, const struct csg_lexer *lexer,
                                      size_t at);

/* Whether a node's arguments are long enough. */
bool csg_twins_want(size_t length);

/* Adds a node, whose twin it is itself. false: out of memory. */
bool csg_twins_add(struct csg_twins *twins, const struct csg_lexer *lexer,
                   const struct csg_twin *twin);

#endif
