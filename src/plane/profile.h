/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_PROFILE_H
#define CSG_PLANE_PROFILE_H

/* The drawing that is turned, swept. */

#include "plane/sweep.h"

/* What the profile covers: lo > hi when it is empty. x closer to 0 than snap counts as 0. */
struct csg_profile {
    struct csg_sweep sweep;
    double lo, hi; /* of x */
    double snap;
};

/* Sweeps the whole drawing. */
enum csg_sweep_result csg_profile_init(struct csg_profile *profile,
                                       const struct csg_drawing *drawing);
void csg_profile_finish(struct csg_profile *profile);

/* How deep the dents of a profile are that reaches out from the axis: the most degrees that a
 * corner bends inwards. INFINITY where it does not reach to the axis at some height. */
double csg_profile_dents(const struct csg_profile *profile);

#endif
