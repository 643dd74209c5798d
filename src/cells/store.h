/* SPDX-License-Identifier: MIT */
#ifndef CSG_CELLS_STORE_H
#define CSG_CELLS_STORE_H

/* The cells of a scene's objects, made when a frame first asks for them. */

#include "cells/cells.h"

struct csg_cells_store;

/* NULL: out of memory. */
struct csg_cells_store *csg_cells_store_create(const struct csgcast_scene *scene);
void csg_cells_store_destroy(struct csg_cells_store *store);

/* May be called by several threads. NULL: the object has none, for whatever reason. */
const struct csg_cells *csg_cells_of(const struct csgcast_scene *scene, uint32_t object,
                                     int num_threads);

#endif
