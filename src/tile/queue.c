/* SPDX-License-Identifier: MIT */
#include "tile/queue.h"

#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "tile/tiler.h"

/* More do not wait: their terms take memory. */
enum { MAX_ITEMS = 512 };

bool csg_tile_queue_add(struct csg_tile_queue *queue, struct csg_terms *terms,
                        const struct csg_object *object, const struct csg_rect *rect,
                        const struct csg_draw *draw)
{
    struct csg_frame *frame = terms->frame;
    if (queue->items.num >= MAX_ITEMS && !csg_tile_queue_run(queue, frame))
        return false;
    if (!csg_array_reserve(&queue->items, 1))
        return false;
    struct csg_queued *item = &queue->items.data[queue->items.num++];
    *item =
        (struct csg_queued){.object = object, .rect = *rect, .draw = *draw, .at = frame->draws.num};
    csg_terms_take(&item->terms, terms);
    return true;
}

/* As csg_terms_fill numbers them. */
static void number_leaves(const struct csg_queued *item)
{
    const struct csg_node *nodes = item->terms.scene->trees[item->object->layer].data;
    uint32_t num = 0;
    for (uint32_t i = item->object->begin; i < item->object->end; i++)
        if (nodes[i].op == CSG_LEAF)
            item->terms.index[nodes[i].leaf] = num++;
    for (size_t i = 0; i < item->terms.stacks.list.num; i++)
        item->terms.index[item->terms.scene->num_leaves + i] = num++;
}

/* What a core does all its objects with. */
struct worker {
    struct csg_tiler tiler;
    uint32_t *index;
    uint8_t *known;
};

static void tile_item(struct csg_queued *item, struct csg_frame *part, struct worker *worker)
{
    item->terms.frame = part;
    item->terms.index = worker->index;
    item->terms.known = worker->known;
    number_leaves(item);
    item->ok = csg_tile_small(&worker->tiler, &item->terms, &item->rect, &item->draw);
    item->terms.index = NULL;
    item->terms.known = NULL;
}

static void tile_some(void *user, struct csg_tasks *tasks)
{
    struct csg_tile_queue *queue = user;
    const size_t room = csg_stacks_room(queue->items.data[0].terms.scene->num_leaves);
    struct worker worker = {.index = malloc(room * sizeof *worker.index), .known = malloc(room)};
    for (size_t i; csg_take_task(tasks, &i);)
        if (worker.index && worker.known)
            tile_item(&queue->items.data[i], &queue->frame->parts.data[i], &worker);
    csg_tiler_finish(&worker.tiler);
    free(worker.index);
    free(worker.known);
}

static bool push_draws(struct csg_frame *frame, const struct csg_draw *draws, size_t num)
{
    if (num == 0)
        return true;
    if (!csg_array_reserve(&frame->draws, num))
        return false;
    memcpy(frame->draws.data + frame->draws.num, draws, num * sizeof *draws);
    frame->draws.num += num;
    return true;
}

/* Draws stay in the order of their objects. */
static bool splice(const struct csg_tile_queue *queue, struct csg_frame *frame)
{
    const size_t first = queue->items.data[0].at, num = frame->draws.num - first;
    struct csg_draw *others = malloc((num + 1) * sizeof *others);
    size_t next = 0;
    bool ok = others != NULL;
    if (ok && num)
        memcpy(others, frame->draws.data + first, num * sizeof *others);
    frame->draws.num = first;
    for (size_t i = 0; i < queue->items.num && ok; i++) {
        const struct csg_queued *item = &queue->items.data[i];
        ok = item->ok && push_draws(frame, others + next, item->at - first - next) &&
             csg_frame_append(frame, &frame->parts.data[i]);
        csg_frame_end_part(frame, i);
        next = item->at - first;
    }
    ok = ok && push_draws(frame, others + next, num - next);
    free(others);
    return ok;
}

static void drop(struct csg_tile_queue *queue)
{
    for (size_t i = 0; i < queue->items.num; i++)
        csg_terms_finish(&queue->items.data[i].terms);
    queue->items.num = 0;
}

bool csg_tile_queue_run(struct csg_tile_queue *queue, struct csg_frame *frame)
{
    if (queue->items.num == 0)
        return true;
    queue->frame = frame;
    const bool started = csg_frame_start_parts(frame, queue->items.num);
    if (started)
        csg_parallel_workers(frame->num_threads, queue->items.num, tile_some, queue);
    const bool ok = started && splice(queue, frame);
    drop(queue);
    return ok;
}

void csg_tile_queue_finish(struct csg_tile_queue *queue)
{
    drop(queue);
    free(queue->items.data);
}
