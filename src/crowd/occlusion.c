/* SPDX-License-Identifier: MIT */
#include "crowd/occlusion.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "common/prefetch.h"
#include "crowd/cast.h"
#include "crowd/occluders.h"

/* Rounding of keys, in float terms and in the depth buffer. */
#define KEY_NOISE 1e-6

/* Occluders lie all over memory: so many of them are on their way. */
enum { PREFETCHED = 8 };

/* Larger ones are drawn sooner by themselves: what they own is looked up pixel by pixel. */
enum { MAX_OWNER_PIXELS = 256 };

/* Pixels of the picture for which one owner repays it: of other solids than balls more is looked
 * up. */
enum { PIXELS_PER_BALL = 256, PIXELS_PER_OTHER = 24 };

static const struct csg_screen *screen_of(const struct csg_cull *cull)
{
    return &cull->view.frame->screen;
}

double csg_occlusion_noise(const struct csg_screen *screen, double key)
{
    return KEY_NOISE * (fabs(key) + 1 / (double)screen->depth[0]);
}

float csg_occlusion_near(const struct csg_screen *screen, double t)
{
    const double key = csg_screen_key(screen, t);
    return (float)(key - csg_occlusion_noise(screen, key));
}

static void set_pixels(struct csg_candidate *candidate, const struct csg_pixels *pixels)
{
    for (int i = 0; i < 2; i++) {
        candidate->lo[i] = (int16_t)pixels->lo[i];
        candidate->hi[i] = (int16_t)pixels->hi[i];
    }
}

/* false: it is no member that can be cast. */
static bool prepare(const struct csg_cull *cull, const struct csg_relief *relief,
                    const struct csg_candidate *candidate, const float *terms,
                    struct csg_cast *cast)
{
    const struct csg_pixels pixels = csg_candidate_pixels(candidate);
    const struct csg_cast_rect rect = csg_relief_offsets(relief, &pixels);
    const struct csg_crowd_class *class = &cull->view.crowd->classes[candidate->class];
    const float noise = (float)csg_occlusion_noise(screen_of(cull), (double)candidate->key);
    return terms && csg_cast_init(cast, class->has_quadric, class->num_planes, terms, &rect, noise);
}

/* Terms for a strip: those that all may use are found by the one in which the occluder begins. */
static const float *terms_in(struct csg_cull *cull, const struct csg_candidate *occluder, int begin,
                             float *own)
{
    const struct csg_crowd_class *class = &cull->view.crowd->classes[occluder->class];
    if (occluder->lo[1] >= begin)
        return csg_cull_terms(cull, occluder->class, occluder->member);
    return csg_member_terms(&cull->view, class, occluder->member, own) ? own : NULL;
}

/* Members that hide each other, and the reliefs they are drawn in: of near sides, of far ones. */
struct drawing {
    struct csg_cull *cull;
    struct csg_occluders occluders;
    struct csg_relief *reliefs;
    size_t num_reliefs;
    const struct csg_relief *base;          /* what hides besides; NULL: nothing */
    struct csg_owned owned[CSG_NUM_STRIPS]; /* of the first relief, where it has owners */
};

static bool may_show(const struct drawing *drawing, float key, const struct csg_pixels *pixels)
{
    bool shows = false;
    for (size_t i = 0; i < drawing->num_reliefs && !shows; i++)
        shows = csg_relief_may_show(&drawing->reliefs[i], key, pixels);
    return shows;
}

/* Kin are told apart by the order in which they are drawn. */
static uint32_t owner_of(const struct csg_cull *cull, const struct csg_candidate *candidate)
{
    const bool can_own = csg_candidate_num_pixels(candidate) <= MAX_OWNER_PIXELS &&
                         cull->view.crowd->kin[candidate->member] == CSG_CROWD_NO_KIN;
    return can_own ? candidate->member : CSG_NOBODY;
}

/* What cannot be cast hides nothing and may show. */
static void draw_occluder(const struct drawing *drawing, const struct csg_candidate *occluder,
                          const float *terms, const struct csg_pixels *pixels)
{
    struct csg_cast cast;
    const bool can_cast = prepare(drawing->cull, drawing->reliefs, occluder, terms, &cast);
    const uint32_t who = owner_of(drawing->cull, occluder);
    bool shows = !can_cast;
    for (size_t i = 0; i < drawing->num_reliefs && can_cast; i++)
        shows = csg_relief_draw(&drawing->reliefs[i], &cast, who, pixels) || shows;
    if (shows && (!can_cast || !drawing->reliefs->owners || who == CSG_NOBODY))
        atomic_store_explicit(&drawing->cull->drawn[occluder->member], true, memory_order_relaxed);
}

static void clear_strip(const struct drawing *drawing, int begin, int end)
{
    for (size_t i = 0; i < drawing->num_reliefs; i++)
        csg_relief_clear(&drawing->reliefs[i], drawing->base, begin, end);
    if (drawing->reliefs->owners)
        csg_owners_clear(drawing->reliefs->owners, begin, end);
}

/* The nearest first: most of the others then are found to be hidden before their terms are. */
static void draw_strip(void *user, size_t task)
{
    struct drawing *drawing = user;
    struct csg_occluders *occluders = &drawing->occluders;
    struct csg_cull *cull = drawing->cull;
    const int height = screen_of(cull)->height;
    const int begin = csg_strip_begin(height, task), end = csg_strip_begin(height, task + 1) - 1;
    float own[12 + 4 * CSG_CROWD_MAX_PLANES];
    clear_strip(drawing, begin, end + 1);
    csg_occluders_sort(occluders, cull, task);
    for (size_t i = occluders->begin[task]; i < occluders->begin[task + 1]; i++) {
        const struct csg_candidate *occluder = &cull->candidates[occluders->order[i]];
        if (i + PREFETCHED < occluders->begin[task + 1])
            csg_prefetch(&cull->candidates[occluders->order[i + PREFETCHED]]);
        struct csg_pixels pixels = csg_candidate_pixels(occluder);
        pixels.lo[1] = pixels.lo[1] > begin ? pixels.lo[1] : begin;
        pixels.hi[1] = pixels.hi[1] < end ? pixels.hi[1] : end;
        if (may_show(drawing, occluder->key, &pixels))
            draw_occluder(drawing, occluder, terms_in(cull, occluder, begin, own), &pixels);
    }
    if (drawing->reliefs->owners)
        drawing->owned[task] =
            csg_owners_note(drawing->reliefs->owners, begin, end + 1, drawing->reliefs->keys);
}

static bool note_drawn(struct csg_cull *cull)
{
    if (!cull->drawn)
        cull->drawn = calloc(cull->view.crowd->num + 1, sizeof *cull->drawn);
    return cull->drawn != NULL;
}

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

/* Of all strips. */
static struct csg_owned add_owned(const struct csg_owned strips[CSG_NUM_STRIPS])
{
    struct csg_owned all = strips[0];
    for (size_t i = 1; i < CSG_NUM_STRIPS; i++) {
        all.num += strips[i].num;
        for (int j = 0; j < 2; j++) {
            all.lo[j] = smaller(all.lo[j], strips[i].lo[j]);
            all.hi[j] = larger(all.hi[j], strips[i].hi[j]);
        }
    }
    return all;
}

/* Pixels of a picture that the owners repay. */
static size_t pixels_repaid(const struct csg_cull *cull)
{
    size_t num = 0;
    for (size_t i = 0; i < cull->blocks.num; i++) {
        const struct csg_crowd_block *block = &cull->blocks.data[i];
        for (size_t j = block->begin; j < block->begin + block->num; j++) {
            const struct csg_candidate *candidate = &cull->candidates[j];
            const bool is_ball =
                cull->view.crowd->classes[candidate->class].outline == CSG_OUTLINE_BALL;
            if (owner_of(cull, candidate) != CSG_NOBODY)
                num += is_ball ? PIXELS_PER_BALL : PIXELS_PER_OTHER;
        }
    }
    return num;
}

static bool takes_owners(const struct csg_cull *cull)
{
    const size_t picture = (size_t)screen_of(cull)->width * (size_t)screen_of(cull)->height;
    return picture <= cull->max_owners && pixels_repaid(cull) >= picture;
}

static bool init_opaque(struct csg_cull *cull)
{
    const struct csg_screen *screen = screen_of(cull);
    if (!note_drawn(cull) ||
        !csg_relief_init(&cull->relief, screen, cull->view.frame->at, CSG_CAST_FRONT))
        return false;
    if (!takes_owners(cull))
        return true;
    cull->relief.owners = &cull->owners;
    return csg_owners_init(&cull->owners, screen->width, screen->height, cull->view.crowd->num,
                           cull->drawn);
}

bool csg_occlusion_draw(struct csg_cull *cull)
{
    struct drawing drawing = {.cull = cull, .reliefs = &cull->relief, .num_reliefs = 1};
    if (!cull->view.square)
        return true;
    bool ok = csg_occluders_fill(&drawing.occluders, cull, true);
    if (ok && drawing.occluders.num >= CSG_MIN_OCCLUDERS) {
        cull->has_relief = true;
        ok = init_opaque(cull);
        if (ok)
            csg_parallel(cull->view.frame->num_threads, CSG_NUM_STRIPS, draw_strip, &drawing);
        if (ok && cull->relief.owners)
            cull->owned = add_owned(drawing.owned);
    }
    csg_occluders_finish(&drawing.occluders);
    return ok;
}

/* Whether it may show at a pixel that it does not own. */
static bool shows_by_rect(struct csg_cull *cull, struct csg_candidate *candidate)
{
    const bool opaque = csg_hides_others(cull, candidate);
    struct csg_pixels pixels = csg_candidate_pixels(candidate);
    struct csg_cast cast;
    /* What was hidden when its turn came still is. */
    if (opaque && !cull->drawn[candidate->member])
        return false;
    if (!csg_relief_may_show(&cull->relief, candidate->key, &pixels))
        return false;
    const float *terms = csg_cull_terms(cull, candidate->class, candidate->member);
    if (!prepare(cull, &cull->relief, candidate, terms, &cast))
        return true;
    const bool rivals = opaque && cull->relief.owners && owner_of(cull, candidate) != CSG_NOBODY;
    const bool shows = csg_relief_narrow(&cull->relief, &cast, rivals, &pixels);
    set_pixels(candidate, &pixels);
    return shows;
}

bool csg_occlusion_shows(struct csg_cull *cull, struct csg_candidate *candidate)
{
    candidate->owns = cull->relief.owners && cull->owners.owns[candidate->member];
    candidate->by_rect = shows_by_rect(cull, candidate);
    return candidate->by_rect || candidate->owns;
}

/* ---- translucent members ---- */

/* Whether it may show on either relief; narrows its rectangle to where. */
static bool shows_on_any(const struct drawing *drawing, struct csg_candidate *candidate)
{
    const float *terms = csg_cull_terms(drawing->cull, candidate->class, candidate->member);
    struct csg_cast cast;
    if (!prepare(drawing->cull, drawing->reliefs, candidate, terms, &cast))
        return true;
    struct csg_pixels all = {{INT16_MAX, INT16_MAX}, {-1, -1}};
    for (size_t i = 0; i < drawing->num_reliefs; i++) {
        struct csg_pixels pixels = csg_candidate_pixels(candidate);
        if (!csg_relief_narrow(&drawing->reliefs[i], &cast, false, &pixels))
            continue;
        for (int j = 0; j < 2; j++) {
            all.lo[j] = smaller(all.lo[j], pixels.lo[j]);
            all.hi[j] = larger(all.hi[j], pixels.hi[j]);
        }
    }
    set_pixels(candidate, &all);
    return all.hi[1] >= 0;
}

static void hide_translucent_block(void *user, size_t task)
{
    struct drawing *drawing = user;
    struct csg_cull *cull = drawing->cull;
    struct csg_crowd_block *block = &cull->blocks.data[task];
    struct csg_candidate *candidates = cull->candidates + block->begin;
    uint32_t num = 0;
    for (uint32_t i = 0; i < block->num; i++)
        if (csg_hides_others(cull, &candidates[i]) ||
            (cull->drawn[candidates[i].member] && shows_on_any(drawing, &candidates[i])))
            candidates[num++] = candidates[i];
    block->num = num;
}

static bool hide_translucent(struct drawing *drawing)
{
    static const enum csg_cast_side sides[2] = {CSG_CAST_FRONT, CSG_CAST_REAR};
    struct csg_cull *cull = drawing->cull;
    const struct csg_relief *base = cull->has_relief ? &cull->relief : NULL;
    for (size_t i = 0; i < drawing->num_reliefs; i++)
        if (!csg_relief_init(&drawing->reliefs[i], screen_of(cull), cull->view.frame->at, sides[i]))
            return false;
    drawing->base = base;
    if (!note_drawn(cull))
        return false;
    csg_parallel(cull->view.frame->num_threads, CSG_NUM_STRIPS, draw_strip, drawing);
    csg_parallel(cull->view.frame->num_threads, cull->blocks.num, hide_translucent_block, drawing);
    return true;
}

bool csg_occlusion_hide_translucent(struct csg_cull *cull)
{
    struct csg_relief reliefs[2] = {{0}, {0}};
    struct drawing drawing = {.cull = cull, .reliefs = reliefs, .num_reliefs = 2};
    if (!cull->view.square)
        return true;
    bool ok = csg_occluders_fill(&drawing.occluders, cull, false);
    cull->together = drawing.occluders.num > CSG_MAX_OVERLAYS;
    if (ok && cull->together)
        ok = hide_translucent(&drawing);
    csg_occluders_finish(&drawing.occluders);
    csg_relief_finish(&reliefs[0]);
    csg_relief_finish(&reliefs[1]);
    return ok;
}
