/* SPDX-License-Identifier: MIT */
#include "pack/conic.h"

#include <stdbool.h>

/* A conic's centre is near when it is within this many times the leaf's radius of its pixel. */
#define CENTRED_RATIO 2.0

/* Unit eigenvector of the larger eigenvalue, by size, of [xx xy; xy yy]. */
static void major_axis(double xx, double xy, double yy, double axis[2])
{
    /* Half of the angle of (xx - yy, 2 xy), of whose cosine and sine the larger comes first. */
    const double size = hypot(xx - yy, 2 * xy);
    const double c = size > 0 ? (xx - yy) / size : 1, s = size > 0 ? 2 * xy / size : 0;
    const double larger = sqrt(0.5 * (1 + fabs(c))), smaller = 0.5 * s / larger;
    axis[0] = c < 0 ? fabs(smaller) : larger;
    axis[1] = c < 0 ? copysign(larger, s) : smaller;
    const double along =
        xx * axis[0] * axis[0] + 2 * xy * axis[0] * axis[1] + yy * axis[1] * axis[1];
    if (fabs(xx + yy - along) > fabs(along)) {
        const double x = axis[0];
        axis[0] = -axis[1];
        axis[1] = x;
    }
}

static int sign_of(double value)
{
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/* One axis of the conic, l u^2 + 2 g u: moves the origin to the extremum, or keeps the slope. */
static void centre(double l, double g, double pixels, double *offset, double *slope, double *c0)
{
    const bool near = fabs(g) <= CENTRED_RATIO * pixels * fabs(l) && l != 0;
    *offset = near ? g / l : 0;
    *slope = near ? 0 : 2 * g;
    *c0 -= near ? g * g / l : 0;
}

struct csg_conic_axes csg_conic_axes_of(const double s[6], double pixels)
{
    struct csg_conic_axes axes = {.c0 = s[0]};
    const double xx = s[3], xy = 0.5 * s[4], yy = s[5];
    major_axis(xx, xy, yy, axes.ex);
    axes.ey[0] = -axes.ex[1];
    axes.ey[1] = axes.ex[0];
    const double *ex = axes.ex, *ey = axes.ey;
    double lx = xx * ex[0] * ex[0] + 2 * xy * ex[0] * ex[1] + yy * ex[1] * ex[1];
    double ly = xx * ey[0] * ey[0] + 2 * xy * ey[0] * ey[1] + yy * ey[1] * ey[1];
    const double gx = 0.5 * (s[1] * ex[0] + s[2] * ex[1]);
    const double gy = 0.5 * (s[1] * ey[0] + s[2] * ey[1]);
    const double rest = fabs(s[0]) + pixels * (fabs(gx) + fabs(gy));
    if (fabs(lx) * pixels * pixels < 1e-13 * rest)
        lx = 0;
    if (fabs(ly) < 1e-14 * fabs(lx) || lx == 0)
        ly = 0; /* rounding of the products above */
    axes.size = lx != 0 ? sqrt(fabs(lx)) : 1 / pixels;
    axes.sign_x = sign_of(lx);
    centre(lx, gx, pixels, &axes.ox, &axes.cx, &axes.c0);
    centre(ly, gy, pixels, &axes.oy, &axes.cy, &axes.c0);
    axes.ox *= axes.size;
    axes.oy *= axes.size;
    axes.cx /= axes.size;
    axes.cy /= axes.size;
    axes.ly = ly / (axes.size * axes.size);
    return axes;
}

void csg_conic_put(double texels[2][4], const double c[6], const struct csg_conic_axes *axes,
                   double scale)
{
    const double ux[2] = {axes->ex[0] / axes->size, axes->ex[1] / axes->size};
    const double uy[2] = {axes->ey[0] / axes->size, axes->ey[1] / axes->size};
    const double base[2] = {-axes->ox * ux[0] - axes->oy * uy[0],
                            -axes->ox * ux[1] - axes->oy * uy[1]};
    const double c0 = c[0] + c[1] * base[0] + c[2] * base[1] + c[3] * base[0] * base[0] +
                      c[4] * base[0] * base[1] + c[5] * base[1] * base[1];
    const double grad[2] = {c[1] + 2 * c[3] * base[0] + c[4] * base[1],
                            c[2] + c[4] * base[0] + 2 * c[5] * base[1]};
    texels[0][0] = csg_conic_clamp(scale * c0);
    texels[0][1] = csg_conic_clamp(scale * (grad[0] * ux[0] + grad[1] * ux[1]));
    texels[0][2] = csg_conic_clamp(scale * (grad[0] * uy[0] + grad[1] * uy[1]));
    texels[1][0] = csg_conic_clamp(
        scale * (c[3] * ux[0] * ux[0] + c[4] * ux[0] * ux[1] + c[5] * ux[1] * ux[1]));
    texels[1][1] =
        csg_conic_clamp(scale * (2 * c[3] * ux[0] * uy[0] + c[4] * (ux[0] * uy[1] + ux[1] * uy[0]) +
                                 2 * c[5] * ux[1] * uy[1]));
    texels[1][2] = csg_conic_clamp(
        scale * (c[3] * uy[0] * uy[0] + c[4] * uy[0] * uy[1] + c[5] * uy[1] * uy[1]));
}
