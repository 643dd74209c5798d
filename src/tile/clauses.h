/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_CLAUSES_H
#define CSG_TILE_CLAUSES_H

/* What chains have to know of trees of clauses: see CSG_RECORD_CLAUSE. */

#include "csg/program.h"

/* Marks the steps of a tile's tree, where that is one of few literals in clauses. */
void csg_clauses_mark(struct csg_program *program, const struct csg_tree *tree);

#endif
