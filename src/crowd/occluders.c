/* SPDX-License-Identifier: MIT */
#include "crowd/occluders.h"

#include <stdlib.h>

#include "common/parallel.h"

/* Per block and strip: how many candidates, then where the next of them goes. */
typedef uint32_t places[CSG_NUM_STRIPS];

struct finder {
    const struct csg_cull *cull;
    struct csg_occluders *occluders;
    bool opaque;       /* or else translucent */
    uint8_t *strip_of; /* by row */
    places *next;
    size_t *num; /* per block, of those */
};

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
    finder->occluders->bins = csg_key_bins(lo, hi);
}

/* Counts a block's occluders in each of their strips; where there is room, found, puts them there
 * instead. */
static void visit_block(void *user, size_t task)
{
    struct finder *finder = user;
    const struct csg_crowd_block *block = &finder->cull->blocks.data[task];
    uint32_t *found = finder->occluders->found, *next = finder->next[task];
    for (size_t i = block->begin; i < block->begin + block->num; i++) {
        const struct csg_candidate *candidate = &finder->cull->candidates[i];
        if (csg_hides_others(finder->cull, candidate) != finder->opaque)
            continue;
        finder->num[task] += !found;
        for (int strip = finder->strip_of[candidate->lo[1]];
             strip <= finder->strip_of[candidate->hi[1]]; strip++) {
            if (found)
                found[next[strip]] = (uint32_t)i;
            next[strip]++;
        }
    }
}

/* From counts to places. */
static size_t plan(struct finder *finder)
{
    struct csg_occluders *occluders = finder->occluders;
    size_t sum = 0;
    for (size_t strip = 0; strip < CSG_NUM_STRIPS; strip++) {
        occluders->begin[strip] = sum;
        for (size_t i = 0; i < finder->cull->blocks.num; i++) {
            const size_t num = finder->next[i][strip];
            finder->next[i][strip] = (uint32_t)sum;
            sum += num;
        }
    }
    occluders->begin[CSG_NUM_STRIPS] = sum;
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
    csg_parallel(num_threads, cull->blocks.num, visit_block, finder);
    const size_t num = plan(finder);
    occluders->found = malloc((num + 1) * sizeof *occluders->found);
    occluders->order = malloc((num + 1) * sizeof *occluders->order);
    if (!occluders->found || !occluders->order)
        return false;
    csg_parallel(num_threads, cull->blocks.num, visit_block, finder);
    return true;
}

bool csg_occluders_fill(struct csg_occluders *occluders, const struct csg_cull *cull, bool opaque)
{
    struct finder finder = {.cull = cull, .occluders = occluders, .opaque = opaque};
    *occluders = (struct csg_occluders){0};
    finder.strip_of = csg_strips_of_rows(cull->view.frame->screen.height);
    finder.next = calloc(cull->blocks.num + 1, sizeof *finder.next);
    finder.num = calloc(cull->blocks.num + 1, sizeof *finder.num);
    const bool ok = finder.strip_of && finder.next && finder.num && find(&finder);
    free(finder.strip_of);
    free(finder.next);
    free(finder.num);
    return ok;
}

void csg_occluders_sort(struct csg_occluders *occluders, const struct csg_cull *cull, size_t strip)
{
    const size_t begin = occluders->begin[strip], end = occluders->begin[strip + 1];
    uint32_t next[CSG_NUM_KEY_BINS] = {0}, sum = (uint32_t)begin;
    for (size_t i = begin; i < end; i++)
        next[csg_key_bin(&occluders->bins, cull->candidates[occluders->found[i]].key)]++;
    for (int i = 0; i < CSG_NUM_KEY_BINS; i++) {
        const uint32_t num = next[i];
        next[i] = sum;
        sum += num;
    }
    for (size_t i = begin; i < end; i++) {
        const uint32_t found = occluders->found[i];
        occluders->order[next[csg_key_bin(&occluders->bins, cull->candidates[found].key)]++] =
            found;
    }
}

void csg_occluders_finish(struct csg_occluders *occluders)
{
    free(occluders->found);
    free(occluders->order);
}
