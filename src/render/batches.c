/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "crowd/crowd.h"
#include "render/chooser.h"
#include "render/direct.h"
#include "render/turns.h"

static bool is_overlay(const struct csg_draw *draw)
{
    return draw->translucent || draw->paint != CSG_LAYER_MODEL;
}

/* By paint, whether too many objects are not simply opaque to come one after the other. */
static void find_together(struct csg_batches *batches, const struct csg_frame *frame)
{
    uint32_t last[CSG_NUM_LAYERS] = {CSG_ANY_OBJECT, CSG_ANY_OBJECT, CSG_ANY_OBJECT};
    size_t num[CSG_NUM_LAYERS] = {0};
    for (size_t i = 0; i < frame->draws.num; i++) {
        const struct csg_draw *draw = &frame->draws.data[i];
        if (!is_overlay(draw))
            continue;
        num[draw->paint] += draw->object != last[draw->paint];
        last[draw->paint] = draw->object;
    }
    for (int paint = 0; paint < CSG_NUM_LAYERS; paint++)
        batches->together[paint] = num[paint] > CSG_MAX_OVERLAYS;
    batches->together[CSG_LAYER_MODEL] |= frame->crowd.together;
}

static bool add_draw(struct csg_batches *batches, const struct csg_choice *choice,
                     const struct csg_draw *draw, uint32_t instance)
{
    struct csg_batch *last = batches->num ? &batches->data[batches->num - 1] : NULL;
    if (choice->resolver == CSG_RESOLVER_CPU)
        batches->on_cpu++;
    else
        batches->drawn[choice->resolver]++;
    const bool alone = is_overlay(draw) && !batches->together[draw->paint];
    if (last && last->program == choice->program && last->layer == draw->layer &&
        (!alone || last->object == draw->object) && last->paint == draw->paint &&
        last->translucent == draw->translucent && last->rear == choice->rear &&
        last->points == choice->point) {
        last->num++;
        return true;
    }
    const struct csg_batch batch = {.program = choice->program,
                                    .rear = choice->rear,
                                    .layer = draw->layer,
                                    .paint = draw->paint,
                                    .translucent = draw->translucent,
                                    .points = choice->point,
                                    .object = draw->object,
                                    .first = instance,
                                    .num = 1};
    return csg_array_push(batches, batch);
}

/* Crowds share no carriers with other objects, so file order does not matter between them. */
static bool add_crowd(struct csg_batches *batches, struct csgcast_renderer *renderer)
{
    const struct csg_frame_crowd *crowd = &renderer->frame.crowd;
    for (size_t i = 0; i < crowd->runs.num; i++) {
        const struct csg_crowd_run *run = &crowd->runs.data[i];
        if (run->num == 0)
            continue;
        const GLuint program =
            csg_programs_get(&renderer->programs, csg_source_single(run, batches->direct));
        const struct csg_batch batch = {.program = program,
                                        .layer = CSG_LAYER_MODEL,
                                        .paint = CSG_LAYER_MODEL,
                                        .object = CSG_WHOLE_LAYER,
                                        .num = (uint32_t)run->num,
                                        .run = run};
        if (!program)
            return false;
        if (!csg_array_push(batches, batch))
            return csg_log_memory(&renderer->log);
        batches->drawn_single += run->num_members;
    }
    return true;
}

/* Adds draws [begin, end) that have the program and the form of the first of them, and marks their
 * choices. */
static bool add_alike(struct csg_batches *batches, struct csg_choice *choices, size_t begin,
                      size_t end, const struct csg_draw *draws)
{
    const struct csg_choice first = choices[begin];
    for (size_t i = begin; i < end; i++) {
        struct csg_choice *choice = &choices[i];
        if (choice->placed || choice->program != first.program || choice->point != first.point)
            continue;
        choice->placed = true;
        if (!add_draw(batches, choice, &draws[i], (uint32_t)batches->order.num))
            return false;
        batches->order.data[batches->order.num++] = (uint32_t)i;
    }
    return true;
}

/* Whether it does not matter which of two draws comes first: the tiles of an object do not overlap,
 * and highlights that are drawn at once have one colour. */
static bool is_in_any_order(const struct csg_batches *batches, const struct csg_draw *a,
                            const struct csg_draw *b)
{
    const bool has_one_color =
        a->layer == CSG_LAYER_HIGHLIGHT && batches->together[CSG_LAYER_HIGHLIGHT];
    return a->layer == b->layer &&
           (has_one_color || (a->tile && b->tile && a->object == b->object));
}

/* Objects in the order of the file; where that does not matter, those of one program come together.
 */
static bool add_draws(struct csg_batches *batches, struct csg_choice *choices, size_t num,
                      const struct csg_draw *draws)
{
    if (!csg_array_reserve(&batches->order, num))
        return false;
    for (size_t begin = 0, end; begin < num; begin = end) {
        end = begin + 1;
        while (end < num && is_in_any_order(batches, &draws[begin], &draws[end]))
            end++;
        for (size_t i = begin; i < end; i++)
            if (!choices[i].placed && !add_alike(batches, choices, i, end, draws))
                return false;
    }
    return true;
}

/* What the statistics and the passes need to know of all draws. */
static void note_choice(struct csg_batches *batches, struct csgcast_renderer *renderer,
                        const struct csg_request *request, const struct csg_choice *choice,
                        struct csg_draw *draw, bool is_first)
{
    const bool overflowed =
        request->resolver == CSG_RESOLVER_ALGORITHM4 && choice->resolver == CSG_RESOLVER_LOOP;
    const bool may_loop = choice->rear || (choice->resolver != CSG_RESOLVER_STRAIGHT &&
                                           choice->resolver != CSG_RESOLVER_CHAIN);
    renderer->stats.overflowed_objects += overflowed && is_first;
    batches->may_give_up |= choice->resolver == CSG_RESOLVER_CPU;
    if (!may_loop)
        return;
    const struct csg_turns turns = csg_turns_of(&renderer->frame, draw, choice->features);
    draw->instance.turns = (int32_t)fmin(turns.look, CSG_MAX_TURNS);
    batches->may_give_up |= csg_may_give_up(draw, &turns);
}

static bool fill(struct csg_batches *batches, struct csg_chooser *chooser,
                 struct csgcast_renderer *renderer, const struct csg_request *request,
                 struct csg_choice *choices)
{
    struct csg_draw *draws = renderer->frame.draws.data;
    const size_t num = renderer->frame.draws.num;
    if (!csg_chooser_prepare(chooser))
        return false;
    for (size_t i = 0; i < num; i++) {
        if (!csg_chooser_choose(chooser, &draws[i], &choices[i]))
            return false;
        draws[i].instance.side = choices[i].point ? draws[i].instance.side : 0;
        note_choice(batches, renderer, request, &choices[i], &draws[i],
                    i == 0 || draws[i - 1].object != draws[i].object);
    }
    find_together(batches, &renderer->frame);
    return add_draws(batches, choices, num, draws) || csg_log_memory(&renderer->log);
}

bool csg_batches_fill(struct csg_batches *batches, struct csgcast_renderer *renderer,
                      const struct csg_request *request)
{
    struct csg_chooser *chooser = csg_chooser_create(renderer, request, batches->direct);
    struct csg_choice *choices = calloc(renderer->frame.draws.num + 1, sizeof *choices);
    const bool ok = chooser && choices ? fill(batches, chooser, renderer, request, choices)
                                       : csg_log_memory(&renderer->log);
    free(choices);
    csg_chooser_destroy(chooser);
    return ok && add_crowd(batches, renderer);
}

void csg_batches_finish(struct csg_batches *batches)
{
    free(batches->data);
    free(batches->order.data);
}
