/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_PROJECT_H
#define CSG_CROWD_PROJECT_H

/* Outlines (crowd/outline.h) as the camera sees them. */

#include "crowd/outline.h"
#include "pack/screen.h"

/* Part of a pixel by which bounds grow: rounding, here and in the vertex stage. */
#define CSG_OUTLINE_MARGIN 0.01

/* A point's c = p - origin has the pixel (c.axis / t) scale - shift in perspective. */
struct csg_camera {
    struct csg_vec3 origin, axis[2], forward;
    bool orthographic;
    double scale[2], shift[2]; /* pixels per unit (perspective: of the tangent) */
    double size[2];
    double lo[2], hi[2];           /* tangents of the picture's borders */
    double lo_norm[2], hi_norm[2]; /* lengths of the border planes' normals */
};

struct csg_camera csg_camera_of(const struct csg_screen *screen);

/* A ball in the camera's axes. */
struct csg_seen_ball {
    double c[2], t, radius;
};

struct csg_seen_ball csg_camera_see(const struct csg_camera *camera, struct csg_vec3 center,
                                    double radius);

/* Whether any of it, as far as it is before the eye, can be in the picture. */
bool csg_ball_crosses_picture(const struct csg_camera *camera, const struct csg_seen_ball *ball);

/* What an outline covers: pixels, both ends included, and its nearest depth t. */
struct csg_footprint {
    int16_t lo[2], hi[2];
    double near;
};

/*
 * The exact rectangle of an outline all of which is before the eye, but for a hundredth of a pixel.
 * false: it covers no pixel's centre. ball: the one around it.
 */
bool csg_outline_project(const struct csg_camera *camera, enum csg_outline kind,
                         const double *numbers, const struct csg_seen_ball *ball,
                         struct csg_footprint *out);

#endif
