/* SPDX-License-Identifier: MIT */
#include "crowd/cast.h"

#include <math.h>

#include "common/wide.h"
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
    const float half =
        0.5f * (fabsf(cx) * (rect->hi[0] - rect->lo[0]) + fabsf(cy) * (rect->hi[1] - rect->lo[1]));
    const float reach[2] = {larger(fabsf(rect->lo[0]), fabsf(rect->hi[0])),
                            larger(fabsf(rect->lo[1]), fabsf(rect->hi[1]))};
    const float noise = ROUNDING * (fabsf(c) + fabsf(cx) * reach[0] + fabsf(cy) * reach[1]);
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
    cast->conic_noise = ROUNDING * size + y_noise * (cy + 2 * ly * y) + x_noise * (cx + 2 * x);
    cast->quadric_noise = cast->noise + middle_noise + ROUNDING * sqrtf(size);
}

bool csg_cast_init(struct csg_cast *cast, bool has_quadric, uint32_t num_planes, const float *terms,
                   const struct csg_cast_rect *rect, float noise)
{
    *cast = (struct csg_cast){.quadric = has_quadric ? terms : NULL,
                              .planes = terms + (has_quadric ? 12 : 0),
                              .num_planes = num_planes,
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

/* ---- a row ---- */

PART void start(struct csg_spans *spans)
{
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        spans->entry_lo[i] = spans->entry_hi[i] = -CSG_KEY_MAX;
        spans->exit_lo[i] = spans->exit_hi[i] = CSG_KEY_MAX;
    }
}

/* Of x^2 in the conic. */
PART float sign_of(const float *quadric)
{
    const int code = (int)quadric[3];
    return code & CSG_QUADRIC_X_MINUS ? -1.f : code & CSG_QUADRIC_X_PLUS ? 1.f : 0.f;
}

/* Twin of csg_quadric in shaders/solids/quadric.glsl. Where h may be negative the ray may miss. */
PART void start_quadric(const struct csg_cast *cast, float dx, float dy, struct csg_spans *spans)
{
    const float *t = cast->quadric;
    const float sign = sign_of(t), m0 = t[0] + t[2] * dy, mx = t[1];
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

PART void enter(const float *t, float noise, float dx, float dy, struct csg_spans *spans)
{
    const float k0 = t[0] + t[2] * dy, kx = t[1];
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float k = k0 + kx * (dx + (float)i), lo = k - noise, hi = k + noise;
        spans->entry_lo[i] = lo > spans->entry_lo[i] ? lo : spans->entry_lo[i];
        spans->entry_hi[i] = hi > spans->entry_hi[i] ? hi : spans->entry_hi[i];
    }
}

PART void leave(const float *t, float noise, float dx, float dy, struct csg_spans *spans)
{
    const float k0 = t[0] + t[2] * dy, kx = t[1];
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float k = k0 + kx * (dx + (float)i), lo = k - noise, hi = k + noise;
        spans->exit_lo[i] = lo < spans->exit_lo[i] ? lo : spans->exit_lo[i];
        spans->exit_hi[i] = hi < spans->exit_hi[i] ? hi : spans->exit_hi[i];
    }
}

PART void cast_row(const struct csg_cast *cast, float dx, float dy, struct csg_spans *spans)
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

WIDE void all_spans(const struct csg_cast *cast, float dx, float dy, struct csg_spans *spans)
{
    cast_row(cast, dx, dy, spans);
}

void csg_cast_spans(const struct csg_cast *cast, float dx, float dy, struct csg_spans *spans)
{
    all_spans(cast, dx, dy, spans);
}

/* Of what a side does not need nothing is computed: rear is known where this is inlined. */
PART bool draw_side(const struct csg_cast *cast, bool rear, float dx, float dy, int num,
                    float *keys)
{
    struct csg_spans spans;
    cast_row(cast, dx, dy, &spans);
    const float *crossing = rear ? spans.exit_hi : spans.entry_hi;
    unsigned changed = 0;
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float far = spans.entry_hi[i] < spans.exit_lo[i] ? crossing[i] : CSG_KEY_MAX;
        const float old = keys[i], key = i < num && far < old ? far : old;
        changed |= key < old ? 1 : 0;
        keys[i] = key;
    }
    return changed != 0;
}

WIDE bool draw_front(const struct csg_cast *cast, float dx, float dy, int num, float *keys)
{
    return draw_side(cast, false, dx, dy, num, keys);
}

WIDE bool draw_rear(const struct csg_cast *cast, float dx, float dy, int num, float *keys)
{
    return draw_side(cast, true, dx, dy, num, keys);
}

/* Lane i is bit i. */
static const unsigned bits[CSG_CAST_LANES] = {1, 2, 4, 8, 16, 32, 64, 128};

PART unsigned side_shows(const struct csg_cast *cast, bool rear, float dx, float dy, int num,
                         const float *keys)
{
    struct csg_spans spans;
    unsigned shows = 0;
    cast_row(cast, dx, dy, &spans);
    const float *crossing = rear ? spans.exit_lo : spans.entry_lo;
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const unsigned met = spans.entry_lo[i] <= spans.exit_hi[i] ? bits[i] : 0;
        shows |= crossing[i] <= keys[i] ? met : 0;
    }
    return shows & ((1u << num) - 1);
}

WIDE unsigned front_shows(const struct csg_cast *cast, float dx, float dy, int num,
                          const float *keys)
{
    return side_shows(cast, false, dx, dy, num, keys);
}

WIDE unsigned rear_shows(const struct csg_cast *cast, float dx, float dy, int num,
                         const float *keys)
{
    return side_shows(cast, true, dx, dy, num, keys);
}

/* Those before the member may be nearer than it from least on, so what it hides before that is all
 * of them. */
WIDE void contend(const struct csg_cast *cast, float dx, float dy, int num, uint32_t me,
                  float *restrict keys, float *restrict least, uint32_t *restrict who,
                  struct csg_contested *restrict result)
{
    struct csg_spans spans;
    unsigned shows = 0, with_others = 0;
    cast_row(cast, dx, dy, &spans);
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float near = spans.entry_lo[i];
        const float far = spans.entry_hi[i] < spans.exit_lo[i] ? spans.entry_hi[i] : CSG_KEY_MAX;
        const bool met = (near <= spans.exit_hi[i]) & (near <= keys[i]) & (i < num);
        const bool alone = far < least[i];
        shows |= met ? bits[i] : 0;
        with_others |= (met & !alone) ? bits[i] : 0;
        const float nearer = near < least[i] ? near : least[i];
        keys[i] = (met & (far < keys[i])) ? far : keys[i];
        least[i] = met ? alone ? near : nearer : least[i];
        who[i] = met ? alone ? me : CSG_SEVERAL : who[i];
    }
    result->shows = shows;
    result->with_others = with_others;
}

WIDE bool any_behind(float key, int num, const float *keys)
{
    unsigned behind = 0;
    for (int i = 0; i < CSG_CAST_LANES; i++)
        behind |= keys[i] > key ? bits[i] : 0;
    return behind & ((1u << num) - 1);
}

bool csg_cast_draw(const struct csg_cast *cast, enum csg_cast_side side, float dx, float dy,
                   int num, float *keys)
{
    return side == CSG_CAST_REAR ? draw_rear(cast, dx, dy, num, keys)
                                 : draw_front(cast, dx, dy, num, keys);
}

unsigned csg_cast_shows(const struct csg_cast *cast, enum csg_cast_side side, float dx, float dy,
                        int num, const float *keys)
{
    return side == CSG_CAST_REAR ? rear_shows(cast, dx, dy, num, keys)
                                 : front_shows(cast, dx, dy, num, keys);
}

struct csg_contested csg_cast_contend(const struct csg_cast *cast, float dx, float dy, int num,
                                      uint32_t who, const struct csg_contest *contest)
{
    struct csg_contested result;
    contend(cast, dx, dy, num, who, contest->keys, contest->least, contest->who, &result);
    return result;
}

bool csg_cast_any_behind(float key, int num, const float *keys)
{
    return any_behind(key, num, keys);
}

/* ---- a rectangle, by interval arithmetic ---- */

struct range {
    float lo, hi;
};

static float smaller(float a, float b)
{
    return a < b ? a : b;
}

static struct range affine_range(const float terms[3], const struct csg_cast_rect *rect,
                                 const struct csg_tilt *tilt)
{
    float middle = terms[0], half = 0;
    for (int i = 0; i < 2; i++) {
        const float at = 0.5f * (rect->lo[i] + rect->hi[i]);
        middle += terms[1 + i] * at - tilt->slope[i] * (at - tilt->at[i]);
        half += fabsf(terms[1 + i] - tilt->slope[i]) * 0.5f * (rect->hi[i] - rect->lo[i]);
    }
    return (struct range){middle - half, middle + half};
}

/* Of x (a + b x). */
static struct range square_range(float a, float b, struct range x)
{
    const float ends[2] = {x.lo * (a + b * x.lo), x.hi * (a + b * x.hi)};
    struct range range = {smaller(ends[0], ends[1]), larger(ends[0], ends[1])};
    const float top = -0.5f * a / b;
    if (b != 0 && top > x.lo && top < x.hi) {
        const float value = 0.5f * a * top;
        range.lo = smaller(range.lo, value);
        range.hi = larger(range.hi, value);
    }
    return range;
}

struct quadric_ranges {
    struct range middle, x, y, h;
};

static struct quadric_ranges quadric_ranges(const struct csg_cast *cast,
                                            const struct csg_cast_rect *rect,
                                            const struct csg_tilt *tilt)
{
    const float *t = cast->quadric, x_terms[3] = {t[4], t[5], t[6]};
    const float y_terms[3] = {t[8], -t[6], t[5]};
    const struct csg_tilt level = {{0, 0}, {0, 0}};
    struct quadric_ranges of = {.middle = affine_range(t, rect, tilt),
                                .x = affine_range(x_terms, rect, &level),
                                .y = affine_range(y_terms, rect, &level)};
    const struct range x = square_range(t[9], sign_of(t), of.x);
    const struct range y = square_range(t[10], t[11], of.y);
    of.h.lo = t[7] + x.lo + y.lo - cast->conic_noise;
    of.h.hi = t[7] + x.hi + y.hi + cast->conic_noise;
    return of;
}

static float middle_of(struct range range)
{
    return 0.5f * (range.lo + range.hi);
}

static struct range around_zero(struct range range)
{
    const float half = 0.5f * (range.hi - range.lo);
    return (struct range){-half, half};
}

/*
 * A lower bound of the entry m - sqrt(h) that follows its slope: sqrt(h) <= (h / r + r) / 2 for any
 * r > 0, best where r is the root at the rectangle's center. With u and v the distances of x and y
 * from there that is a polynomial in each of them, and so is m: x and y are a rotation of the
 * pixel.
 */
static float sloping_entry(const struct csg_cast *cast, const struct csg_tilt *tilt,
                           const struct quadric_ranges *of)
{
    const float *t = cast->quadric;
    const float x = middle_of(of->x), y = middle_of(of->y), sign = sign_of(t);
    const float h = t[7] + x * (t[9] + sign * x) + y * (t[10] + t[11] * y) + cast->conic_noise;
    if (!(h > 0))
        return -CSG_KEY_MAX;
    const float r = sqrtf(h), scale = 1 / (t[5] * t[5] + t[6] * t[6]);
    const float mx = t[1] - tilt->slope[0], my = t[2] - tilt->slope[1];
    const float mu = (mx * t[5] + my * t[6]) * scale, mv = (my * t[5] - mx * t[6]) * scale;
    const struct range u =
        square_range(mu - (t[9] + 2 * sign * x) / (2 * r), -sign / (2 * r), around_zero(of->x));
    const struct range v =
        square_range(mv - (t[10] + 2 * t[11] * y) / (2 * r), -t[11] / (2 * r), around_zero(of->y));
    const float bound =
        middle_of(of->middle) + u.lo + v.lo - r - cast->conic_noise / r - cast->quadric_noise;
    return bound > -CSG_KEY_MAX ? bound : -CSG_KEY_MAX; /* nor a NaN */
}

/* The quadric's part of the member's span: bounds of where it begins and ends. */
static void quadric_span(const struct csg_cast *cast, const struct csg_cast_rect *rect,
                         const struct csg_tilt *tilt, struct range *entry, struct range *exit)
{
    const struct quadric_ranges of = quadric_ranges(cast, rect, tilt);
    const float root_lo = sqrtf(larger(of.h.lo, 0)), root_hi = sqrtf(larger(of.h.hi, 0));
    const float flat = of.middle.lo - root_hi - cast->quadric_noise;
    entry->lo = of.h.hi < 0 ? CSG_KEY_MAX : larger(flat, sloping_entry(cast, tilt, &of));
    exit->lo = of.middle.lo + root_lo - cast->quadric_noise;
    exit->hi = of.middle.hi + root_hi + cast->quadric_noise;
}

float csg_cast_near(const struct csg_cast *cast, enum csg_cast_side side,
                    const struct csg_cast_rect *rect, const struct csg_tilt *tilt)
{
    struct range entry = {-CSG_KEY_MAX, 0}, exit = {CSG_KEY_MAX, CSG_KEY_MAX};
    if (cast->quadric)
        quadric_span(cast, rect, tilt, &entry, &exit);
    for (uint32_t i = 0; i < cast->num_planes; i++) {
        const float *t = cast->planes + 4 * i;
        const float noise = cast->plane_noise[i];
        const struct range k = affine_range(t, rect, tilt);
        if (t[3] > 0) {
            exit.lo = smaller(exit.lo, k.lo - noise);
            exit.hi = smaller(exit.hi, k.hi + noise);
        } else {
            entry.lo = larger(entry.lo, k.lo - noise);
        }
    }
    if (entry.lo > exit.hi)
        return CSG_KEY_MAX;
    return side == CSG_CAST_REAR ? larger(exit.lo, entry.lo) : entry.lo;
}
