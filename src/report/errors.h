/* SPDX-License-Identifier: MIT */
#ifndef CSG_REPORT_ERRORS_H
#define CSG_REPORT_ERRORS_H

/* A picture against the picture of the verified reference. */

#include "csgcast/csgcast.h"

/* A depth further off than this part of the scene's radius shows another surface. */
#define CSG_OTHER_SURFACE 0.2

struct csg_picture_errors {
    size_t pixels, covered; /* of the picture; of the reference's, where it hits */
    size_t silhouette;      /* a hit where there is nothing, or nothing where there is one */
    size_t extra;           /* of these, hits where there is nothing */
    size_t other;           /* another surface: ids differ, or without ids see above */
    size_t nan;             /* not a number in depth or normal */
    /* Of pixels that both hit, but for other surfaces: |z - z_ref| / scale. */
    double depth_mean, depth_p99, depth_p999, depth_max;
    double normal_p99, normal_p999; /* degrees */
};

/*
 * Both with z and normal; with id in both, other counts other leaves, and scale is relative to each
 * pixel's distance where it is 0, else scene units: the scene's radius. false: out of memory.
 */
bool csg_picture_errors(const struct csgcast_image *picture, const struct csgcast_image *reference,
                        size_t num_pixels, double scale, struct csg_picture_errors *errors);

/* The share of wrong pixels of those that either covers. */
double csg_picture_errors_wrong(const struct csg_picture_errors *errors);

/* Adds counts; keeps the larger of each quantile. */
void csg_picture_errors_add(struct csg_picture_errors *sum, const struct csg_picture_errors *more);

#endif
