/* SPDX-License-Identifier: MIT */

/*
 * The ball |p - C| <= r on the ray e + t d, e = o - C, with s = 1 / t = (A - k) / B:
 *     (|e|^2 - r^2) s^2 + 2 (e.d) s + |d|^2 <= 0,   g = |e|^2 - r^2.
 * The nearer crossing is k = A + B (e.d) / g - sqrt(h), h = (B / g)^2 (r^2 |d|^2 - |e x d|^2). In
 * camera axes c = -e = (x, y, z), rho = |(x, y)|, with d = (u, v, 1), u along (x, y) and v across:
 *     r^2 |d|^2 - |e x d|^2 = r^2 g / q - q (u - u0)^2 - g v^2,   q = z^2 - r^2, u0 = rho z / q,
 * sums and products of positive numbers but for q and g: no cancellation where z is several r.
 */

#include "pack/ball.h"

#include <string.h>

bool csg_screen_is_square(const struct csg_screen *screen)
{
    const struct csg_vec3 dx = screen->orthographic ? screen->origin_dx : screen->direction_dx;
    const struct csg_vec3 dy = screen->orthographic ? screen->origin_dy : screen->direction_dy;
    const double xx = csg_dot(dx, dx);
    return fabs(csg_dot(dy, dy) - xx) <= 1e-12 * xx && fabs(csg_dot(dx, dy)) <= 1e-12 * xx;
}

bool csg_screen_takes_ball(const struct csg_screen *screen, struct csg_vec3 center, double radius)
{
    const struct csg_vec3 c = csg_sub(center, screen->origin);
    const double near = CSG_BALL_NEAR * radius;
    return csg_screen_is_square(screen) &&
           (screen->orthographic || (csg_dot(c, screen->forward) > CSG_BALL_FRONT * radius &&
                                     csg_dot(c, c) >= near * near));
}

static void put(double texel[4], double a, double b, double c, double d)
{
    texel[0] = a;
    texel[1] = b;
    texel[2] = c;
    texel[3] = d;
}

/* Parallel rays: k = c.forward - A - sqrt(r^2 - |across|^2). */
static void orthographic(const struct csg_screen *screen, struct csg_pixel at,
                         struct csg_vec3 center, double radius, double texels[CSG_BALL_TEXELS][4])
{
    const struct csg_vec3 origin = csg_screen_origin(screen, at);
    const struct csg_vec3 c = csg_sub(center, origin);
    const double step = csg_length(screen->origin_dx);
    put(texels[0], csg_dot(c, screen->forward) - screen->a, 0, 0, 0);
    put(texels[1], -csg_dot(c, screen->origin_dx) / step, step, 0, radius * radius);
    put(texels[2], -csg_dot(c, screen->origin_dy) / step, 0, 0, -1);
}

static void perspective(const struct csg_screen *screen, struct csg_pixel at,
                        struct csg_vec3 center, double radius, double texels[CSG_BALL_TEXELS][4])
{
    const struct csg_vec3 c = csg_sub(center, screen->origin);
    const struct csg_vec3 direction = csg_screen_direction(screen, at);
    const double step = csg_length(screen->direction_dx), per_step = 1 / step;
    const double x = per_step * csg_dot(c, screen->direction_dx);
    const double y = per_step * csg_dot(c, screen->direction_dy);
    const double z = csg_dot(c, screen->forward);
    const double tx = per_step * csg_dot(direction, screen->direction_dx);
    const double ty = per_step * csg_dot(direction, screen->direction_dy);
    const double rr = radius * radius, across = x * x + y * y, rho = sqrt(across);
    const double q = z * z - rr, g = q + across;
    const double ux = rho > 0 ? x / rho : 1, uy = rho > 0 ? y / rho : 0;
    const double slope = screen->b / g, size = screen->b / sqrt(g);
    put(texels[0], screen->a - slope * (x * tx + y * ty + z), -slope * step * x, -slope * step * y,
        0);
    put(texels[1], size * (ux * ty - uy * tx), -size * step * uy, size * step * ux,
        slope * screen->b * rr / q);
    put(texels[2], size * (rho * z / q - (ux * tx + uy * ty)), 0, 0, -q / g);
}

void csg_screen_ball(const struct csg_screen *screen, struct csg_pixel at, struct csg_vec3 center,
                     double radius, double texels[CSG_BALL_TEXELS][4])
{
    if (screen->orthographic)
        orthographic(screen, at, center, radius, texels);
    else
        perspective(screen, at, center, radius, texels);
    texels[0][3] = CSG_QUADRIC_BETWEEN + CSG_QUADRIC_X_MINUS;
}

/* p - C at P + k W, see csg_screen_normal. */
void csg_screen_ball_normal(const struct csg_screen *screen, struct csg_pixel at,
                            struct csg_vec3 center, float terms[CSG_NORMAL_TERMS][3])
{
    struct csg_vec3 n[CSG_NORMAL_TERMS];
    const struct csg_vec3 e = csg_sub(csg_screen_origin(screen, at), center);
    const struct csg_vec3 d = csg_screen_direction(screen, at);
    double largest = 0;
    if (screen->orthographic) {
        n[0] = csg_add(e, csg_scale(screen->a, d));
        n[1] = screen->origin_dx;
        n[2] = screen->origin_dy;
        n[3] = d;
    } else {
        const double s = screen->scale / screen->b;
        n[0] = csg_add(csg_scale(s * screen->a, e), csg_scale(screen->scale, d));
        n[1] = csg_scale(screen->scale, screen->direction_dx);
        n[2] = csg_scale(screen->scale, screen->direction_dy);
        n[3] = csg_scale(-s, e);
    }
    for (int i = 0; i < CSG_NORMAL_TERMS; i++)
        largest = fmax(largest, csg_dot(n[i], n[i]));
    const double scale = 1 / sqrt(largest);
    for (int i = 0; i < CSG_NORMAL_TERMS; i++) {
        terms[i][0] = (float)(scale * n[i].x);
        terms[i][1] = (float)(scale * n[i].y);
        terms[i][2] = (float)(scale * n[i].z);
    }
}
