/* SPDX-License-Identifier: MIT */

/*
 * Tiles on all cores: the rectangle of a large object is cut into cells, each tiled by itself into
 * a frame of its own. Cells depend on the object and the picture only, and are put together in
 * their order, so the frame is the same however many threads there are.
 */

#include "tile/tile.h"

#include <stdlib.h>

#include "common/parallel.h"

/* Smaller trees are tiled sooner than threads start. */
#define MIN_NODES 48

/* Cells across and down, and the size below which there are fewer, in pixels. */
#define MAX_CELLS 4
#define MIN_CELL_SIZE (4 * CSG_TILE_SIZE)

struct cell {
    struct csg_frame frame;
    struct csg_tile_area area;
    bool ok;
};

struct job {
    const struct csg_terms *terms;
    const struct csg_object *object;
    const struct csg_draw *draw;
    struct cell *cells;
    size_t num;
};

static void tile_cell(void *user, size_t i)
{
    const struct job *job = user;
    struct cell *cell = &job->cells[i];
    struct csg_terms terms = *job->terms;
    cell->frame.screen = job->terms->frame->screen;
    cell->frame.at = job->terms->frame->at;
    terms.frame = &cell->frame;
    terms.known = malloc(terms.scene->num_leaves + 1);
    cell->ok = terms.known && csg_tile_area(&terms, job->object, &cell->area, job->draw);
    free(terms.known);
}

static int count_cells(int size)
{
    const int num = size / MIN_CELL_SIZE;
    return num < 1 ? 1 : num > MAX_CELLS ? MAX_CELLS : num;
}

/* Edge number i of num, on a tile's edge but for the last one. */
static int edge(int lo, int hi, int i, int num)
{
    const int tiles = (hi - lo + CSG_TILE_SIZE - 1) / CSG_TILE_SIZE;
    return i == num ? hi : lo + tiles * i / num * CSG_TILE_SIZE;
}

static void cut_cells(const struct csg_tile_area *area, int across, int down, struct cell *cells)
{
    for (int i = 0; i < across * down; i++) {
        const int x = i % across, y = i / across;
        cells[i].area =
            (struct csg_tile_area){.lo = {edge(area->lo[0], area->hi[0], x, across),
                                          edge(area->lo[1], area->hi[1], y, down)},
                                   .hi = {edge(area->lo[0], area->hi[0], x + 1, across),
                                          edge(area->lo[1], area->hi[1], y + 1, down)},
                                   .max_texels = area->max_texels / (size_t)(across * down)};
    }
}

static bool tile_cells(struct csg_terms *terms, struct job *job)
{
    csg_parallel(job->num, tile_cell, job);
    bool ok = true;
    for (size_t i = 0; i < job->num; i++) {
        ok = ok && job->cells[i].ok && csg_frame_append(terms->frame, &job->cells[i].frame);
        csg_frame_finish(&job->cells[i].frame);
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

/* How many cells there are across and down; 1 in all: the object is not cut into cells. */
static int plan_cells(const struct csg_object *object, const struct csg_tile_area *area,
                      int *across, int *down)
{
    *across = count_cells(area->hi[0] - area->lo[0]);
    *down = count_cells(area->hi[1] - area->lo[1]);
    return object->end - object->begin < MIN_NODES ? 1 : *across * *down;
}

bool csg_tile_is_small(const struct csg_object *object, const struct csg_rect *rect)
{
    const struct csg_tile_area area = area_of(rect);
    int across, down;
    return plan_cells(object, &area, &across, &down) == 1;
}

bool csg_tile_object(struct csg_terms *terms, const struct csg_object *object,
                     const struct csg_rect *rect, const struct csg_draw *draw)
{
    const struct csg_tile_area area = area_of(rect);
    int across, down;
    const int num = plan_cells(object, &area, &across, &down);
    if (num == 1)
        return csg_tile_area(terms, object, &area, draw);
    struct job job = {terms, object, draw, calloc((size_t)num, sizeof *job.cells), (size_t)num};
    if (!job.cells)
        return false;
    cut_cells(&area, across, down, job.cells);
    const bool ok = tile_cells(terms, &job);
    free(job.cells);
    return ok;
}
