/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_RANGE_H
#define CSG_TILE_RANGE_H

#include "pack/terms.h"

/* Pixel centres of a tile, counted from the reference pixel. */
struct csg_tile_box {
    double center[2], half[2];
};

struct csg_range {
    double lo, hi;
};

/* Where the rays of a tile enter and leave a leaf: bounds that hold for every ray that meets it. */
struct csg_leaf_range {
    struct csg_range entry, exit;
    bool
        solid; /* every ray meets it, and it has no gap: inside from entry.hi to exit.lo at least */
};

/* fmax and fmin but for what is no number: without a call, which tiles would make by the million.
 */
static inline double csg_larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double csg_smaller(double a, double b)
{
    return a < b ? a : b;
}

struct csg_range csg_range_of_plane(const double texel[4], const struct csg_tile_box *tile);

/* Of a quadric's two crossings; texels as shaders/solids/quadric.glsl reads them. */
struct csg_quadric_range {
    struct csg_range first, second;
    bool never, always; /* the rays have them */
    int region;
};

struct csg_quadric_range csg_range_of_quadric(const double *texels,
                                             const struct csg_tile_box *tile);

/*
 * The leaf's range. takes, where not NULL, gets which of its planes can be its entry or exit
 * somewhere in the tile, and whether its quadric can.
 */
struct csg_leaf_range csg_range_of_leaf(const struct csg_terms *terms,
                                        const struct csg_leaf_terms *leaf,
                                        const struct csg_tile_box *tile, bool *planes,
                                        bool *quadric);

#endif
