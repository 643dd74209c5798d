/* SPDX-License-Identifier: MIT */
#include "crowd/occluders.h"

#include <stdlib.h>
#include <string.h>

/* Between the nearest and the farthest key. */
enum { NUM_BINS = 2048 };

struct sorter {
    const struct csg_cull *cull;
    struct csg_occluders *occluders;
    bool opaque; /* or else translucent */
    float lo, scale;
    uint32_t next[CSG_NUM_BANDS][NUM_BINS];
    uint8_t *band_of; /* by row */
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

static int bin_of(const struct sorter *sorter, float key)
{
    const float place = (key - sorter->lo) * sorter->scale;
    return place < NUM_BINS ? place > 0 ? (int)place : 0 : NUM_BINS - 1;
}

static void find_keys(struct sorter *sorter)
{
    const struct csg_cull *cull = sorter->cull;
    float lo = INFINITY, hi = -INFINITY;
    for (size_t i = 0; i < cull->blocks.num; i++) {
        lo = fminf(lo, cull->blocks.data[i].lo_key);
        hi = fmaxf(hi, cull->blocks.data[i].hi_key);
    }
    sorter->lo = lo;
    sorter->scale = hi > lo ? NUM_BINS / (hi - lo) : 0;
}

static void find_bands(struct sorter *sorter)
{
    for (size_t band = 0; band < CSG_NUM_BANDS; band++)
        for (int y = csg_band_begin(sorter->cull, band); y < csg_band_begin(sorter->cull, band + 1);
             y++)
            sorter->band_of[y] = (uint8_t)band;
}

static void count(struct sorter *sorter, size_t index)
{
    const struct csg_candidate *candidate = &sorter->cull->candidates[index];
    const int bin = bin_of(sorter, candidate->key);
    sorter->occluders->num++;
    for (int i = sorter->band_of[candidate->lo[1]]; i <= sorter->band_of[candidate->hi[1]]; i++)
        sorter->next[i][bin]++;
}

static void place(struct sorter *sorter, size_t index)
{
    const struct csg_candidate *candidate = &sorter->cull->candidates[index];
    const int bin = bin_of(sorter, candidate->key);
    for (int i = sorter->band_of[candidate->lo[1]]; i <= sorter->band_of[candidate->hi[1]]; i++)
        sorter->occluders->order[sorter->next[i][bin]++] = (uint32_t)index;
}

static void visit(struct sorter *sorter, void (*what)(struct sorter *, size_t))
{
    const struct csg_cull *cull = sorter->cull;
    for (size_t i = 0; i < cull->blocks.num; i++) {
        const struct csg_crowd_block *block = &cull->blocks.data[i];
        for (size_t j = block->begin; j < block->begin + block->num; j++)
            if (csg_hides_others(cull, &cull->candidates[j]) == sorter->opaque)
                what(sorter, j);
    }
}

/* From counts to places. */
static size_t plan(struct sorter *sorter)
{
    size_t sum = 0;
    for (size_t band = 0; band < CSG_NUM_BANDS; band++) {
        sorter->occluders->begin[band] = sum;
        for (int i = 0; i < NUM_BINS; i++) {
            const size_t num = sorter->next[band][i];
            sorter->next[band][i] = (uint32_t)sum;
            sum += num;
        }
    }
    sorter->occluders->begin[CSG_NUM_BANDS] = sum;
    return sum;
}

bool csg_occluders_fill(struct csg_occluders *occluders, const struct csg_cull *cull, bool opaque)
{
    struct sorter sorter = {.cull = cull, .occluders = occluders, .opaque = opaque};
    *occluders = (struct csg_occluders){0};
    sorter.band_of = malloc((size_t)cull->view.frame->screen.height + 1);
    if (!sorter.band_of)
        return false;
    find_keys(&sorter);
    find_bands(&sorter);
    visit(&sorter, count);
    occluders->order = malloc((plan(&sorter) + 1) * sizeof *occluders->order);
    if (occluders->order)
        visit(&sorter, place);
    free(sorter.band_of);
    return occluders->order != NULL;
}

void csg_occluders_finish(struct csg_occluders *occluders)
{
    free(occluders->order);
}
