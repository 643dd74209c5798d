/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_BALL_H
#define CSG_PACK_BALL_H

/* A sphere's terms, in closed form: those of csg_screen_quadric, many times faster. */

#include "pack/screen.h"

#define CSG_BALL_TEXELS 3

/* The closed form is for eyes that are further away from the ball's center than this many radii,
 * and for balls that are in front of the eye: beyond this many radii along the view axis. */
#define CSG_BALL_NEAR 2.0
#define CSG_BALL_FRONT 1.3

/* Whether the screen's pixels are square, as the closed form needs them. */
bool csg_screen_is_square(const struct csg_screen *screen);

/* Whether this ball may be given to the closed form in this view. */
bool csg_screen_takes_ball(const struct csg_screen *screen, struct csg_vec3 center, double radius);

/* The first three texels of csg_screen_quadric, the code for a solid ball. */
void csg_screen_ball(const struct csg_screen *screen, struct csg_pixel at, struct csg_vec3 center,
                     double radius, double texels[CSG_BALL_TEXELS][4]);

/* The terms of csg_screen_normal. */
void csg_screen_ball_normal(const struct csg_screen *screen, struct csg_pixel at,
                            struct csg_vec3 center, float terms[CSG_NORMAL_TERMS][3]);

#endif
