/* SPDX-License-Identifier: MIT */
#include "pack/frame.h"

#include "common/clock.h"
#include "crowd/fill.h"
#include "csg/membership.h"
#include "pack/choice.h"
#include "pack/precise.h"
#include "pack/record.h"
#include "pack/walk.h"
#include "tile/queue.h"

struct packer {
    struct csg_frame *frame;
    const struct csgcast_scene *scene;
    const struct csg_frame_params *params;
    struct csg_terms terms;
    struct csg_tile_queue queue;
};

/* Fewer objects are drawn as soon as rectangles. */
enum { MIN_POINTS = 1000 };

static bool has_many(const struct packer *packer)
{
    return packer->frame->listed.num >= MIN_POINTS && !packer->params->textbook;
}

/* Whether the centre of a pixel is in it. */
static bool has_pixel(const struct csg_rect *rect)
{
    return ceil(rect->lo[0] - 0.5) < floor(rect->hi[0] + 0.5) &&
           ceil(rect->lo[1] - 0.5) < floor(rect->hi[1] + 0.5);
}

static bool draws_whole(const struct csg_frame_params *params, uint32_t index,
                        const struct csg_rect *rect)
{
    return index != CSG_WHOLE_LAYER &&
           (params->textbook || params->whole(index, csg_rect_area(rect), params->user));
}

/* Where the object is, and what of it is seen; an empty one: nothing. false: out of memory. */
static bool object_rect(struct packer *packer, const struct csg_object *object, uint32_t index,
                        struct csg_rect *rect)
{
    const struct csg_frame_params *params = packer->params;
    *rect = csg_screen_rect(&packer->frame->screen, &csg_map_identity, &object->box);
    if (csg_rect_is_empty(rect))
        return true;
    if (!csg_terms_see(&packer->terms, object,
                       params->cells == CSG_CELLS_ALWAYS || draws_whole(params, index, rect)))
        return false;
    if (packer->terms.seen.begin < packer->terms.seen.end)
        return csg_seen_narrow(&packer->terms.seen, packer->scene, &packer->frame->screen, rect);
    *rect = (struct csg_rect){{1, 1}, {0, 0}};
    return true;
}

/* One for all objects: their flush faces then have the same keys to the last bit. */
static struct csg_pixel reference_pixel(const struct csg_screen *screen, const struct csg_box *box)
{
    if (!csg_box_is_empty(box) && csg_box_is_finite(box))
        return csg_screen_pixel(screen, csg_box_middle(box));
    return (struct csg_pixel){floor(0.5 * screen->width), floor(0.5 * screen->height)};
}

/* A point may cover so many pixels more than the rectangle. */
#define MAX_SPARE_PIXELS 256.0

/* Where many objects are drawn, a rectangle becomes a square of whole pixels in the picture, which
 * is drawn as one point. */
static struct csg_rect squared(const struct packer *packer, const struct csg_rect *rect)
{
    const double sizes[2] = {packer->frame->screen.width, packer->frame->screen.height};
    struct csg_rect square;
    double size[2], side = 0;
    for (int i = 0; i < 2; i++) {
        square.lo[i] = ceil(rect->lo[i] - 0.5);
        size[i] = floor(rect->hi[i] + 0.5) - square.lo[i];
        side = fmax(side, size[i]);
    }
    if (!has_many(packer) || side * side - size[0] * size[1] > MAX_SPARE_PIXELS ||
        side > fmin(sizes[0], sizes[1]))
        return *rect;
    for (int i = 0; i < 2; i++) {
        square.lo[i] = fmin(square.lo[i], sizes[i] - side);
        square.hi[i] = square.lo[i] + side;
    }
    return square;
}

/* The object in one rectangle, all records as planned. */
static bool add_whole(struct packer *packer, const struct csg_rect *rect, struct csg_draw *draw)
{
    struct csg_frame *frame = packer->frame;
    const struct csg_plan *plan = packer->scene->plan;
    const struct csg_rect square = squared(packer, rect);
    csg_draw_set_rect(draw, &frame->screen, &square);
    draw->instance.records[0] = (int32_t)(frame->texels.num / 4);
    for (uint32_t i = plan->begin[draw->object]; i < plan->begin[draw->object + 1]; i++)
        if (!csg_record_add(&packer->terms, &plan->program.data[i], NULL))
            return false;
    draw->instance.records[1] = (int32_t)(frame->texels.num / 4);
    const size_t before = frame->proxy_pixels;
    csg_frame_count(frame, &square, packer->terms.leaves.num);
    if (draw->single)
        csg_singles_note(&frame->singles, packer->scene,
                         plan->program.data[plan->begin[draw->object]].leaf,
                         frame->proxy_pixels - before);
    return csg_array_push(&frame->draws, *draw);
}

/* What only the terms told. */
static void note_stiff(struct packer *packer, uint32_t index)
{
    const struct csg_terms *terms = &packer->terms;
    if (index == CSG_WHOLE_LAYER || !terms->precise ||
        packer->frame->precisions.data[index].precise)
        return;
    packer->frame->precisions.data[index] = (struct csg_precision){.precise = true,
                                                                   .reason = CSG_REASON_STIFF,
                                                                   .leaf = terms->roughest,
                                                                   .resolved = terms->error};
}

static bool tile(struct packer *packer, const struct csg_object *object,
                 const struct csg_rect *rect, const struct csg_draw *draw, size_t max_tests,
                 size_t *tests)
{
    const double start = csg_clock_ms();
    const bool ok = csg_tile_object(&packer->terms, object, rect, draw, max_tests, tests);
    packer->frame->tile_ms += csg_clock_ms() - start;
    return ok;
}

/* ... or cells, where tiles turn out to need more than max_tests. */
static bool add_tiles(struct packer *packer, const struct csg_object *object,
                      const struct csg_rect *rect, const struct csg_draw *draw, size_t max_tests)
{
    size_t tests;
    if (!tile(packer, object, rect, draw, max_tests, &tests))
        return false;
    csg_cells_learn(&packer->terms, rect, draw, tests);
    if (tests <= max_tests)
        return true;
    const struct csg_cells *cells = csg_cells_instead(&packer->terms, object, draw);
    return cells ? csg_walk_add(&packer->terms, cells, rect, draw)
                 : tile(packer, object, rect, draw, SIZE_MAX, &tests);
}

/* The terms of what is seen, and what the draw has of them. */
static bool fill_terms(struct packer *packer, const struct csg_object *object,
                       const struct csg_rect *rect, struct csg_draw *draw)
{
    const bool ok = csg_terms_fill(&packer->terms, object, rect);
    note_stiff(packer, draw->object);
    draw->translucent = packer->terms.translucent;
    draw->stiff = packer->terms.stiff;
    draw->precise = packer->terms.precise;
    return ok;
}

/* ... of all the object, which cells ask for: in float, unless a leaf that is not seen asks for
 * more. */
static bool fill_all(struct packer *packer, const struct csg_object *object,
                     const struct csg_rect *rect, struct csg_draw *draw)
{
    return csg_terms_see(&packer->terms, object, true) && fill_terms(packer, object, rect, draw);
}

static bool add_object(struct packer *packer, const struct csg_object *object, uint32_t index)
{
    struct csg_rect rect;
    if (!object_rect(packer, object, index, &rect))
        return false;
    if (csg_rect_is_empty(&rect) || (has_many(packer) && !has_pixel(&rect)))
        return true;
    const struct csg_precision precision =
        csg_frame_precision(packer->frame, packer->scene, index, object->layer);
    packer->terms.precise = precision.precise;
    struct csg_draw draw = {.object = index, .layer = object->layer, .paint = object->paint};
    if (!fill_terms(packer, object, &rect, &draw))
        return false;
    draw.single = packer->terms.leaves.num == 1 && !packer->terms.seen.is_part &&
                  !(packer->terms.leaves.data[0].flags &
                    (CSG_RECORD_GAP | CSG_RECORD_NEGATED | CSG_RECORD_SURFACE));
    draw.has_rear = (draw.translucent || draw.paint == CSG_LAYER_HIGHLIGHT) &&
                    index != CSG_WHOLE_LAYER && csg_object_is_one_node(packer->scene, object);
    draw.around_eye =
        index == CSG_WHOLE_LAYER || csg_screen_eye_is_in(&packer->frame->screen, &object->box);
    const struct csg_cells *cells = NULL;
    size_t max_tests = SIZE_MAX;
    if (!draw.has_rear &&
        !csg_cells_choose(&packer->terms, object, &rect, &draw, &cells, &max_tests))
        return false;
    const bool is_part = packer->terms.seen.is_part;
    if (cells && is_part && !fill_all(packer, object, &rect, &draw))
        return false;
    if (cells && !draw.precise)
        return csg_walk_add(&packer->terms, cells, &rect, &draw);
    if (!is_part && packer->terms.views.num == 0 && draws_whole(packer->params, index, &rect))
        return add_whole(packer, &rect, &draw);
    draw.tile = true;
    if (index != CSG_WHOLE_LAYER && !is_part && csg_tile_is_small(object, &rect))
        return csg_tile_queue_add(&packer->queue, &packer->terms, object, &rect, &draw);
    return add_tiles(packer, object, &rect, &draw, max_tests);
}

/* Tiles what was left for later. */
static bool run_queue(struct packer *packer)
{
    const double start = csg_clock_ms();
    const bool ok = csg_tile_queue_run(&packer->queue, packer->frame);
    packer->frame->tile_ms += csg_clock_ms() - start;
    return ok;
}

/* Objects are independent only as seen from outside: an eye inside one of them looks for the end of
 * their union. Orthographic rays start inside what has no end towards the eye. */
static bool starts_inside(const struct packer *packer, uint8_t layer)
{
    const struct csg_screen *screen = &packer->frame->screen;
    for (size_t i = 0; i < packer->frame->listed.num; i++) {
        const struct csg_object *object =
            &packer->scene->objects->data[packer->frame->listed.data[i]];
        if (object->layer == layer && csg_screen_eye_is_in(screen, &object->box) &&
            (screen->orthographic ||
             csg_object_is_near(packer->scene, object, screen->origin, screen->near)))
            return true;
    }
    return false;
}

/* Where the depth buffer is too coarse for the little that the picture shows, several objects have
 * to be compared in the program. */
static bool is_too_fine(const struct packer *packer, uint8_t layer)
{
    const struct csg_frame *frame = packer->frame;
    size_t num = 0, zoomed = 0;
    for (size_t i = 0; i < frame->crowd.runs.num && layer == CSG_LAYER_MODEL; i++)
        num += frame->crowd.runs.data[i].num_members;
    for (size_t i = 0; i < frame->listed.num; i++) {
        const uint32_t index = frame->listed.data[i];
        const struct csg_object *object = &packer->scene->objects->data[index];
        if (object->layer != layer || object->hidden || csg_box_is_empty(&object->box))
            continue;
        num++;
        zoomed += frame->precisions.data[index].zoomed;
    }
    return num > 1 && zoomed > 0;
}

static bool is_one(const struct packer *packer, uint8_t layer)
{
    if (packer->params->textbook)
        return false;
    return starts_inside(packer, layer) || (layer == CSG_LAYER_MODEL && is_too_fine(packer, layer));
}

static bool add_layer(struct packer *packer, uint8_t layer)
{
    const struct csg_object *objects = packer->scene->objects->data;
    const struct csg_frame *frame = packer->frame;
    if (is_one(packer, layer)) {
        const struct csg_object whole = {.layer = layer,
                                         .paint = layer,
                                         .end = (uint32_t)packer->scene->trees[layer].num,
                                         .box = csg_box_all};
        if (layer == CSG_LAYER_MODEL)
            packer->frame->crowd.runs.num = packer->frame->crowd.owners.num = 0;
        return add_object(packer, &whole, CSG_WHOLE_LAYER);
    }
    for (size_t i = 0; i < frame->listed.num; i++) {
        const uint32_t object = frame->listed.data[i];
        if (objects[object].layer == layer && !objects[object].hidden &&
            !add_object(packer, &objects[object], object))
            return false;
    }
    return run_queue(packer);
}

/* The scene's box, or, where it has none, that of its finite solids and of the unbounded ones'
 * places. */
static struct csg_box focus_of(const struct csgcast_scene *scene)
{
    struct csg_box focus = csg_box_empty;
    if (csg_box_is_finite(&scene->drawn))
        return scene->drawn;
    for (size_t i = 0; i < scene->num_leaves; i++) {
        const struct csg_shape *shape = &scene->leaves[i].shape;
        if (scene->leaves[i].is_empty)
            continue;
        const struct csg_box box = csg_box_map(&shape->frame, &shape->bounds);
        if (csg_box_is_finite(&box))
            focus = csg_box_union(&focus, &box);
        else
            csg_box_extend(&focus, csg_map_point(&shape->frame, csg_vec3(0, 0, 0)));
    }
    return focus;
}

/* Which objects are drawn one by one. */
static bool list_objects(struct csg_frame *frame, const struct csgcast_scene *scene,
                         const struct csg_frame_params *params)
{
    const uint32_t num = (uint32_t)scene->objects->num;
    frame->crowd.runs.num = frame->listed.num = 0;
    frame->crowd.owners.num = 0;
    frame->crowd.together = false;
    if (params->crowds)
        return csg_crowd_fill(frame, scene, params);
    if (!csg_array_reserve(&frame->listed, num + 1))
        return false;
    for (uint32_t i = 0; i < num; i++)
        frame->listed.data[frame->listed.num++] = i;
    return true;
}

bool csg_frame_fill(struct csg_frame *frame, const struct csgcast_scene *scene,
                    const struct csg_frame_params *params)
{
    struct packer packer = {.frame = frame, .scene = scene, .params = params};
    const struct csg_box focus = focus_of(scene);
    csg_screen_init(&frame->screen, params->frustum, params->width, params->height, &focus,
                    csg_box_is_finite(&scene->drawn));
    frame->at = reference_pixel(&frame->screen, &focus);
    if (params->textbook) {
        csg_screen_use_textbook(&frame->screen, &focus, csg_box_is_finite(&scene->drawn));
        frame->at = (struct csg_pixel){0.5 * params->width, 0.5 * params->height};
    }
    csg_screen_set_near(&frame->screen, csg_eye_near(scene, frame->screen.origin));
    frame->num_threads = params->num_threads;
    csg_frame_clear(frame);
    bool ok = csg_terms_init(&packer.terms, frame, scene, params) &&
              csg_singles_start(&frame->singles, scene, params->leaves) &&
              list_objects(frame, scene, params) && csg_frame_judge(frame, scene, params, &focus);
    for (uint8_t layer = 0; layer < CSG_NUM_LAYERS && ok; layer++)
        ok = add_layer(&packer, layer);
    csg_terms_finish(&packer.terms);
    csg_tile_queue_finish(&packer.queue);
    return ok;
}
