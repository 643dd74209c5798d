/* SPDX-License-Identifier: MIT */
#include "crowd/occlusion.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "crowd/cast.h"
#include "crowd/occluders.h"

/* Rounding of keys, in float terms and in the depth buffer. */
#define KEY_NOISE 1e-6

/* Fewer are drawn sooner than compared. */
enum { MIN_OCCLUDERS = 64 };

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

/* Rows have room for lanes behind their end. */
static size_t stride_of(const struct csg_cull *cull)
{
    return (size_t)screen_of(cull)->width + CSG_CAST_LANES;
}

static float *row_of(const struct csg_cull *cull, int y)
{
    return cull->keys + (size_t)y * stride_of(cull);
}

static int lanes_left(const struct csg_candidate *candidate, int x)
{
    const int left = candidate->hi[0] - x + 1;
    return left < CSG_CAST_LANES ? left : CSG_CAST_LANES;
}

/* Whether something of the rectangle is as near as the candidate. */
static bool shows_in(const struct csg_cull *cull, const struct csg_candidate *candidate, int first,
                     int last)
{
    for (int y = first; y <= last; y++) {
        const float *row = row_of(cull, y);
        for (int x = candidate->lo[0]; x <= candidate->hi[0]; x += CSG_CAST_LANES)
            if (csg_cast_any_behind(candidate->key, lanes_left(candidate, x), row + x))
                return true;
    }
    return false;
}

/* Rows first to last of an occluder. */
static void draw(struct csg_cull *cull, const struct csg_candidate *occluder, const float *terms,
                 int first, int last)
{
    struct csg_cast_rect rect;
    struct csg_cast cast;
    if (!prepare(cull, occluder, terms, &rect, &cast))
        return;
    for (int y = first; y <= last; y++)
        for (int x = occluder->lo[0]; x <= occluder->hi[0]; x += CSG_CAST_LANES)
            csg_cast_draw(&cast, rect.lo[0] + (float)(x - occluder->lo[0]),
                          rect.lo[1] + (float)(y - occluder->lo[1]), lanes_left(occluder, x),
                          row_of(cull, y) + x);
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

struct drawing {
    struct csg_cull *cull;
    struct csg_occluders occluders;
};

/* The nearest first: most of the others then are found to be hidden before their terms are. */
static void draw_band(void *user, size_t task)
{
    const struct drawing *drawing = user;
    const struct csg_occluders *occluders = &drawing->occluders;
    struct csg_cull *cull = drawing->cull;
    const int begin = csg_band_begin(cull, task), end = csg_band_begin(cull, task + 1) - 1;
    float own[12 + 4 * CSG_CROWD_MAX_PLANES];
    for (float *key = row_of(cull, begin); key < row_of(cull, end + 1); key++)
        *key = CSG_KEY_MAX;
    for (size_t i = occluders->begin[task]; i < occluders->begin[task + 1]; i++) {
        const struct csg_candidate *occluder = &cull->candidates[occluders->order[i]];
        const int first = occluder->lo[1] > begin ? occluder->lo[1] : begin;
        const int last = occluder->hi[1] < end ? occluder->hi[1] : end;
        if (!shows_in(cull, occluder, first, last))
            continue;
        atomic_store_explicit(&cull->drawn[occluder->member], true, memory_order_relaxed);
        draw(cull, occluder, terms_in(cull, occluder, begin, own), first, last);
    }
}

bool csg_occlusion_draw(struct csg_cull *cull)
{
    struct drawing drawing = {.cull = cull};
    if (!cull->view.square)
        return true;
    bool ok = csg_occluders_fill(&drawing.occluders, cull);
    if (ok && drawing.occluders.num >= MIN_OCCLUDERS) {
        cull->keys = malloc(stride_of(cull) * (size_t)screen_of(cull)->height * sizeof *cull->keys);
        cull->drawn = calloc(cull->view.crowd->num + 1, sizeof *cull->drawn);
        ok = cull->keys && cull->drawn;
        if (ok)
            csg_parallel(CSG_NUM_BANDS, draw_band, &drawing);
    }
    csg_occluders_finish(&drawing.occluders);
    return ok;
}

static int lowest(unsigned set)
{
    int i = 0;
    while (!(set >> i & 1))
        i++;
    return i;
}

static int highest(unsigned set)
{
    int i = 0;
    while (set >> i > 1)
        i++;
    return i;
}

/* The pixels at which it may show, by casting it. */
static bool narrow(const struct csg_cull *cull, const struct csg_cast *cast,
                   const struct csg_cast_rect *rect, struct csg_candidate *candidate)
{
    const struct csg_candidate all = *candidate;
    int lo[2] = {INT16_MAX, INT16_MAX}, hi[2] = {-1, -1};
    for (int y = all.lo[1]; y <= all.hi[1]; y++)
        for (int x = all.lo[0]; x <= all.hi[0]; x += CSG_CAST_LANES) {
            const unsigned shows = csg_cast_shows(
                cast, rect->lo[0] + (float)(x - all.lo[0]), rect->lo[1] + (float)(y - all.lo[1]),
                lanes_left(&all, x), row_of(cull, y) + x);
            if (!shows)
                continue;
            lo[0] = x + lowest(shows) < lo[0] ? x + lowest(shows) : lo[0];
            hi[0] = x + highest(shows) > hi[0] ? x + highest(shows) : hi[0];
            lo[1] = y < lo[1] ? y : lo[1];
            hi[1] = y;
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
    /* What was hidden when its turn came still is. */
    if (csg_hides_others(cull, candidate) && !cull->drawn[candidate->member])
        return false;
    if (!shows_in(cull, candidate, candidate->lo[1], candidate->hi[1]))
        return false;
    const float *terms = csg_cull_terms(cull, candidate->class, candidate->member);
    return !prepare(cull, candidate, terms, &rect, &cast) ||
           narrow(cull, &cast, &rect, candidate);
}
