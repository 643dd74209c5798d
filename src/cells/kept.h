/* SPDX-License-Identifier: MIT */
#ifndef CSG_CELLS_KEPT_H
#define CSG_CELLS_KEPT_H

/*
 * Parts of cells that outlive an edit. A part is made from its box and what the tree is there
 * alone; its key is a hash of all of that, so parts of the edited scene that have the key of an old
 * one are that one. Most edits change few parts.
 */

#include "cells/build.h"

struct csg_kept;

/* What a part's key has of a leaf. */
uint64_t csg_kept_leaf_key(const struct csg_cell_builder *top, uint32_t leaf);

/* Of the part that starts from work, one of top's; leaf_keys by leaf. */
uint64_t csg_kept_key(const struct csg_cell_builder *top, const struct csg_work *work,
                      const uint64_t *leaf_keys);

/* Keeps what cells are of parts, which is taken from them. NULL: out of memory. */
struct csg_kept *csg_kept_create(struct csg_cell_builder *parts, const uint64_t *keys, size_t num);
void csg_kept_destroy(struct csg_kept *kept);

/* Gives the part with that key, which is kept no more; false: there is none. Parts of different
 * keys may be taken at the same time. */
bool csg_kept_take(struct csg_kept *kept, uint64_t key, struct csg_cell_builder *part);

#endif
