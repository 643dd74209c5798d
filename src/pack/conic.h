/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_CONIC_H
#define CSG_PACK_CONIC_H

/* Conics of the pixel in coordinates in which float keeps them, also where they are slender. */

#include <math.h>

/*
 * A conic in its principal axes, S = c0 + x' (cx +- x') + y' (cy + ly y'), where
 * x' = size (ex . d) + ox and y' = size (ey . d) + oy, d from the leaf's pixel, and ey is ex turned
 * left by a quarter. Centred where the conic's centre is near; where it is far off, c0 would be
 * the difference of large numbers, and the linear terms stay.
 */
struct csg_conic_axes {
    double ex[2], ey[2];
    double size;
    double ox, oy, c0, cx, cy, ly;
    int sign_x;
};

/* The axes of the conic with the terms {1, x, y, xx, xy, yy}. pixels: the leaf's radius on the
 * screen; curvature too weak to show over it is dropped. */
struct csg_conic_axes csg_conic_axes_of(const double s[6], double pixels);

/* Another conic c, times scale, in x' and y':
 * d = ex (x' - ox) / size + ey (y' - oy) / size. */
void csg_conic_put(double texels[2][4], const double c[6], const struct csg_conic_axes *axes,
                   double scale);

/* Within the range of float. */
static inline double csg_conic_clamp(double value)
{
    return fmin(fmax(value, -3e38), 3e38);
}

#endif
