/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_RECORD_H
#define CSG_PACK_RECORD_H

/* What a step of a program reads of its leaf: a header, and those of the leaf's terms that matter.
 * Layout in shaders/common/layout.glsl. */

#include "pack/terms.h"

/* Which of a leaf's planes a record takes, by their place among the leaf's texels; NULL: all.
 * Also whether it takes the quadric. */
struct csg_record_filter {
    const bool *planes;
    bool quadric;
};

/* Appends a step's record to the frame, but for surfaces, which pack/surface_record.h does. filter
 * NULL: everything. */
bool csg_record_add(struct csg_terms *terms, const struct csg_step *step,
                    const struct csg_record_filter *filter);

/* A term's texel or, for programs in double, its texel and that of its low part. Returns what is
 * behind them. */
float *csg_record_put_term(const struct csg_terms *terms, const double *term, float *to);

/* Appends a CSG_RECORD_BOUND: nothing behind it matters before key. */
bool csg_record_add_bound(struct csg_terms *terms, double key);

#endif
