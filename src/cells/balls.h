/* SPDX-License-Identifier: MIT */
#ifndef CSG_CELLS_BALLS_H
#define CSG_CELLS_BALLS_H

/*
 * Balls that overlap: of many that are intersected few bound what is left of them, but boxes tell
 * that late, as the surfaces of all of them pass through it. In a box a ball of an intersection
 * does not matter where it holds all that another one has there, nor one that is subtracted where
 * another one of these holds it.
 */

#include "cells/leaf.h"

/* Leaves out of an intersection of literals the balls that do not matter in the box, by margin: how
 * near to each other surfaces may be that both stay. */
void csg_balls_drop(const struct csg_cell_leaf *leaves, struct csg_tree *tree,
                    const struct csg_box *box, double margin);

#endif
