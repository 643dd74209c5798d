/* SPDX-License-Identifier: MIT */
#ifndef CSG_CELLS_STORE_H
#define CSG_CELLS_STORE_H

/* The cells of a scene's objects, made when frames have asked for them. */

#include "cells/cells.h"

struct csg_cells_store;

/* NULL: out of memory. */
struct csg_cells_store *csg_cells_store_create(const struct csgcast_scene *scene);
void csg_cells_store_destroy(struct csg_cells_store *store);

/* What an edit leaves as it was is taken from the store before it, and the answers of samples, by
 * objects of the same number. */
void csg_cells_store_inherit(struct csg_cells_store *store, struct csg_cells_store *before);

/* An edit has changed the object: of its cells what that leaves as it was is kept. */
void csg_cells_store_renew(struct csg_cells_store *store, uint32_t object);

/*
 * An object's cells for a frame, in which they spare so many tests of a solid at a pixel. They are
 * made as soon as the frames since the scene was loaded or edited would have been spared more than
 * the making costs, so a single picture gets them only where they pay at once. May be called by
 * several threads. NULL: the object has none, for whatever reason.
 */
const struct csg_cells *csg_cells_of(const struct csgcast_scene *scene, uint32_t object,
                                     double spared, int num_threads);

/* What was found out for an object's frames of this area, in pixels: tests that cells spare in one.
 * It holds for some frames; looking again in each would cost more than a wrong answer in a few.
 * false: nothing is known, or no more. */
bool csg_cells_recall(const struct csgcast_scene *scene, uint32_t object, double area,
                      double *spared);
void csg_cells_remember(const struct csgcast_scene *scene, uint32_t object, double area,
                        double spared);

#endif
