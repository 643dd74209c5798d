/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_BANDS_H
#define CSG_PACK_BANDS_H

/*
 * Stacks of rings (csg/stack.h) as the screen sees them: the bands of cones and the flat rings that
 * bound them. Two neighbouring bands end in one circle. Whether a ray passes inside of it is
 * decided once, by a conic of the pixel, and both bands go by that: a band is crossed once where
 * the answers at its two circles differ, and else not, or twice, between them. So however keys are
 * rounded, over a whole stack entries and exits alternate: nothing is lost or counted twice where
 * bands meet.
 */

#include "csg/stack.h"
#include "pack/screen.h"

struct csg_terms;

/* A conic of the pixel, counted from the reference pixel: 1, x, y, xx, xy, yy. Negative where the
 * ray passes inside of the circle. */
struct csg_circle {
    double conic[6];
};

struct csg_band {
    uint32_t stack, leaf;
    uint32_t circles[2]; /* of the two planes; of a flat band its rims */
    double planes[2][4]; /* texels: where rays enter, then where they leave; code says else */
    bool flat;           /* on the first plane */
    bool inner;          /* of a ring's inner frustum */
    uint8_t code;        /* CSG_BAND_..., see layout.glsl */
    uint8_t face;        /* place of the normal in the leaf's attributes */
};

struct csg_bands {
    CSG_ARRAY(struct csg_circle) circles; /* the first one is none: all rays pass outside */
    CSG_ARRAY(struct csg_band) bands;
    CSG_ARRAY(bool) starts; /* by stack: rays start inside */
};

/* Those of the stacks of terms, whose leaves are filled. false: out of memory. */
bool csg_bands_fill(struct csg_bands *bands, const struct csg_terms *terms,
                    const struct csg_stacks *stacks);
void csg_bands_finish(struct csg_bands *bands);

#endif
