/* SPDX-License-Identifier: MIT */
#include "crowd/occlusion.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "pack/ball.h"

/* Share of a ball's largest h (of its depth in keys, squared) from which on it certainly hides. */
#define CERTAIN 1e-3f

/* Rounding of keys, in float terms and in the depth buffer. */
#define KEY_NOISE 1e-6

/* Fewer are drawn sooner than compared. */
enum { MIN_OCCLUDERS = 64 };

enum { NUM_BINS = 256, NUM_BANDS = 16 };

/* How far apart two keys of this size must be for the nearer one to win in the depth buffer. */
static double key_noise(const struct csg_screen *screen, double key)
{
    return KEY_NOISE * (fabs(key) + 1 / (double)screen->depth[0]);
}

float csg_occlusion_near(const struct csg_screen *screen, double t)
{
    const double key = csg_screen_key(screen, t);
    return (float)(key - key_noise(screen, key));
}

/* ---- who hides others ---- */

static bool hides(const struct csg_cull *cull, const struct csg_candidate *candidate)
{
    return cull->crowd->opaque[candidate->member];
}

/* Roughly in order of depth: bins between the nearest and the farthest key. */
struct bins {
    float lo, hi;
    size_t next[NUM_BINS];
};

static int bin_of(const struct bins *bins, float key)
{
    const float place = (key - bins->lo) / (bins->hi - bins->lo);
    return place < 1 ? place > 0 ? (int)(place * NUM_BINS) : 0 : NUM_BINS - 1;
}

typedef void visit_fn(struct csg_cull *cull, struct bins *bins, const struct csg_candidate *);

static void visit_occluders(struct csg_cull *cull, struct bins *bins, visit_fn *visit)
{
    for (size_t i = 0; i < cull->blocks.num; i++) {
        const struct csg_crowd_block *block = &cull->blocks.data[i];
        if (!cull->crowd->classes[block->class].ball)
            continue;
        for (uint32_t j = 0; j < block->num; j++)
            if (hides(cull, &cull->candidates[block->begin + j]))
                visit(cull, bins, &cull->candidates[block->begin + j]);
    }
}

static void extend(struct csg_cull *cull, struct bins *bins, const struct csg_candidate *candidate)
{
    (void)cull;
    bins->lo = fminf(bins->lo, candidate->key);
    bins->hi = fmaxf(bins->hi, candidate->key);
}

static void count(struct csg_cull *cull, struct bins *bins, const struct csg_candidate *candidate)
{
    bins->next[bin_of(bins, candidate->key)]++;
    cull->num_occluders++;
}

static void place(struct csg_cull *cull, struct bins *bins, const struct csg_candidate *candidate)
{
    cull->occluders[bins->next[bin_of(bins, candidate->key)]++] = *candidate;
}

/* false: out of memory. */
static bool list_occluders(struct csg_cull *cull)
{
    struct bins bins = {.lo = INFINITY, .hi = -INFINITY};
    visit_occluders(cull, &bins, extend);
    visit_occluders(cull, &bins, count);
    cull->occluders = malloc((cull->num_occluders + 1) * sizeof *cull->occluders);
    if (!cull->occluders)
        return false;
    size_t sum = 0;
    for (int i = 0; i < NUM_BINS; i++) {
        const size_t num = bins.next[i];
        bins.next[i] = sum;
        sum += num;
    }
    visit_occluders(cull, &bins, place);
    return true;
}

/* ---- the picture ---- */

/* Twin of csg_quadric in shaders/solids/quadric.glsl, for a row of pixels from d on. */
static void draw_row(const float (*texels)[4], float noise, float dx, float dy, int num,
                     float *keys)
{
    const float m = texels[0][0] + texels[0][2] * dy, mx = texels[0][1];
    const float x0 = texels[1][0] + texels[1][2] * dy, xx = texels[1][1];
    const float y0 = texels[2][0] + texels[1][1] * dy, yx = texels[1][2];
    const float c0 = texels[1][3], ly = texels[2][3], least = CERTAIN * c0;
    for (int i = 0; i < num; i++) {
        const float d = dx + (float)i, x = x0 + xx * d, y = y0 - yx * d;
        const float h = c0 + ly * (y * y) - x * x;
        const float key = m + mx * d - sqrtf(h > 0 ? h : 0) + noise;
        const float old = keys[i];
        keys[i] = h > least && key < old ? key : old;
    }
}

static bool shows_in(const struct csg_cull *cull, const struct csg_candidate *candidate, int first,
                     int last)
{
    const int width = cull->screen->width;
    for (int y = first; y <= last; y++) {
        const float *row = cull->keys + (size_t)y * (size_t)width;
        for (int x = candidate->lo[0]; x <= candidate->hi[0]; x++)
            if (row[x] > candidate->key)
                return true;
    }
    return false;
}

/* Rows first to last of an occluder. */
static void draw(const struct csg_cull *cull, const struct csg_candidate *occluder, int first,
                 int last)
{
    const struct csg_crowd *crowd = cull->crowd;
    const uint32_t member = occluder->member;
    const struct csg_vec3 center = {crowd->x[member], crowd->y[member], crowd->z[member]};
    const float noise = (float)key_noise(cull->screen, (double)occluder->key);
    const int x = occluder->lo[0];
    double terms[CSG_BALL_TEXELS][4];
    float texels[CSG_BALL_TEXELS][4];
    csg_screen_ball(cull->screen, cull->at, center, crowd->radius[member], terms);
    for (int i = 0; i < 4 * CSG_BALL_TEXELS; i++)
        texels[i / 4][i % 4] = (float)terms[i / 4][i % 4];
    for (int y = first; y <= last; y++)
        draw_row((const float(*)[4])texels, noise, (float)(x + 0.5 - cull->at.x),
                 (float)(y + 0.5 - cull->at.y), occluder->hi[0] - x + 1,
                 cull->keys + (size_t)y * (size_t)cull->screen->width + x);
}

/* The nearest first: most of the others then are found to be hidden before their terms are. */
static void draw_band(void *user, size_t task)
{
    struct csg_cull *cull = user;
    const int width = cull->screen->width, height = cull->screen->height;
    const int begin = (int)((int64_t)height * (int)task / NUM_BANDS);
    const int end = (int)((int64_t)height * ((int)task + 1) / NUM_BANDS) - 1;
    for (size_t i = (size_t)begin * (size_t)width; i < (size_t)(end + 1) * (size_t)width; i++)
        cull->keys[i] = CSG_KEY_MAX;
    for (size_t i = 0; i < cull->num_occluders; i++) {
        const struct csg_candidate *occluder = &cull->occluders[i];
        const int first = occluder->lo[1] > begin ? occluder->lo[1] : begin;
        const int last = occluder->hi[1] < end ? occluder->hi[1] : end;
        if (first <= last && shows_in(cull, occluder, first, last))
            draw(cull, occluder, first, last);
    }
}

bool csg_occlusion_draw(struct csg_cull *cull)
{
    if (!csg_screen_is_square(cull->screen))
        return true;
    if (!list_occluders(cull))
        return false;
    if (cull->num_occluders < MIN_OCCLUDERS)
        return true;
    cull->keys =
        malloc((size_t)cull->screen->width * (size_t)cull->screen->height * sizeof *cull->keys);
    if (!cull->keys)
        return false;
    csg_parallel(NUM_BANDS, draw_band, cull);
    return true;
}

bool csg_occlusion_shows(const struct csg_cull *cull, const struct csg_candidate *candidate)
{
    return shows_in(cull, candidate, candidate->lo[1], candidate->hi[1]);
}
