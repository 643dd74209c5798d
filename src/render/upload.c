/* SPDX-License-Identifier: MIT */

/* A frame's data to the driver: the float texture, and the instances of what is drawn. */

#include "render/renderer.h"

#include <stdlib.h>

#include "common/clock.h"

/* What a buffer holds already is written over: nothing is drawn from it any more. */
static void fill_buffer(struct csg_gl *gl, GLenum target, struct csg_buffer *buffer, size_t bytes,
                        const void *data)
{
    gl->BindBuffer(target, buffer->id);
    if (bytes <= buffer->bytes) {
        gl->BufferSubData(target, 0, (GLsizeiptr)bytes, data);
        return;
    }
    gl->BufferData(target, (GLsizeiptr)bytes, data, GL_STREAM_DRAW);
    buffer->bytes = bytes;
}

static void ensure_buffers(struct csgcast_renderer *renderer)
{
    struct csg_gl *gl = renderer->gl;
    if (renderer->data_texture)
        return;
    gl->GenTextures(1, &renderer->data_texture);
    gl->GenBuffers(1, &renderer->data_buffer.id);
    gl->GenTextures(1, &renderer->owners_texture);
    gl->GenBuffers(1, &renderer->owners_buffer.id);
    gl->GenBuffers(1, &renderer->instance_buffer.id);
    gl->GenBuffers(1, &renderer->crowd_buffer.id);
    gl->GenVertexArrays(1, &renderer->vertex_array);
    gl->GenVertexArrays(1, &renderer->crowd_array);
    gl->GenVertexArrays(1, &renderer->empty_array);
}

static bool upload_data(struct csgcast_renderer *renderer)
{
    struct csg_gl *gl = renderer->gl;
    const struct csg_frame *frame = &renderer->frame;
    const size_t bytes = frame->texels.num * sizeof(float);
    GLint max_texels = 0;
    gl->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &max_texels);
    if (frame->texels.num / 4 > (size_t)max_texels) {
        csg_log_error(&renderer->log, CSGCAST_MESSAGE_CONTEXT,
                      "the scene needs a texture of %zu texels and this driver allows %d: use "
                      "--backend=reference, or split the scene",
                      frame->texels.num / 4, max_texels);
        return false;
    }
    fill_buffer(gl, GL_TEXTURE_BUFFER, &renderer->data_buffer, bytes, frame->texels.data);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_BUFFER, renderer->data_texture);
    gl->TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, renderer->data_buffer.id);
    renderer->stats.texture_bytes = bytes;
    return true;
}

static bool upload_instances(struct csgcast_renderer *renderer)
{
    struct csg_gl *gl = renderer->gl;
    const size_t num = renderer->frame.draws.num;
    struct csg_instance *instances = malloc((num + 1) * sizeof *instances);
    if (!instances)
        return csg_log_memory(&renderer->log);
    for (size_t i = 0; i < num; i++)
        instances[i] = renderer->frame.draws.data[i].instance;
    fill_buffer(gl, GL_ARRAY_BUFFER, &renderer->instance_buffer, num * sizeof *instances,
                instances);
    free(instances);
    const struct csg_frame_crowd *crowd = &renderer->frame.crowd;
    const size_t crowd_bytes = crowd->runs.num ? crowd->instances.num * sizeof(float) : 0;
    if (crowd_bytes)
        fill_buffer(gl, GL_ARRAY_BUFFER, &renderer->crowd_buffer, crowd_bytes,
                    crowd->instances.data);
    renderer->stats.bytes_uploaded =
        renderer->stats.texture_bytes + num * sizeof *instances + crowd_bytes;
    return true;
}

static void upload_owners(struct csgcast_renderer *renderer)
{
    struct csg_gl *gl = renderer->gl;
    const struct csg_frame_crowd *crowd = &renderer->frame.crowd;
    const size_t bytes = crowd->owners.num * sizeof *crowd->owners.data;
    if (!bytes)
        return;
    fill_buffer(gl, GL_TEXTURE_BUFFER, &renderer->owners_buffer, bytes, crowd->owners.data);
    gl->ActiveTexture(GL_TEXTURE0 + CSG_OWNERS_UNIT);
    gl->BindTexture(GL_TEXTURE_BUFFER, renderer->owners_texture);
    gl->TexBuffer(GL_TEXTURE_BUFFER, GL_R32I, renderer->owners_buffer.id);
    gl->ActiveTexture(GL_TEXTURE0);
    renderer->stats.texture_bytes += bytes;
    renderer->stats.bytes_uploaded += bytes;
}

bool csg_upload_frame(struct csgcast_renderer *renderer)
{
    const double start = csg_clock_ms();
    ensure_buffers(renderer);
    size_t cells = 0;
    const bool ok = upload_data(renderer) && upload_instances(renderer) &&
                    csg_cells_upload(renderer, &cells);
    upload_owners(renderer);
    renderer->stats.texture_bytes += renderer->frame.cells.num ? renderer->cells.buffer.bytes : 0;
    renderer->stats.bytes_uploaded += cells;
    renderer->stats.upload_ms = csg_clock_ms() - start;
    return ok;
}
