/* SPDX-License-Identifier: MIT */
#include "crowd/occlusion.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "crowd/cast.h"

/* Rounding of keys, in float terms and in the depth buffer. */
#define KEY_NOISE 1e-6

/* Fewer are drawn sooner than compared. */
enum { MIN_OCCLUDERS = 64 };

enum { NUM_BINS = 256, NUM_BANDS = 16 };

static const struct csg_screen *screen_of(const struct csg_cull *cull)
{
    return &cull->view.frame->screen;
}

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
    return cull->view.crowd->opaque[candidate->member];
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

static struct csg_cast_rect offsets_of(const struct csg_cull *cull,
                                       const struct csg_candidate *candidate)
{
    const struct csg_pixel at = cull->view.frame->at;
    const double offset[2] = {0.5 - at.x, 0.5 - at.y};
    struct csg_cast_rect rect;
    for (int i = 0; i < 2; i++) {
        rect.lo[i] = (float)(candidate->lo[i] + offset[i]);
        rect.hi[i] = (float)(candidate->hi[i] + offset[i]);
    }
    return rect;
}

/* false: it is no member that can be cast. */
static bool prepare(const struct csg_cull *cull, const struct csg_candidate *candidate,
                    const float *terms, struct csg_cast_rect *rect, struct csg_cast *cast)
{
    const float noise = (float)key_noise(screen_of(cull), (double)candidate->key);
    *rect = offsets_of(cull, candidate);
    return terms &&
           csg_cast_init(cast, &cull->view.crowd->classes[candidate->class], terms, rect, noise);
}

static float *row_of(const struct csg_cull *cull, int y)
{
    return cull->keys + (size_t)y * (size_t)screen_of(cull)->width;
}

/* Whether something of the rectangle is as near as the candidate. */
static bool shows_in(const struct csg_cull *cull, const struct csg_candidate *candidate, int first,
                     int last)
{
    for (int y = first; y <= last; y++) {
        const float *row = row_of(cull, y);
        for (int x = candidate->lo[0]; x <= candidate->hi[0]; x++)
            if (row[x] > candidate->key)
                return true;
    }
    return false;
}

static int lanes_left(const struct csg_candidate *candidate, int x)
{
    const int left = candidate->hi[0] - x + 1;
    return left < CSG_CAST_LANES ? left : CSG_CAST_LANES;
}

/* Rows first to last of an occluder. */
static void draw(struct csg_cull *cull, const struct csg_candidate *occluder, const float *terms,
                 int first, int last)
{
    struct csg_cast_rect rect;
    struct csg_cast cast;
    float near[CSG_CAST_LANES], far[CSG_CAST_LANES];
    if (!prepare(cull, occluder, terms, &rect, &cast))
        return;
    for (int y = first; y <= last; y++)
        for (int x = occluder->lo[0]; x <= occluder->hi[0]; x += CSG_CAST_LANES) {
            float *keys = row_of(cull, y) + x;
            csg_cast_row(&cast, rect.lo[0] + (float)(x - occluder->lo[0]),
                         rect.lo[1] + (float)(y - occluder->lo[1]), near, far);
            for (int i = 0, num = lanes_left(occluder, x); i < num; i++)
                keys[i] = far[i] < keys[i] ? far[i] : keys[i];
        }
}

/* Terms for a band: those that all may use are found by the one in which the occluder begins. */
static const float *terms_in(struct csg_cull *cull, const struct csg_candidate *occluder, int begin,
                             float *own)
{
    const struct csg_crowd_class *class = &cull->view.crowd->classes[occluder->class];
    if (occluder->lo[1] >= begin)
        return csg_cull_terms(cull, occluder->class, occluder->member);
    return csg_member_terms(&cull->view, class, occluder->member, own) ? own : NULL;
}

/* The nearest first: most of the others then are found to be hidden before their terms are. */
static void draw_band(void *user, size_t task)
{
    struct csg_cull *cull = user;
    const int width = screen_of(cull)->width, height = screen_of(cull)->height;
    const int begin = (int)((int64_t)height * (int)task / NUM_BANDS);
    const int end = (int)((int64_t)height * ((int)task + 1) / NUM_BANDS) - 1;
    float own[12 + 4 * CSG_CROWD_MAX_PLANES];
    for (size_t i = (size_t)begin * (size_t)width; i < (size_t)(end + 1) * (size_t)width; i++)
        cull->keys[i] = CSG_KEY_MAX;
    for (size_t i = 0; i < cull->num_occluders; i++) {
        const struct csg_candidate *occluder = &cull->occluders[i];
        const int first = occluder->lo[1] > begin ? occluder->lo[1] : begin;
        const int last = occluder->hi[1] < end ? occluder->hi[1] : end;
        if (first <= last && shows_in(cull, occluder, first, last))
            draw(cull, occluder, terms_in(cull, occluder, begin, own), first, last);
    }
}

bool csg_occlusion_draw(struct csg_cull *cull)
{
    if (!cull->view.square)
        return true;
    if (!list_occluders(cull))
        return false;
    if (cull->num_occluders < MIN_OCCLUDERS)
        return true;
    cull->keys =
        malloc((size_t)screen_of(cull)->width * (size_t)screen_of(cull)->height * sizeof *cull->keys);
    if (!cull->keys)
        return false;
    csg_parallel(NUM_BANDS, draw_band, cull);
    return true;
}

/* The pixels at which it may show, by casting it. */
static bool narrow(const struct csg_cull *cull, const struct csg_cast *cast,
                   const struct csg_cast_rect *rect, struct csg_candidate *candidate)
{
    const struct csg_candidate all = *candidate;
    float near[CSG_CAST_LANES], far[CSG_CAST_LANES];
    int lo[2] = {INT16_MAX, INT16_MAX}, hi[2] = {-1, -1};
    for (int y = all.lo[1]; y <= all.hi[1]; y++)
        for (int x = all.lo[0]; x <= all.hi[0]; x += CSG_CAST_LANES) {
            const float *keys = row_of(cull, y) + x;
            csg_cast_row(cast, rect->lo[0] + (float)(x - all.lo[0]),
                         rect->lo[1] + (float)(y - all.lo[1]), near, far);
            for (int i = 0, num = lanes_left(&all, x); i < num; i++) {
                if (near[i] > keys[i] || near[i] >= CSG_KEY_MAX)
                    continue;
                lo[0] = x + i < lo[0] ? x + i : lo[0];
                hi[0] = x + i > hi[0] ? x + i : hi[0];
                lo[1] = y < lo[1] ? y : lo[1];
                hi[1] = y;
            }
        }
    for (int i = 0; i < 2; i++) {
        candidate->lo[i] = (int16_t)lo[i];
        candidate->hi[i] = (int16_t)hi[i];
    }
    return hi[1] >= 0;
}

bool csg_occlusion_shows(struct csg_cull *cull, struct csg_candidate *candidate)
{
    struct csg_cast_rect rect;
    struct csg_cast cast;
    if (!shows_in(cull, candidate, candidate->lo[1], candidate->hi[1]))
        return false;
    const float *terms = csg_cull_terms(cull, candidate->class, candidate->member);
    return !prepare(cull, candidate, terms, &rect, &cast) ||
           narrow(cull, &cast, &rect, candidate);
}
