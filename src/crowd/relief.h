/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_RELIEF_H
#define CSG_CROWD_RELIEF_H

/*
 * A picture of a crowd, by the CPU: per pixel a key behind which nothing can show. It is
 * conservative: what the shader finds is nearer by more than both sides' rounding and the depth
 * buffer's steps together. Squares of pixels know such a key for all of them, so that large solids
 * are compared with squares first, and with pixels only where that does not tell.
 */

#include "crowd/owners.h"

#define CSG_RELIEF_SQUARE 16 /* pixels a side */

/* Pixels, both ends included. */
struct csg_pixels {
    int lo[2], hi[2];
};

static inline size_t csg_count_pixels(const struct csg_pixels *pixels)
{
    return (size_t)(pixels->hi[0] - pixels->lo[0] + 1) *
           (size_t)(pixels->hi[1] - pixels->lo[1] + 1);
}

/* What is known of all pixels of a square. */
struct csg_square {
    float far;            /* what is behind it is hidden */
    float tilted_far;     /* the same for keys less tilt, */
    struct csg_tilt tilt; /* which is about the slope of what was drawn */
    size_t news;          /* pixels drawn since that was found */
};

struct csg_relief {
    enum csg_cast_side side;
    double at[2]; /* the reference pixel of all terms */
    int width, height;
    size_t stride; /* of keys: there is room for CSG_CAST_LANES behind a row */
    float *keys;
    struct csg_square *squares;
    size_t num_squares_x, num_squares_y;
    struct csg_owners *owners; /* who shows, of near sides; NULL: that is not asked */
};

/* false: out of memory. */
bool csg_relief_init(struct csg_relief *relief, const struct csg_screen *screen,
                     struct csg_pixel at, enum csg_cast_side side);
void csg_relief_finish(struct csg_relief *relief);

/* Rows [begin, end), which begin at the border of squares, start with what hides in base; NULL:
 * nothing does. To be called for each row before anything else. */
void csg_relief_clear(const struct csg_relief *relief, const struct csg_relief *base, int begin,
                      int end);

/* The offsets of pixels from the reference pixel. */
struct csg_cast_rect csg_relief_offsets(const struct csg_relief *relief,
                                        const struct csg_pixels *pixels);

/* Whether what is nowhere nearer than key may show at one of the pixels. */
bool csg_relief_may_show(const struct csg_relief *relief, float key,
                         const struct csg_pixels *pixels);

/* Draws the member's part within the pixels; only one thread may draw in a square at a time. who:
 * the member, where it may own pixels, or CSG_NOBODY. false: all of that is hidden. */
bool csg_relief_draw(struct csg_relief *relief, const struct csg_cast *cast, uint32_t who,
                     const struct csg_pixels *pixels);

/* Narrows pixels to those at which the member may show, of all or of those at which others may.
 * false: there is none. */
bool csg_relief_narrow(const struct csg_relief *relief, const struct csg_cast *cast, bool contested,
                       struct csg_pixels *pixels);

#endif
