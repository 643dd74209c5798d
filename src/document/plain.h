/* SPDX-License-Identifier: MIT */
#ifndef CSG_DOCUMENT_PLAIN_H
#define CSG_DOCUMENT_PLAIN_H

#include "document/lexer.h"

/*
 * Steps over the arguments of a node where these are plain: numbers, constants, vectors and names,
 * as nearly all are, without comments and strings. They are read when they are needed; until then
 * only whether they are well formed matters. On entry the lexer is just behind the node's name, in
 * the end behind the ')', with lines and rounded numbers counted as csg_arguments_read does. false:
 * they are not plain, or malformed, and nothing has happened.
 */
bool csg_plain_skip(struct csg_lexer *lexer);

#endif
