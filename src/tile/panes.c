/* SPDX-License-Identifier: MIT */

/*
 * Tiles on all cores: the rectangle of a large object is cut into panes, each tiled by itself into
 * a frame of its own. Panes depend on the object and the picture only, and are put together in
 * their order, so the frame is the same however many threads there are.
 */

#include "tile/tile.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "tile/tiler.h"

/* Smaller trees are tiled sooner than threads start. */
#define MIN_NODES 48

/* Panes are squares of as many pixels a side, or twice that, and so on, so that there are not more.
 */
#define MIN_PANE_SIZE (4 * CSG_TILE_SIZE)
#define MAX_PANES 32

struct grid {
    int size; /* of a pane; their edges are multiples of it */
    int across, num;
};

struct pane {
    struct csg_frame *frame;
    struct csg_tile_area area;
    bool ok;
};

struct job {
    const struct csg_terms *terms;
    const struct csg_draw *draw;
    struct pane *panes;
    size_t num;
};

/* What is drawn and counted goes to a frame of its own. */
static void tile_pane(const struct job *job, struct pane *pane, struct csg_tiler *tiler)
{
    struct csg_terms terms = *job->terms;
    terms.frame = pane->frame;
    pane->ok = csg_array_reserve(&tiler->known, csg_stacks_room(terms.scene->num_leaves));
    terms.known = tiler->known.data;
    pane->ok = pane->ok && csg_tile_area(tiler, &terms, &pane->area, job->draw);
}

static void tile_some(void *user, struct csg_tasks *tasks)
{
    const struct job *job = user;
    struct csg_tiler tiler = {0};
    for (size_t i; csg_take_task(tasks, &i);)
        tile_pane(job, &job->panes[i], &tiler);
    csg_tiler_finish(&tiler);
}

static void tile_all(struct job *job)
{
    csg_parallel_workers(job->terms->frame->num_threads, job->num, tile_some, job);
}

/* Panes of that size across or down. */
static int count_panes(int lo, int hi, int size)
{
    return (hi + size - 1) / size - lo / size;
}

static int clamp(int x, int lo, int hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

static void cut_panes(const struct csg_tile_area *area, const struct grid *grid, struct pane *panes)
{
    for (int i = 0; i < grid->num; i++) {
        const int at[2] = {i % grid->across, i / grid->across};
        panes[i].area = (struct csg_tile_area){.max_texels = area->max_texels / (size_t)grid->num,
                                               .budget = area->budget};
        for (int j = 0; j < 2; j++) {
            const int lo = (area->lo[j] / grid->size + at[j]) * grid->size;
            panes[i].area.lo[j] = clamp(lo, area->lo[j], area->hi[j]);
            panes[i].area.hi[j] = clamp(lo + grid->size, area->lo[j], area->hi[j]);
        }
    }
}

/* Whether they need more tests than they may does not depend on which is tiled first. */
static bool tile_panes(struct csg_terms *terms, struct job *job,
                       const struct csg_tile_budget *budget)
{
    bool ok = csg_frame_start_parts(terms->frame, job->num);
    if (!ok)
        return false;
    for (size_t i = 0; i < job->num; i++)
        job->panes[i].frame = &terms->frame->parts.data[i];
    tile_all(job);
    const bool dear = budget->spent > budget->most;
    for (size_t i = 0; i < job->num; i++) {
        const struct pane *pane = &job->panes[i];
        ok = ok && pane->ok && (dear || csg_frame_append(terms->frame, pane->frame));
        csg_frame_end_part(terms->frame, i);
    }
    return ok;
}

static struct csg_tile_area area_of(const struct csg_rect *rect)
{
    struct csg_tile_area area = {.max_texels = CSG_MAX_TILED_TEXELS};
    for (int i = 0; i < 2; i++) {
        area.lo[i] = (int)floor(rect->lo[i]);
        area.hi[i] = (int)ceil(rect->hi[i]);
    }
    return area;
}

/* How an object is cut into panes; one in all: it is not. */
static struct grid plan_panes(const struct csg_object *object, const struct csg_tile_area *area)
{
    struct grid grid = {MIN_PANE_SIZE, 1, 1};
    if (object->end - object->begin < MIN_NODES)
        return grid;
    for (;; grid.size *= 2) {
        grid.across = count_panes(area->lo[0], area->hi[0], grid.size);
        grid.num = grid.across * count_panes(area->lo[1], area->hi[1], grid.size);
        if (grid.num <= MAX_PANES)
            return grid;
    }
}

bool csg_tile_is_small(const struct csg_object *object, const struct csg_rect *rect)
{
    const struct csg_tile_area area = area_of(rect);
    return plan_panes(object, &area).num <= 1;
}

static bool project_views(struct csg_terms *terms)
{
    return csg_surface_views_project(&terms->views, &terms->frame->screen, terms->frame->at,
                                     terms->params->num_threads);
}

bool csg_tile_small(struct csg_tiler *tiler, struct csg_terms *terms, const struct csg_rect *rect,
                    const struct csg_draw *draw)
{
    const struct csg_tile_area area = area_of(rect);
    return project_views(terms) && csg_tile_area(tiler, terms, &area, draw);
}

static bool tile_alone(struct csg_terms *terms, const struct csg_rect *rect,
                       const struct csg_draw *draw)
{
    struct csg_tiler tiler = {0};
    const bool ok = csg_tile_small(&tiler, terms, rect, draw);
    csg_tiler_finish(&tiler);
    return ok;
}

bool csg_tile_object(struct csg_terms *terms, const struct csg_object *object,
                     const struct csg_rect *rect, const struct csg_draw *draw, size_t max_tests,
                     size_t *tests)
{
    struct csg_tile_budget budget = {.most = max_tests};
    struct csg_tile_area area = area_of(rect);
    const struct grid grid = plan_panes(object, &area);
    *tests = 0;
    if (grid.num <= 1)
        return tile_alone(terms, rect, draw);
    if (!project_views(terms))
        return false;
    area.budget = &budget;
    struct job job = {.terms = terms, .draw = draw, .num = (size_t)grid.num};
    job.panes = calloc(job.num, sizeof *job.panes);
    if (!job.panes)
        return false;
    cut_panes(&area, &grid, job.panes);
    const bool ok = tile_panes(terms, &job, &budget);
    *tests = budget.spent;
    free(job.panes);
    return ok;
}

#define SAMPLES 3 /* across and down */

static struct csg_tile_area sample_area(const struct csg_rect *rect, size_t x, size_t y)
{
    const size_t at[2] = {x, y};
    struct csg_tile_area area = {.max_texels = CSG_MAX_TILED_TEXELS, .fine = true};
    for (int i = 0; i < 2; i++) {
        const double size = rect->hi[i] - rect->lo[i];
        const int lo = (int)floor(rect->lo[i] + ((double)at[i] + 0.5) / SAMPLES * size);
        area.lo[i] = lo / CSG_TILE_SIZE * CSG_TILE_SIZE;
        area.hi[i] = area.lo[i] + 2 * CSG_TILE_SIZE; /* cut twice, as trees fold better then */
    }
    return area;
}

/* Adds a row of samples. */
static bool sample_row(struct job *job, const struct csg_rect *rect, size_t row, double *tests,
                       double *pixels)
{
    struct csg_frame frames[SAMPLES] = {0};
    bool ok = true;
    for (size_t i = 0; i < SAMPLES; i++) {
        csg_frame_start_part(&frames[i], job->terms->frame);
        job->panes[i] = (struct pane){.frame = &frames[i], .area = sample_area(rect, i, row)};
    }
    tile_all(job);
    for (size_t i = 0; i < SAMPLES; i++) {
        ok &= job->panes[i].ok;
        *tests += (double)frames[i].solid_tests;
        *pixels += (double)frames[i].proxy_pixels;
        csg_frame_finish(&frames[i]);
    }
    return ok;
}

bool csg_tile_sample(const struct csg_terms *terms, const struct csg_rect *rect,
                     const struct csg_draw *draw, double few, double many, double *tests)
{
    static const size_t rows[SAMPLES] = {1, 0, 2};
    struct pane panes[SAMPLES];
    struct job job = {.terms = terms, .draw = draw, .panes = panes, .num = SAMPLES};
    double num_tests = 0, num_pixels = 0;
    for (size_t i = 0;
         i < SAMPLES && (i == 0 || (num_tests > few * num_pixels && num_tests < many * num_pixels));
         i++)
        if (!sample_row(&job, rect, rows[i], &num_tests, &num_pixels))
            return false;
    *tests = num_pixels > 0 ? num_tests / num_pixels : 0;
    return true;
}
