/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_BANDS_H
#define CSG_TILE_BANDS_H

/* Which bands of stacks (pack/bands.h) the rays of a tile may meet. */

#include "tile/range.h"

/* Indices of bands, in their order. */
struct csg_band_list {
    uint32_t *data;
    size_t num, capacity;
};

/* All bands of the terms' stacks. false: out of memory. */
bool csg_band_list_fill(struct csg_band_list *list, const struct csg_terms *terms);

/* copy is zeroed. */
bool csg_band_list_copy(const struct csg_band_list *list, struct csg_band_list *copy);

/*
 * Leaves those that rays of the tile may meet, and tells where rays enter and leave each stack, as
 * csg_range_of_leaf does for other leaves; ranges: by stack.
 */
void csg_band_list_narrow(struct csg_band_list *list, const struct csg_terms *terms,
                          const struct csg_tile_box *tile, struct csg_leaf_range *ranges);

/* Appends a stack's record, with the bands of the list, to the frame. false: out of memory. */
bool csg_band_list_put(const struct csg_band_list *list, struct csg_terms *terms,
                       const struct csg_step *step, const struct csg_tile_box *tile);

#endif
