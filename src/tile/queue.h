/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_QUEUE_H
#define CSG_TILE_QUEUE_H

/*
 * Many small objects, tiled side by side: each waits with its terms until there are enough for all
 * cores. What they make is put where it would be if they had been tiled one after the other, so the
 * frame does not depend on how many cores there are.
 */

#include "tile/tile.h"

struct csg_queued {
    const struct csg_object *object;
    struct csg_rect rect;
    struct csg_draw draw;
    struct csg_terms terms; /* its own but for index and known */
    size_t at;              /* draws of the frame before its own */
    bool ok;
};

/* Zero-initialise it. */
struct csg_tile_queue {
    CSG_ARRAY(struct csg_queued) items; /* each has a part of the frame, of the same number */
    struct csg_frame *frame;
};

/* As csg_tile_object, later. Takes the leaves that terms hold. object lives until then. */
bool csg_tile_queue_add(struct csg_tile_queue *queue, struct csg_terms *terms,
                        const struct csg_object *object, const struct csg_rect *rect,
                        const struct csg_draw *draw);

/* Tiles what waits. false: out of memory, now or in an object. */
bool csg_tile_queue_run(struct csg_tile_queue *queue, struct csg_frame *frame);

void csg_tile_queue_finish(struct csg_tile_queue *queue);

#endif
