/* SPDX-License-Identifier: MIT */

/* Cells depend on the scene alone: they are handed to the driver when they change. */

#include "render/renderer.h"

#include <stdlib.h>

#include "cells/cells.h"

static bool is_resident(const struct csg_resident_cells *resident, const struct csg_frame *frame)
{
    if (resident->hashes.num < frame->cells.num)
        return false;
    for (size_t i = 0; i < frame->cells.num; i++)
        if (frame->cells.data[i].cells->hash != resident->hashes.data[i])
            return false;
    return true;
}

static size_t count_texels(const struct csg_frame *frame)
{
    size_t num = 0;
    for (size_t i = 0; i < frame->cells.num; i++)
        num += frame->cells.data[i].cells->texels.num / 4;
    return num;
}

static bool is_too_large(struct csgcast_renderer *renderer, size_t num)
{
    GLint max = 0;
    renderer->gl->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &max);
    if (num <= (size_t)max)
        return false;
    csg_log_error(&renderer->log, CSGCAST_MESSAGE_CONTEXT,
                  "the scene's cells need a texture of %zu texels and this driver allows %d: use "
                  "--variant=loop or --backend=reference",
                  num, max);
    return true;
}

static void fill(struct csg_gl *gl, struct csg_resident_cells *resident,
                 const struct csg_frame *frame, size_t bytes)
{
    if (!resident->texture) {
        gl->GenTextures(1, &resident->texture);
        gl->GenBuffers(1, &resident->buffer.id);
    }
    gl->BindBuffer(GL_TEXTURE_BUFFER, resident->buffer.id);
    gl->BufferData(GL_TEXTURE_BUFFER, (GLsizeiptr)bytes, NULL, GL_STATIC_DRAW);
    resident->buffer.bytes = bytes;
    for (size_t i = 0; i < frame->cells.num; i++) {
        const struct csg_frame_cells *part = &frame->cells.data[i];
        gl->BufferSubData(GL_TEXTURE_BUFFER, (GLintptr)(16 * part->first),
                          (GLsizeiptr)(part->cells->texels.num * sizeof(float)),
                          part->cells->texels.data);
    }
    gl->ActiveTexture(GL_TEXTURE0 + CSG_CELLS_UNIT);
    gl->BindTexture(GL_TEXTURE_BUFFER, resident->texture);
    gl->TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, resident->buffer.id);
    gl->ActiveTexture(GL_TEXTURE0);
}

bool csg_cells_upload(struct csgcast_renderer *renderer, size_t *uploaded)
{
    struct csg_resident_cells *resident = &renderer->cells;
    const struct csg_frame *frame = &renderer->frame;
    const size_t num = count_texels(frame);
    if (is_resident(resident, frame))
        return true;
    resident->hashes.num = 0;
    if (is_too_large(renderer, num))
        return false;
    fill(renderer->gl, resident, frame, 16 * num);
    for (size_t i = 0; i < frame->cells.num; i++)
        if (!csg_array_push(&resident->hashes, frame->cells.data[i].cells->hash))
            return csg_log_memory(&renderer->log);
    *uploaded += 16 * num;
    return true;
}

void csg_cells_drop(struct csgcast_renderer *renderer)
{
    struct csg_resident_cells *resident = &renderer->cells;
    if (resident->texture) {
        renderer->gl->DeleteTextures(1, &resident->texture);
        renderer->gl->DeleteBuffers(1, &resident->buffer.id);
    }
    free(resident->hashes.data);
}
