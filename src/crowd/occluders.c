/* SPDX-License-Identifier: MIT */
#include "crowd/occluders.h"

#include <stdlib.h>

#include "common/parallel.h"

/* Between the nearest and the farthest key. */
enum { NUM_BINS = 2048 };

/* Per block and band: how many candidates, then where the next of them goes. */
typedef uint32_t places[CSG_NUM_BANDS];

struct finder {
    const struct csg_cull *cull;
    struct csg_occluders *occluders;
    bool opaque;      /* or else translucent */
    uint8_t *band_of; /* by row */
    places *next;
    size_t *num; /* per block, of those */
};

int csg_band_begin(const struct csg_cull *cull, size_t band)
{
    const size_t height = (size_t)cull->view.frame->screen.height;
    const size_t row = height * band / CSG_NUM_BANDS;
    return (int)(band < CSG_NUM_BANDS ? row - row % CSG_RELIEF_SQUARE : height);
}

bool csg_hides_others(const struct csg_cull *cull, const struct csg_candidate *candidate)
{
    return cull->view.crowd->opaque[candidate->member];
}

static void find_keys(struct finder *finder)
{
    const struct csg_cull *cull = finder->cull;
    float lo = INFINITY, hi = -INFINITY;
    for (size_t i = 0; i < cull->blocks.num; i++) {
        lo = fminf(lo, cull->blocks.data[i].lo_key);
        hi = fmaxf(hi, cull->blocks.data[i].hi_key);
    }
    finder->occluders->lo = lo;
    finder->occluders->scale = hi > lo ? NUM_BINS / (hi - lo) : 0;
}

static void find_bands(struct finder *finder)
{
    for (size_t band = 0; band < CSG_NUM_BANDS; band++)
        for (int y = csg_band_begin(finder->cull, band); y < csg_band_begin(finder->cull, band + 1);
             y++)
            finder->band_of[y] = (uint8_t)band;
}

static void count_block(void *user, size_t task)
{
    struct finder *finder = user;
    const struct csg_crowd_block *block = &finder->cull->blocks.data[task];
    for (size_t i = block->begin; i < block->begin + block->num; i++) {
        const struct csg_candidate *candidate = &finder->cull->candidates[i];
        if (csg_hides_others(finder->cull, candidate) != finder->opaque)
            continue;
        finder->num[task]++;
        for (int band = finder->band_of[candidate->lo[1]];
             band <= finder->band_of[candidate->hi[1]]; band++)
            finder->next[task][band]++;
    }
}

static void place_block(void *user, size_t task)
{
    struct finder *finder = user;
    const struct csg_crowd_block *block = &finder->cull->blocks.data[task];
    for (size_t i = block->begin; i < block->begin + block->num; i++) {
        const struct csg_candidate *candidate = &finder->cull->candidates[i];
        if (csg_hides_others(finder->cull, candidate) != finder->opaque)
            continue;
        for (int band = finder->band_of[candidate->lo[1]];
             band <= finder->band_of[candidate->hi[1]]; band++)
            finder->occluders->found[finder->next[task][band]++] = (uint32_t)i;
    }
}

/* From counts to places. */
static size_t plan(struct finder *finder)
{
    struct csg_occluders *occluders = finder->occluders;
    size_t sum = 0;
    for (size_t band = 0; band < CSG_NUM_BANDS; band++) {
        occluders->begin[band] = sum;
        for (size_t i = 0; i < finder->cull->blocks.num; i++) {
            const size_t num = finder->next[i][band];
            finder->next[i][band] = (uint32_t)sum;
            sum += num;
        }
    }
    occluders->begin[CSG_NUM_BANDS] = sum;
    for (size_t i = 0; i < finder->cull->blocks.num; i++)
        occluders->num += finder->num[i];
    return sum;
}

static bool find(struct finder *finder)
{
    const struct csg_cull *cull = finder->cull;
    struct csg_occluders *occluders = finder->occluders;
    const int num_threads = cull->view.frame->num_threads;
    find_keys(finder);
    find_bands(finder);
    csg_parallel(num_threads, cull->blocks.num, count_block, finder);
    const size_t num = plan(finder);
    occluders->found = malloc((num + 1) * sizeof *occluders->found);
    occluders->order = malloc((num + 1) * sizeof *occluders->order);
    if (!occluders->found || !occluders->order)
        return false;
    csg_parallel(num_threads, cull->blocks.num, place_block, finder);
    return true;
}

bool csg_occluders_fill(struct csg_occluders *occluders, const struct csg_cull *cull, bool opaque)
{
    struct finder finder = {.cull = cull, .occluders = occluders, .opaque = opaque};
    *occluders = (struct csg_occluders){0};
    finder.band_of = malloc((size_t)cull->view.frame->screen.height + 1);
    finder.next = calloc(cull->blocks.num + 1, sizeof *finder.next);
    finder.num = calloc(cull->blocks.num + 1, sizeof *finder.num);
    const bool ok = finder.band_of && finder.next && finder.num && find(&finder);
    free(finder.band_of);
    free(finder.next);
    free(finder.num);
    return ok;
}

static int bin_of(const struct csg_occluders *occluders, const struct csg_candidate *candidate)
{
    const float place = (candidate->key - occluders->lo) * occluders->scale;
    return place < NUM_BINS ? place > 0 ? (int)place : 0 : NUM_BINS - 1;
}

void csg_occluders_sort(struct csg_occluders *occluders, const struct csg_cull *cull, size_t band)
{
    const size_t begin = occluders->begin[band], end = occluders->begin[band + 1];
    uint32_t next[NUM_BINS] = {0}, sum = (uint32_t)begin;
    for (size_t i = begin; i < end; i++)
        next[bin_of(occluders, &cull->candidates[occluders->found[i]])]++;
    for (int i = 0; i < NUM_BINS; i++) {
        const uint32_t num = next[i];
        next[i] = sum;
        sum += num;
    }
    for (size_t i = begin; i < end; i++) {
        const uint32_t found = occluders->found[i];
        occluders->order[next[bin_of(occluders, &cull->candidates[found])]++] = found;
    }
}

void csg_occluders_finish(struct csg_occluders *occluders)
{
    free(occluders->found);
    free(occluders->order);
}
