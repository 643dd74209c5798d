/* SPDX-License-Identifier: MIT */
#include "pack/frame.h"

#include <stdlib.h>
#include <string.h>

/* Of all parts of a frame, 32 MB: those that take more than their share begin without memory. */
#define MAX_KEPT_TEXELS ((size_t)2 << 20)

float *csg_frame_reserve_texels(struct csg_frame *frame, size_t num)
{
    return csg_array_reserve(&frame->texels, 4 * num) ? frame->texels.data + frame->texels.num
                                                      : NULL;
}

float *csg_frame_add_texels(struct csg_frame *frame, size_t num)
{
    float *texels = csg_frame_reserve_texels(frame, num);
    if (!texels)
        return NULL;
    memset(texels, 0, 4 * num * sizeof *texels);
    frame->texels.num += 4 * num;
    return texels;
}

/* The side of a square of whole pixels; 0: it is none. */
static int32_t side_of(const struct csg_rect *rect)
{
    const double side = rect->hi[0] - rect->lo[0];
    const bool whole = rect->lo[0] == floor(rect->lo[0]) && rect->lo[1] == floor(rect->lo[1]) &&
                       side == floor(side);
    return whole && side == rect->hi[1] - rect->lo[1] ? (int32_t)side : 0;
}

void csg_draw_set_rect(struct csg_draw *draw, const struct csg_screen *screen,
                       const struct csg_rect *rect)
{
    draw->instance.side = side_of(rect);
    const double size[2] = {screen->width, screen->height};
    for (int i = 0; i < 2; i++) {
        draw->instance.rect[i] = (float)(2 * rect->lo[i] / size[i] - 1);
        draw->instance.rect[2 + i] = (float)(2 * rect->hi[i] / size[i] - 1);
    }
}

void csg_frame_count(struct csg_frame *frame, const struct csg_rect *rect, size_t num_leaves)
{
    const size_t pixels =
        (size_t)(ceil(rect->hi[0] - rect->lo[0]) * ceil(rect->hi[1] - rect->lo[1]));
    frame->proxy_pixels += pixels;
    frame->solid_tests += pixels * num_leaves;
}

void csg_frame_clear(struct csg_frame *frame)
{
    frame->texels.num = frame->draws.num = frame->cells.num = 0;
    frame->proxy_pixels = frame->solid_tests = 0;
    frame->tiles_empty = frame->tiles_opaque = frame->tiles_mixed = 0;
    frame->tile_ms = 0;
}

bool csg_frame_append(struct csg_frame *frame, const struct csg_frame *part)
{
    const int32_t base = (int32_t)(frame->texels.num / 4);
    if (!csg_array_reserve(&frame->texels, part->texels.num) ||
        !csg_array_reserve(&frame->draws, part->draws.num))
        return false;
    if (part->texels.num)
        memcpy(frame->texels.data + frame->texels.num, part->texels.data,
               part->texels.num * sizeof *part->texels.data);
    frame->texels.num += part->texels.num;
    for (size_t i = 0; i < part->draws.num; i++) {
        struct csg_draw draw = part->draws.data[i];
        draw.instance.records[0] += base;
        draw.instance.records[1] += base;
        frame->draws.data[frame->draws.num++] = draw;
    }
    frame->proxy_pixels += part->proxy_pixels;
    frame->solid_tests += part->solid_tests;
    frame->tiles_empty += part->tiles_empty;
    frame->tiles_opaque += part->tiles_opaque;
    frame->tiles_mixed += part->tiles_mixed;
    return true;
}

void csg_frame_start_part(struct csg_frame *part, const struct csg_frame *whole)
{
    csg_frame_clear(part);
    part->screen = whole->screen;
    part->at = whole->at;
}

bool csg_frame_start_parts(struct csg_frame *frame, size_t num)
{
    const size_t before = frame->parts.num;
    if (num > before && !csg_array_reserve(&frame->parts, num - before))
        return false;
    for (; frame->parts.num < num; frame->parts.num++)
        frame->parts.data[frame->parts.num] = (struct csg_frame){0};
    for (size_t i = 0; i < num; i++)
        csg_frame_start_part(&frame->parts.data[i], frame);
    return true;
}

void csg_frame_end_part(struct csg_frame *frame, size_t i)
{
    struct csg_frame *part = &frame->parts.data[i];
    if (part->texels.capacity > 4 * MAX_KEPT_TEXELS / frame->parts.num)
        csg_frame_finish(part);
}

void csg_frame_finish(struct csg_frame *frame)
{
    free(frame->texels.data);
    free(frame->draws.data);
    free(frame->cells.data);
    free(frame->precisions.data);
    free(frame->crowd.instances.data);
    free(frame->crowd.runs.data);
    free(frame->crowd.owners.data);
    free(frame->listed.data);
    csg_singles_finish(&frame->singles);
    for (size_t i = 0; i < frame->parts.num; i++)
        csg_frame_finish(&frame->parts.data[i]);
    free(frame->parts.data);
    *frame = (struct csg_frame){0};
}
