/* SPDX-License-Identifier: MIT */
#include "plane/profile.h"

/* Coordinates below this share of the largest, or below the rounding, are on the axis. */
#define ON_AXIS 1e-9

static void extend(struct csg_profile *profile, double x)
{
    profile->lo = fmin(profile->lo, x);
    profile->hi = fmax(profile->hi, x);
}

enum csg_sweep_result csg_profile_init(struct csg_profile *profile,
                                       const struct csg_drawing *drawing)
{
    *profile = (struct csg_profile){.lo = INFINITY, .hi = -INFINITY};
    const enum csg_sweep_result result = csg_sweep(&profile->sweep, drawing, 0);
    const struct csg_sweep *sweep = &profile->sweep;
    profile->snap = fmax(ON_AXIS * sweep->size,
                         2 * csg_drawing_rounding(drawing, 0, (uint32_t)drawing->nodes.num));
    for (size_t i = 0; i < sweep->spans.num; i++) {
        const struct csg_sweep_span *span = &sweep->spans.data[i];
        for (uint32_t level = span->level; level <= span->level + 1; level++) {
            extend(profile, csg_sweep_x(sweep, span->left, level));
            extend(profile, csg_sweep_x(sweep, span->right, level));
        }
    }
    return result;
}

void csg_profile_finish(struct csg_profile *profile)
{
    csg_sweep_finish(&profile->sweep);
}

/* Going up along the outside, where a convex profile turns from outwards to inwards. */
struct outside {
    struct csg_vec2 at;
    double degrees, dents; /* of its direction, from outwards; of the deepest bend back */
};

static void go(struct outside *outside, struct csg_vec2 to)
{
    const double x = to.x - outside->at.x, y = to.y - outside->at.y;
    const double degrees = atan2(y, x) * (180 / acos(-1.0));
    outside->dents = fmax(outside->dents, outside->degrees - degrees);
    outside->degrees = degrees;
    outside->at = to;
}

double csg_profile_dents(const struct csg_profile *profile)
{
    const struct csg_sweep *sweep = &profile->sweep;
    struct outside outside = {.at.y = sweep->levels.num ? sweep->levels.data[0] : 0};
    for (size_t i = 0; i < sweep->spans.num; i++) {
        const struct csg_sweep_span *span = &sweep->spans.data[i];
        for (uint32_t level = span->level; level <= span->level + 1; level++) {
            const double left = fabs(csg_sweep_x(sweep, span->left, level));
            const double right = fabs(csg_sweep_x(sweep, span->right, level));
            const struct csg_vec2 to = {fmax(left, right), sweep->levels.data[level]};
            if (span->level != i || fmin(left, right) > profile->snap)
                return INFINITY;
            if (level > span->level || fabs(to.x - outside.at.x) > profile->snap)
                go(&outside, to);
        }
    }
    return outside.dents;
}
