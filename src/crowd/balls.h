/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_BALLS_H
#define CSG_CROWD_BALLS_H

/* What csg_outline_project finds for balls, for many of them at once. */

#include "crowd/project.h"

#define CSG_BALLS_MAX 64

/* One entry a ball. */
struct csg_ball_prints {
    int32_t lo[2][CSG_BALLS_MAX], hi[2][CSG_BALLS_MAX]; /* no pixel: lo > hi */
    double near[CSG_BALLS_MAX];                         /* nearest depth t */
    int32_t plain[CSG_BALLS_MAX]; /* 0: close to the eye; nothing else holds then */
};

/* Of num balls, at most CSG_BALLS_MAX, with these centers and radii. */
void csg_balls_project(const struct csg_camera *camera, const double *x, const double *y,
                       const double *z, const double *radius, size_t num,
                       struct csg_ball_prints *out);

#endif
