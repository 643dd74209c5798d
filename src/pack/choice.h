/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_CHOICE_H
#define CSG_PACK_CHOICE_H

/* Tiles or cells. */

#include "cells/cells.h"
#include "pack/terms.h"

/*
 * The cells in which an object is drawn in this frame; NULL where it is not: cells are for rays
 * that start outside of it, for keys in float, and for where tiles make too little of it. terms are
 * the object's; draw gets may_walk and bunched. Tiles that need more than *max_tests, tests of a
 * solid at a pixel, are dearer than cells, whatever samples of them told; where much of the object
 * is out of view they may need any. Cells ask for the terms of all the object. false: out of memory.
 */
bool csg_cells_choose(const struct csg_terms *terms, const struct csg_object *object,
                      const struct csg_rect *rect, struct csg_draw *draw,
                      const struct csg_cells **cells, size_t *max_tests);

/* For later frames: what all tiles of the object need, where samples told much less. */
void csg_cells_learn(const struct csg_terms *terms, const struct csg_rect *rect,
                     const struct csg_draw *draw, size_t tests);

/* The cells for an object whose tiles need more than max_tests. NULL: there are none. */
const struct csg_cells *csg_cells_instead(const struct csg_terms *terms,
                                          const struct csg_object *object,
                                          const struct csg_draw *draw);

#endif
