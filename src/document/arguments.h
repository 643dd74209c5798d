/* SPDX-License-Identifier: MIT */
#ifndef CSG_DOCUMENT_ARGUMENTS_H
#define CSG_DOCUMENT_ARGUMENTS_H

/* Argument lists: from tokens to values. One object reads one list after the other. */

#include "common/array.h"
#include "document/arena.h"
#include "document/lexer.h"
#include "solids/value.h"

enum csg_status {
    CSG_DONE,
    CSG_MALFORMED, /* a message was given */
    CSG_NO_MEMORY, /* likewise */
};

struct csg_open_vector {
    size_t first; /* of its items on the stack */
    struct csg_place place;
};

/* Zero-initialise it. */
struct csg_arguments {
    CSG_ARRAY(struct csg_arg) args;         /* of the list read last; valid until the next one */
    struct csg_arena arena;                 /* holds their names, strings and vectors */
    CSG_ARRAY(struct csg_value) stack;      /* complete values of the vectors still open */
    CSG_ARRAY(struct csg_open_vector) open; /* those vectors, the innermost last */
    struct csg_lexer behind;                /* just behind the ')' of the list read last */
};

void csg_arguments_finish(struct csg_arguments *arguments);

/*
 * Reads "(a = 1, [2, 3])" of a node. On entry token is the name of the node; on success it is the
 * token behind the ')', on failure the one that does not fit.
 */
enum csg_status csg_arguments_read(struct csg_arguments *arguments, struct csg_lexer *lexer,
                                   struct csg_token *token, struct csg_report *report);

/* Whether token is this mark. */
static inline bool csg_token_is(const struct csg_token *token, char mark)
{
    return token->mark == mark;
}

bool csg_token_is_name(const struct csg_token *token, const char *name);

#endif
