/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_TILE_H
#define CSG_TILE_TILE_H

/*
 * Large objects are drawn in tiles: rectangles of the screen, each with the part of the tree that
 * matters in it. Over a tile every affine term and every conic has a range, so a leaf's entry and
 * exit have; what can never meet the rest of an intersection is folded away, like whole solids
 * are by bounding boxes.
 */

#include <stdatomic.h>

#include "pack/terms.h"

/* Tiles are not cut below this size, in pixels, but once more where many solids are left. */
#define CSG_TILE_SIZE 8

/* Texels of an object beyond which its tiles are not cut further: 128 MB. */
#define CSG_MAX_TILED_TEXELS ((size_t)8 << 20)

/* Tests of a solid at a pixel that an object's tiles may need, all of its areas together. */
struct csg_tile_budget {
    size_t most;
    atomic_size_t spent;
};

/* A part of the picture to be tiled: pixels [lo, hi), how many texels it may take, and whether
 * tiles are cut as small as spares tests, which need not be what is drawn soonest. */
struct csg_tile_area {
    int lo[2], hi[2];
    size_t max_texels;
    bool fine;
    struct csg_tile_budget *budget; /* where more is spent, tiling ends; NULL: as it takes */
};

struct csg_tiler;

/* Appends an object's records and draws in an area to the frame; terms are the object's. false:
 * out of memory. */
bool csg_tile_area(struct csg_tiler *tiler, struct csg_terms *terms,
                   const struct csg_tile_area *area, const struct csg_draw *draw);

/* The same for all of the object, on all cores; rect in pixels, like csg_screen_rect's. *tests:
 * what its tiles need; where that is more than max_tests, the frame gets none. */
bool csg_tile_object(struct csg_terms *terms, const struct csg_object *object,
                     const struct csg_rect *rect, const struct csg_draw *draw, size_t max_tests,
                     size_t *tests);

/* Whether that would be done by one core, and as it does it. */
bool csg_tile_is_small(const struct csg_object *object, const struct csg_rect *rect);
bool csg_tile_small(struct csg_tiler *tiler, struct csg_terms *terms, const struct csg_rect *rect,
                    const struct csg_draw *draw);

/* How many solids a pixel would be tested against in tiles of the smallest size, from a few of
 * them: those that are not empty. Fewer samples are taken where the first ones say few or less, or
 * many or more. */
bool csg_tile_sample(const struct csg_terms *terms, const struct csg_rect *rect,
                     const struct csg_draw *draw, double few, double many, double *tests);

#endif
