/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_RANGE_H
#define CSG_TILE_RANGE_H

#include <math.h>

#include "pack/terms.h"

/* Pixel centres of a tile, counted from the reference pixel. */
struct csg_tile_box {
    double center[2], half[2];
    double reach[2]; /* half, and what float rounding may add, see csg_range_of_plane */
};

struct csg_tile_box csg_tile_box(const double center[2], const double half[2]);

struct csg_range {
    double lo, hi;
};

/* Where the rays of a tile enter and leave a leaf: bounds that hold for every ray that meets it. */
struct csg_leaf_range {
    struct csg_range entry, exit;
};

/* Whether every ray meets it and it has no gap: inside from entry.hi to exit.lo at least. */
static inline bool csg_is_solid(const struct csg_leaf_range *range)
{
    return range->entry.hi < range->exit.lo;
}

/* Of a leaf that no ray meets. */
extern const struct csg_leaf_range csg_leaf_nowhere;

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

/* Float rounding of the shader's evaluation, with room to spare: relative to its terms. */
#define CSG_FLOAT_MARGIN 1e-6

/* Of an affine term: over the tile, and with FLOAT_MARGIN of |c0| + |cx x| + |cy y|, each at its
 * largest there. */
static inline struct csg_range csg_range_of_affine(double c0, double cx, double cy,
                                                   const struct csg_tile_box *tile)
{
    const double mid = c0 + cx * tile->center[0] + cy * tile->center[1];
    const double reach =
        fabs(cx) * tile->reach[0] + fabs(cy) * tile->reach[1] + CSG_FLOAT_MARGIN * fabs(c0);
    return (struct csg_range){mid - reach, mid + reach};
}

static inline struct csg_range csg_range_of_plane(const double texel[4],
                                                  const struct csg_tile_box *tile)
{
    return csg_range_of_affine(texel[0], texel[1], texel[2], tile);
}

/* Of a quadric's two crossings; texels as shaders/solids/quadric.glsl reads them. */
struct csg_quadric_range {
    struct csg_range first, second;
    bool never, always; /* the rays have them */
    int region;
};

struct csg_quadric_range csg_range_of_quadric(const double *texels,
                                              const struct csg_tile_box *tile);

/* ---- several tiles at once: the parts that one is cut into ---------------------------------- */

#define CSG_TILE_LANES 4

struct csg_tile_boxes {
    double center[2][CSG_TILE_LANES], reach[2][CSG_TILE_LANES]; /* as of csg_tile_box */
};

void csg_tile_boxes_set(struct csg_tile_boxes *boxes, int lane, const struct csg_tile_box *box);

struct csg_ranges {
    double lo[CSG_TILE_LANES], hi[CSG_TILE_LANES];
};

/* Of a leaf of planes, and perhaps a quadric. */
struct csg_leaf_ranges {
    struct csg_ranges entry, exit;
    struct csg_ranges first, second; /* crossings of its quadric */
    struct csg_ranges conic;         /* that tells whether there are any */
    int code;                        /* of the quadric, CSG_QUADRIC_*; -1: there is none */
};

void csg_ranges_of_leaf(const struct csg_terms *terms, const struct csg_leaf_terms *leaf,
                        const struct csg_tile_boxes *tiles, struct csg_leaf_ranges *ranges);

/* In one of the tiles. */
static inline struct csg_range csg_range_in_lane(const struct csg_ranges *ranges, int lane)
{
    return (struct csg_range){ranges->lo[lane], ranges->hi[lane]};
}

/* Of a leaf that is a surface of triangles. */
struct csg_leaf_range csg_range_of_surface(const struct csg_surface_view *view,
                                           const struct csg_tile_box *tile);

/* Whether a leaf's quadric can be its entry or exit somewhere in the tile of a lane, where the leaf
 * matters within range. */
bool csg_range_has_quadric(const struct csg_leaf_ranges *ranges, int lane,
                           const struct csg_leaf_range *range);

/* Which of the planes of a leaf can. */
void csg_range_filter_planes(const struct csg_terms *terms, const struct csg_leaf_terms *leaf,
                             const struct csg_leaf_range *range, const struct csg_tile_box *tile,
                             bool *planes);

#endif
