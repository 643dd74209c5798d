/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_OCCLUDERS_H
#define CSG_CROWD_OCCLUDERS_H

/* The candidates that hide others, by band of rows, each band's roughly the nearest first. */

#include "crowd/cull.h"

enum { CSG_NUM_BANDS = 16 };

struct csg_occluders {
    size_t num;                      /* candidates */
    uint32_t *found, *order;         /* places in csg_cull.candidates, once for each of its bands */
    size_t begin[CSG_NUM_BANDS + 1]; /* of a band in both */
    float lo, scale;                 /* of keys, by which they are ordered */
};

/* The first row of a band, at the border of a relief's squares; of the one behind the last: the
 * picture's height. */
int csg_band_begin(const struct csg_cull *cull, size_t band);

/* Translucent members hide nothing. */
bool csg_hides_others(const struct csg_cull *cull, const struct csg_candidate *candidate);

/* From the opaque candidates or the translucent ones, but for order. false: out of memory. */
bool csg_occluders_fill(struct csg_occluders *occluders, const struct csg_cull *cull, bool opaque);

/* Fills a band's part of order. */
void csg_occluders_sort(struct csg_occluders *occluders, const struct csg_cull *cull, size_t band);
void csg_occluders_finish(struct csg_occluders *occluders);

#endif
