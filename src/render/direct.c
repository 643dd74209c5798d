/* SPDX-License-Identifier: MIT */
#include "render/direct.h"

#include <math.h>

/* Where more fragments than these a pixel would be lit, a pass of its own is cheaper. */
#define MAX_LIT 2.0

/* A view that moves would compile the programs of both ways where its fragments come to about that:
 * it changes its way only where they are more, or fewer, by this factor. */
#define MARGIN 1.5

/* llvmpipe runs blocks of 4 x 4 fragments: what a rectangle has of them beyond its edges. */
#define EDGE_FRAGMENTS 16

static void add_rect(float rect[4], const float *other)
{
    for (int i = 0; i < 2; i++) {
        rect[i] = fminf(rect[i], other[i]);
        rect[2 + i] = fmaxf(rect[2 + i], other[2 + i]);
    }
}

void csg_bound_object(const struct csg_frame *frame, uint32_t object, float rect[4])
{
    rect[0] = rect[1] = 1;
    rect[2] = rect[3] = -1;
    for (size_t i = 0; i < frame->draws.num; i++)
        if (object == CSG_ANY_OBJECT || frame->draws.data[i].object == object)
            add_rect(rect, frame->draws.data[i].instance.rect);
}

void csg_bound_draws(const struct csg_frame *frame, float rect[4])
{
    const struct csg_frame_crowd *crowd = &frame->crowd;
    csg_bound_object(frame, CSG_ANY_OBJECT, rect);
    for (size_t i = 0; i < crowd->runs.num; i++) {
        const struct csg_crowd_run *run = &crowd->runs.data[i];
        for (size_t j = 0; j < run->num; j++)
            add_rect(rect, crowd->instances.data + run->first + j * run->stride);
    }
}

static size_t count_crowd(const struct csg_frame *frame)
{
    size_t num = 0;
    for (size_t i = 0; i < frame->crowd.runs.num; i++)
        num += frame->crowd.runs.data[i].num_members;
    return num;
}

bool csg_is_disjoint(const struct csg_frame *frame)
{
    size_t num = count_crowd(frame);
    for (size_t i = 0; i < frame->draws.num; i++)
        num += i == 0 || frame->draws.data[i].object != frame->draws.data[i - 1].object;
    return num <= 1;
}

static bool is_opaque(const struct csg_draw *draw)
{
    return !draw->translucent && draw->layer == CSG_LAYER_MODEL && draw->paint == CSG_LAYER_MODEL;
}

/* Fragments a pixel, about. */
static double count_lit(const struct csg_frame *frame, const struct csg_request *request)
{
    float rect[4];
    if (csg_is_disjoint(frame))
        return 0;
    csg_bound_draws(frame, rect);
    const double width = 0.5 * ((double)rect[2] - (double)rect[0]) * request->width;
    const double height = 0.5 * ((double)rect[3] - (double)rect[1]) * request->height;
    size_t num = frame->draws.num;
    for (size_t i = 0; i < frame->crowd.runs.num; i++)
        num += frame->crowd.runs.data[i].num;
    return (double)(frame->proxy_pixels + EDGE_FRAGMENTS * num) / (width * height);
}

/* Frames after an edit keep to what the one before was, so that nothing is compiled; so do forced
 * variants of scenes that are edited, which compile no more than they need. */
static bool is_thin(struct csgcast_renderer *renderer, const struct csg_request *request)
{
    const bool is_known = renderer->thin_scene == request->scene->number;
    const bool was_thin = is_known && renderer->thin;
    const bool forced = request->scene->keeps_structure && request->resolver >= 0;
    if (request->after_edit || (is_known && forced))
        return was_thin;
    const double margin = !is_known ? 1 : was_thin ? MARGIN : 1 / MARGIN;
    renderer->thin_scene = request->scene->number;
    renderer->thin = count_lit(&renderer->frame, request) <= margin * MAX_LIT;
    return renderer->thin;
}

bool csg_draws_directly(struct csgcast_renderer *renderer, const struct csg_request *request)
{
    const struct csgcast_image *image = request->image;
    const struct csg_frame *frame = &renderer->frame;
    if (!image->rgba8 || image->rgba || image->z || image->normal || image->id || request->textbook)
        return false;
    for (size_t i = 0; i < frame->draws.num; i++)
        if (!is_opaque(&frame->draws.data[i]))
            return false;
    return is_thin(renderer, request);
}
