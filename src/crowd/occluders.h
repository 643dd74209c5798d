/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_OCCLUDERS_H
#define CSG_CROWD_OCCLUDERS_H

/* The candidates that hide others, by strip of rows, each strip's roughly the nearest first. */

#include "crowd/cull.h"
#include "crowd/strips.h"

struct csg_occluders {
    size_t num;              /* candidates */
    uint32_t *found, *order; /* places in csg_cull.candidates, once for each of its strips */
    size_t begin[CSG_NUM_STRIPS + 1]; /* of a strip in both */
    struct csg_key_bins bins;         /* by which they are ordered */
};

/* Translucent members hide nothing. */
bool csg_hides_others(const struct csg_cull *cull, const struct csg_candidate *candidate);

/* From the opaque candidates or the translucent ones, but for order. false: out of memory. */
bool csg_occluders_fill(struct csg_occluders *occluders, const struct csg_cull *cull, bool opaque);

/* Fills a strip's part of order. */
void csg_occluders_sort(struct csg_occluders *occluders, const struct csg_cull *cull, size_t strip);
void csg_occluders_finish(struct csg_occluders *occluders);

#endif
