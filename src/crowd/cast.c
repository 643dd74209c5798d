/* SPDX-License-Identifier: MIT */
#include "crowd/cast.h"

#include <math.h>

#include "common/layout.glsl"

/* Bound of the rounding of a term of a few float operations, as a share of its largest part. */
#define ROUNDING 5e-7f

/* ---- bounds ---- */

static float larger(float a, float b)
{
    return a > b ? a : b;
}

/* An affine term over the rectangle: its rounding, and its largest size. */
static float affine_noise(float c, float cx, float cy, const struct csg_cast_rect *rect,
                          float *largest)
{
    const float x = 0.5f * (rect->lo[0] + rect->hi[0]), y = 0.5f * (rect->lo[1] + rect->hi[1]);
    const float half = 0.5f * (fabsf(cx) * (rect->hi[0] - rect->lo[0]) +
                               fabsf(cy) * (rect->hi[1] - rect->lo[1]));
    const float reach[2] = {larger(fabsf(rect->lo[0]), fabsf(rect->hi[0])),
                            larger(fabsf(rect->lo[1]), fabsf(rect->hi[1]))};
    const float noise =
        ROUNDING * (fabsf(c) + fabsf(cx) * reach[0] + fabsf(cy) * reach[1]);
    *largest = fabsf(c + cx * x + cy * y) + half + noise;
    return noise;
}

/* h = c0 + y (cy + ly y) + x (cx +- x) moves by its own rounding and by that of x and y. */
static void bound_quadric(struct csg_cast *cast, const struct csg_cast_rect *rect)
{
    const float *t = cast->quadric;
    float middle, x, y;
    const float middle_noise = affine_noise(t[0], t[1], t[2], rect, &middle);
    const float x_noise = affine_noise(t[4], t[5], t[6], rect, &x);
    const float y_noise = affine_noise(t[8], -t[6], t[5], rect, &y);
    const float c0 = fabsf(t[7]), cx = fabsf(t[9]), cy = fabsf(t[10]), ly = fabsf(t[11]);
    const float size = c0 + y * (cy + ly * y) + x * (cx + x);
    cast->conic_noise =
        ROUNDING * size + y_noise * (cy + 2 * ly * y) + x_noise * (cx + 2 * x);
    cast->quadric_noise = cast->noise + middle_noise + ROUNDING * sqrtf(size);
}

bool csg_cast_init(struct csg_cast *cast, const struct csg_crowd_class *class, const float *terms,
                   const struct csg_cast_rect *rect, float noise)
{
    *cast = (struct csg_cast){.quadric = class->has_quadric ? terms : NULL,
                              .planes = terms + (class->has_quadric ? 12 : 0),
                              .num_planes = class->num_planes,
                              .noise = noise};
    if (cast->quadric && ((int)terms[3] & 3) != CSG_QUADRIC_BETWEEN)
        return false;
    float worst = 0; /* an overflow or NaN shows in the bounds */
    if (cast->quadric) {
        bound_quadric(cast, rect);
        worst = cast->quadric_noise + cast->conic_noise;
    }
    for (uint32_t i = 0; i < cast->num_planes; i++) {
        const float *t = cast->planes + 4 * i;
        float largest;
        cast->plane_noise[i] = noise + affine_noise(t[0], t[1], t[2], rect, &largest);
        worst += cast->plane_noise[i];
    }
    return worst < CSG_KEY_MAX;
}

/* ---- a row: loops of fixed length without branches, for the compiler to make vectors of ---- */

/* Twice as wide where the processor has them; the choice is made when the library is loaded, which
 * the sanitizers do not bear. Static: gcc exports clones of what is not. */
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) &&   \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WIDE static __attribute__((target_clones("avx2", "default")))
#define PART static inline __attribute__((always_inline))
#else
#define WIDE static
#define PART static
#endif

/* Bounds of where a ray enters and leaves. */
struct spans {
    float entry_lo[CSG_CAST_LANES], entry_hi[CSG_CAST_LANES];
    float exit_lo[CSG_CAST_LANES], exit_hi[CSG_CAST_LANES];
};

PART void start(struct spans *spans)
{
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        spans->entry_lo[i] = spans->entry_hi[i] = -CSG_KEY_MAX;
        spans->exit_lo[i] = spans->exit_hi[i] = CSG_KEY_MAX;
    }
}

/* Twin of csg_quadric in shaders/solids/quadric.glsl. Where h may be negative the ray may miss. */
PART void start_quadric(const struct csg_cast *cast, float dx, float dy, struct spans *spans)
{
    const float *t = cast->quadric;
    const int code = (int)t[3];
    const float sign = code & CSG_QUADRIC_X_MINUS ? -1.f : code & CSG_QUADRIC_X_PLUS ? 1.f : 0.f;
    const float m0 = t[0] + t[2] * dy, mx = t[1];
    const float x0 = t[4] + t[6] * dy, xx = t[5];
    const float y0 = t[8] + t[5] * dy, yx = -t[6];
    const float c0 = t[7], cx = t[9], cy = t[10], ly = t[11];
    const float noise = cast->quadric_noise, conic_noise = cast->conic_noise;
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float d = dx + (float)i, m = m0 + mx * d, x = x0 + xx * d, y = y0 + yx * d;
        const float h = c0 + y * (cy + ly * y) + x * (cx + sign * x);
        const float h_hi = h + conic_noise, h_lo = h - conic_noise;
        const float root_hi = sqrtf(h_hi > 0 ? h_hi : 0), root_lo = sqrtf(h_lo > 0 ? h_lo : 0);
        const float entry_lo = m - root_hi - noise, entry_hi = m - root_lo + noise;
        spans->entry_lo[i] = h_hi < 0 ? CSG_KEY_MAX : entry_lo;
        spans->exit_hi[i] = m + root_hi + noise;
        spans->entry_hi[i] = h_lo > 0 ? entry_hi : CSG_KEY_MAX;
        spans->exit_lo[i] = m + root_lo - noise;
    }
}

PART void enter(const float *t, float noise, float dx, float dy, struct spans *spans)
{
    const float k0 = t[0] + t[2] * dy, kx = t[1];
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float k = k0 + kx * (dx + (float)i), lo = k - noise, hi = k + noise;
        spans->entry_lo[i] = lo > spans->entry_lo[i] ? lo : spans->entry_lo[i];
        spans->entry_hi[i] = hi > spans->entry_hi[i] ? hi : spans->entry_hi[i];
    }
}

PART void leave(const float *t, float noise, float dx, float dy, struct spans *spans)
{
    const float k0 = t[0] + t[2] * dy, kx = t[1];
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float k = k0 + kx * (dx + (float)i), lo = k - noise, hi = k + noise;
        spans->exit_lo[i] = lo < spans->exit_lo[i] ? lo : spans->exit_lo[i];
        spans->exit_hi[i] = hi < spans->exit_hi[i] ? hi : spans->exit_hi[i];
    }
}

PART void cast_row(const struct csg_cast *cast, float dx, float dy, struct spans *spans)
{
    if (cast->quadric)
        start_quadric(cast, dx, dy, spans);
    else
        start(spans);
    for (uint32_t i = 0; i < cast->num_planes; i++) {
        const float *t = cast->planes + 4 * i;
        if (t[3] > 0)
            leave(t, cast->plane_noise[i], dx, dy, spans);
        else
            enter(t, cast->plane_noise[i], dx, dy, spans);
    }
}

WIDE void draw(const struct csg_cast *cast, float dx, float dy, int num, float *keys)
{
    struct spans spans;
    cast_row(cast, dx, dy, &spans);
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float far = spans.entry_hi[i] < spans.exit_lo[i] ? spans.entry_hi[i] : CSG_KEY_MAX;
        const float old = keys[i], key = far < old ? far : old;
        keys[i] = i < num ? key : old;
    }
}

/* Lane i is bit i. */
static const unsigned bits[CSG_CAST_LANES] = {1, 2, 4, 8, 16, 32, 64, 128};

WIDE unsigned shows_in(const struct csg_cast *cast, float dx, float dy, int num, const float *keys)
{
    struct spans spans;
    unsigned shows = 0;
    cast_row(cast, dx, dy, &spans);
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float near = spans.entry_lo[i];
        const unsigned met = near <= spans.exit_hi[i] ? bits[i] : 0;
        shows |= near <= keys[i] ? met : 0;
    }
    return shows & ((1u << num) - 1);
}

WIDE bool any_behind(float key, int num, const float *keys)
{
    unsigned behind = 0;
    for (int i = 0; i < CSG_CAST_LANES; i++)
        behind |= keys[i] > key ? bits[i] : 0;
    return behind & ((1u << num) - 1);
}

void csg_cast_draw(const struct csg_cast *cast, float dx, float dy, int num, float *keys)
{
    draw(cast, dx, dy, num, keys);
}

unsigned csg_cast_shows(const struct csg_cast *cast, float dx, float dy, int num, const float *keys)
{
    return shows_in(cast, dx, dy, num, keys);
}

bool csg_cast_any_behind(float key, int num, const float *keys)
{
    return any_behind(key, num, keys);
}
