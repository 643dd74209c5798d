/* SPDX-License-Identifier: MIT */

/*
 * A quadric's crossings as terms of the pixel. With p = P + k W in the quadric's canonical space,
 *     f = a k^2 + 2 b k + c,   a = W.QW constant, b = W.QP affine, c = P.QP a conic,
 * so k = -b/a -+ sqrt(S)/|a| with the silhouette conic S = b^2 - a c. For diagonal Q Lagrange's
 * identity gives S without the difference of large numbers:
 *     S = -sum over i < j of Q_i Q_j (P_i W_j - P_j W_i)^2.
 * S is written in its principal axes, so that float keeps slender silhouettes, and counted from the
 * leaf's pixel.
 */

#include "pack/ball.h"
#include "pack/conic.h"

#include <string.h>

/* Crossings further than this many times the leaf's depth apart are found as c/q, not q/a: beyond
 * it the subtraction of mid and sqrt(h) costs more than two bits. */
#define STIFF_RATIO 4.0

/* Share of its terms below which a has no digits left, and rays meet the surface once. */
#define DEGENERATE_A 1e-13

/* What such an a becomes, times that: with the eye at a cone's apex b is nothing as well, and the
 * crossings at sqrt(c / a) are still to be nearer than anything that can be seen. */
#define VANISHING_A 1e-13

/* P at the leaf's pixel, its steps per pixel, and W, in canonical homogeneous coordinates. */
struct pencil {
    double q[4];
    double p[3][4]; /* 0: at the pixel, 1: step in x, 2: step in y */
    double w[4];
};

static void set4(double out[4], double s, struct csg_vec3 v, double w)
{
    out[0] = s * v.x;
    out[1] = s * v.y;
    out[2] = s * v.z;
    out[3] = s * w;
}

static struct pencil pencil_at(const struct csg_screen *screen, struct csg_pixel at,
                               const struct csg_map *to_canon)
{
    struct pencil pencil;
    const struct csg_vec3 origin = csg_screen_origin(screen, at);
    const struct csg_vec3 direction = csg_screen_direction(screen, at);
    const struct csg_vec3 d = csg_map_direction(to_canon, direction);
    if (screen->orthographic) {
        const struct csg_vec3 middle = csg_add(origin, csg_scale(screen->a, direction));
        set4(pencil.p[0], 1, csg_map_point(to_canon, middle), 1);
        set4(pencil.p[1], 1, csg_map_direction(to_canon, screen->origin_dx), 0);
        set4(pencil.p[2], 1, csg_map_direction(to_canon, screen->origin_dy), 0);
        set4(pencil.w, 1, d, 0);
        return pencil;
    }
    const double s = screen->scale, ratio = screen->a / screen->b;
    if (ratio > 0) { /* s * ratio is 1: P is the point at depth a */
        const struct csg_vec3 middle = csg_add(origin, csg_scale(1 / ratio, direction));
        set4(pencil.p[0], s * ratio, csg_map_point(to_canon, middle), 1);
    } else {
        set4(pencil.p[0], s, d, 0);
    }
    set4(pencil.p[1], s, csg_map_direction(to_canon, screen->direction_dx), 0);
    set4(pencil.p[2], s, csg_map_direction(to_canon, screen->direction_dy), 0);
    set4(pencil.w, -s / screen->b, csg_map_point(to_canon, origin), 1);
    return pencil;
}

/* (z, w) -> (z + w, z - w) turns 2 linear z w into linear/2 (z + w)^2 - linear/2 (z - w)^2. */
static void mix(double v[4])
{
    const double z = v[2], w = v[3];
    v[2] = z + w;
    v[3] = z - w;
}

static void diagonalise(struct pencil *pencil, const struct csg_quadric *quadric)
{
    for (int i = 0; i < 4; i++)
        pencil->q[i] = quadric->diag[i];
    if (quadric->linear == 0)
        return;
    pencil->q[2] = 0.5 * quadric->linear;
    pencil->q[3] = -0.5 * quadric->linear;
    for (int i = 0; i < 3; i++)
        mix(pencil->p[i]);
    mix(pencil->w);
}

static double form(const double q[4], const double x[4], const double y[4])
{
    return q[0] * x[0] * y[0] + q[1] * x[1] * y[1] + q[2] * x[2] * y[2] + q[3] * x[3] * y[3];
}

static double form_size(const double q[4], const double x[4])
{
    const double size[4] = {fabs(q[0]), fabs(q[1]), fabs(q[2]), fabs(q[3])};
    return form(size, x, x);
}

static double silhouette(const struct pencil *pencil, int i, int j)
{
    const double *x = pencil->p[i], *y = pencil->p[j], *w = pencil->w, *q = pencil->q;
    double sum = 0;
    for (int k = 0; k < 4; k++)
        for (int l = k + 1; l < 4; l++)
            sum -= q[k] * q[l] * (x[k] * w[l] - x[l] * w[k]) * (y[k] * w[l] - y[l] * w[k]);
    return sum;
}

/* Which coordinates a conic's terms are the products of: 1, x, y. */
static const int conic_terms[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};

/* The quadratic in k, with conics as {1, x, y, xx, xy, yy} around the leaf's pixel. */
struct quadratic {
    double a, b[3], c[6], s[6];
};

static struct quadratic quadratic_of(const struct pencil *pencil, double key_span)
{
    struct quadratic f = {.a = form(pencil->q, pencil->w, pencil->w)};
    for (int i = 0; i < 3; i++)
        f.b[i] = form(pencil->q, pencil->w, pencil->p[i]);
    const double smallest =
        DEGENERATE_A * fmax(form_size(pencil->q, pencil->w),
                            form_size(pencil->q, pencil->p[0]) / (key_span * key_span));
    const bool degenerate = fabs(f.a) < smallest;
    if (degenerate) /* one crossing goes to infinity; c's sign decides what is inside */
        f.a = VANISHING_A * smallest;
    for (int n = 0; n < 6; n++) {
        const int i = conic_terms[n][0], j = conic_terms[n][1];
        const double twice = i == j ? 1 : 2;
        f.c[n] = twice * form(pencil->q, pencil->p[i], pencil->p[j]);
        f.s[n] =
            degenerate ? twice * f.b[i] * f.b[j] - f.a * f.c[n] : twice * silhouette(pencil, i, j);
    }
    return f;
}

/* An affine term c0 + cx x + cy y around the leaf's pixel, moved to the object's. */
static void put_affine(double texel[4], double c0, double cx, double cy, const double shift[2])
{
    texel[0] = csg_conic_clamp(c0 - cx * shift[0] - cy * shift[1]);
    texel[1] = csg_conic_clamp(cx);
    texel[2] = csg_conic_clamp(cy);
}

static int region_code(const struct csg_screen *screen, const struct csg_quadric *quadric, double a,
                       bool flipped, bool convex, int sheet)
{
    if ((a > 0) != flipped)
        return CSG_QUADRIC_BETWEEN;
    if (!convex)
        return CSG_QUADRIC_OUTSIDE;
    if (sheet == 0)
        return CSG_QUADRIC_BEFORE;
    /* The eye (perspective) or the far end (orthographic) is inside one of the two sheets. */
    if (screen->orthographic) {
        const double z = csg_map_direction(&quadric->to_canon, screen->direction).z;
        return (z > 0) == (sheet > 0) ? CSG_QUADRIC_AFTER : CSG_QUADRIC_BEFORE;
    }
    const double z = csg_map_point(&quadric->to_canon, screen->origin).z;
    return (z > 0) == (sheet > 0) ? CSG_QUADRIC_BEFORE : CSG_QUADRIC_AFTER;
}

/* Length of the leaf's depth in keys; nearer than a fifth of the radius counts as that. */
static double key_span(const struct csg_screen *screen, struct csg_vec3 center, double radius)
{
    const double t = csg_dot(csg_sub(center, screen->origin), screen->forward);
    if (!isfinite(radius))
        radius = fabs(t) > 0 ? fabs(t) : 1;
    if (screen->orthographic)
        return 2 * radius;
    const double near = fmax(t - radius, 0.2 * radius);
    return fabs(csg_screen_key(screen, fmax(t + radius, 2 * near)) - csg_screen_key(screen, near));
}

/* Pixels from a leaf's middle to its rim, at most the screen's diagonal. */
static double pixel_radius(const struct csg_screen *screen, struct csg_vec3 center, double radius)
{
    const double diagonal = hypot(screen->width, screen->height);
    const double t = csg_dot(csg_sub(center, screen->origin), screen->forward);
    const double step = csg_length(screen->orthographic ? screen->origin_dx : screen->direction_dx);
    const double size = screen->orthographic ? radius / step : radius / (step * fabs(t));
    return size < diagonal ? fmax(size, 1) : diagonal;
}

/* How far from key 0, and from each other, the crossings are over a square of that many pixels.
 * Only where both is far does their middle cancel against sqrt(h): a small leaf far from key 0 has
 * a large middle and a small root. */
static double size_of_middle(const struct quadratic *f, double pixels)
{
    return (fabs(f->b[0]) + pixels * (fabs(f->b[1]) + fabs(f->b[2]))) / fabs(f->a);
}

static double size_of_root(const struct quadratic *f, double pixels)
{
    return sqrt(fabs(f->s[0]) + pixels * (fabs(f->s[1]) + fabs(f->s[2])) +
                pixels * pixels * (fabs(f->s[3]) + fabs(f->s[4]) + fabs(f->s[5]))) /
           fabs(f->a);
}

/* Of a whole sphere the closed form, as crowds have it: all get the same bits. */
static bool put_ball(const struct csg_screen *screen, struct csg_pixel at,
                     const struct csg_quadric *quadric, double seen_radius,
                     double texels[CSG_QUADRIC_TEXELS][4])
{
    struct csg_vec3 center;
    double radius;
    if (!csg_quadric_ball(quadric, &center, &radius) || !(seen_radius >= radius) ||
        !isfinite(seen_radius) || !csg_screen_takes_ball(screen, center, radius))
        return false;
    memset(texels, 0, CSG_QUADRIC_TEXELS * sizeof *texels);
    csg_screen_ball(screen, at, center, radius, texels);
    return true;
}

void csg_screen_quadric(const struct csg_screen *screen, struct csg_pixel at,
                        const struct csg_quadric *quadric, bool flipped, bool convex, int sheet,
                        struct csg_vec3 center, double radius, double texels[CSG_QUADRIC_TEXELS][4])
{
    if (put_ball(screen, at, quadric, radius, texels)) {
        texels[0][3] =
            CSG_QUADRIC_X_MINUS + region_code(screen, quadric, 1, flipped, convex, sheet);
        return;
    }
    const struct csg_pixel here = csg_screen_pixel(screen, center);
    const double shift[2] = {here.x - at.x, here.y - at.y};
    const double span = key_span(screen, center, radius);
    const double pixels = pixel_radius(screen, center, radius);
    struct pencil pencil = pencil_at(screen, here, &quadric->to_canon);
    diagonalise(&pencil, quadric);
    const struct quadratic f = quadratic_of(&pencil, span);
    const double reach = fmin(size_of_middle(&f, pixels), size_of_root(&f, pixels));
    const bool stiff = reach > STIFF_RATIO * span;
    /* f's own scale is free: divide by a, or, where a is nearly nothing, by b's size. */
    const double scale =
        stiff ? 1 / (fabs(f.b[0]) + pixels * (fabs(f.b[1]) + fabs(f.b[2])) + fabs(f.a) * span)
              : -1 / f.a;
    double s[6];
    for (int i = 0; i < 6; i++)
        s[i] = f.s[i] * scale * scale;
    const struct csg_conic_axes axes = csg_conic_axes_of(s, pixels);
    memset(texels, 0, CSG_QUADRIC_TEXELS * sizeof *texels);
    put_affine(texels[0], scale * f.b[0], scale * f.b[1], scale * f.b[2], shift);
    put_affine(texels[1], axes.ox, axes.size * axes.ex[0], axes.size * axes.ex[1], shift);
    put_affine(texels[2], axes.oy, axes.size * axes.ey[0], axes.size * axes.ey[1], shift);
    texels[1][3] = csg_conic_clamp(axes.c0);
    texels[2][1] = csg_conic_clamp(axes.cx); /* y' takes its direction from x' */
    texels[2][2] = csg_conic_clamp(axes.cy);
    texels[2][3] = csg_conic_clamp(axes.ly);
    int code = region_code(screen, quadric, f.a, flipped, convex, sheet);
    code += axes.sign_x > 0 ? CSG_QUADRIC_X_PLUS : axes.sign_x < 0 ? CSG_QUADRIC_X_MINUS : 0;
    if (stiff) {
        code += CSG_QUADRIC_STIFF;
        csg_conic_put(&texels[3], f.c, &axes, scale);
        texels[3][3] = csg_conic_clamp(1 / (scale * f.a));
    }
    texels[0][3] = code;
}

void csg_screen_section(const struct csg_screen *screen, struct csg_pixel at,
                        const struct csg_quadric *quadric, bool flipped, const double plane[4],
                        double conic[6])
{
    struct pencil pencil = pencil_at(screen, at, &quadric->to_canon);
    diagonalise(&pencil, quadric);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            pencil.p[i][j] += plane[i] * pencil.w[j];
    for (int n = 0; n < 6; n++) {
        const int i = conic_terms[n][0], j = conic_terms[n][1];
        const double twice = i == j ? 1 : 2;
        conic[n] = (flipped ? -twice : twice) * form(pencil.q, pencil.p[i], pencil.p[j]);
    }
}

/* The middle of the two crossings. Where that is far away, the leaf's own, if it is before the eye.
 */
void csg_screen_base(const struct csg_screen *screen, const double texels[CSG_QUADRIC_TEXELS][4],
                     struct csg_vec3 center, double radius, float base[3])
{
    const bool stiff = (int)texels[0][3] & CSG_QUADRIC_STIFF;
    const double t = csg_dot(csg_sub(center, screen->origin), screen->forward);
    const bool before = screen->orthographic ? isfinite(radius) : radius < 0.5 * t;
    base[0] = base[1] = base[2] = 0;
    if (stiff && before)
        base[0] = (float)csg_screen_key(screen, t);
    for (int i = 0; i < 3 && !stiff; i++)
        base[i] = (float)texels[0][i];
}

/* Half the gradient of f, Q p in canonical space, carried back: affine in the pixel and k. */
void csg_screen_normal(const struct csg_screen *screen, struct csg_pixel at,
                       const struct csg_quadric *quadric, const float base[3], float terms[4][3])
{
    const struct pencil pencil = pencil_at(screen, at, &quadric->to_canon);
    const int8_t *d = quadric->diag;
    struct csg_vec3 normals[4];
    double largest = 0;
    for (int i = 0; i < 4; i++) {
        const double *p = i < 3 ? pencil.p[i] : pencil.w;
        const struct csg_vec3 canonical =
            csg_vec3(d[0] * p[0], d[1] * p[1], d[2] * p[2] + quadric->linear * p[3]);
        normals[i] = csg_map_transposed(&quadric->to_canon, canonical);
    }
    for (int i = 0; i < 4; i++) {
        if (i < 3)
            normals[i] = csg_add(normals[i], csg_scale((double)base[i], normals[3]));
        largest = fmax(largest, csg_length(normals[i]));
    }
    for (int i = 0; i < 4; i++) {
        const struct csg_vec3 n = csg_scale(largest > 0 ? 1 / largest : 1, normals[i]);
        terms[i][0] = (float)n.x;
        terms[i][1] = (float)n.y;
        terms[i][2] = (float)n.z;
    }
}
