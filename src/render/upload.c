/* SPDX-License-Identifier: MIT */

/* A frame's data to the driver: the float texture, and the instances of what is drawn. */

#include "render/renderer.h"

#include <stdlib.h>
#include <string.h>

#include "common/clock.h"

static void ensure_buffers(struct csgcast_renderer *renderer)
{
    struct csg_gl *gl = renderer->gl;
    if (renderer->data_texture)
        return;
    gl->GenTextures(1, &renderer->data_texture);
    gl->GenBuffers(1, &renderer->data_buffer);
    gl->GenBuffers(1, &renderer->instance_buffer);
    gl->GenBuffers(1, &renderer->crowd_buffer);
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
    gl->BindBuffer(GL_TEXTURE_BUFFER, renderer->data_buffer);
    gl->BufferData(GL_TEXTURE_BUFFER, (GLsizeiptr)bytes, frame->texels.data, GL_STREAM_DRAW);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_BUFFER, renderer->data_texture);
    gl->TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, renderer->data_buffer);
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
    gl->BindBuffer(GL_ARRAY_BUFFER, renderer->instance_buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(num * sizeof *instances), instances,
                   GL_STREAM_DRAW);
    free(instances);
    const struct csg_frame_crowd *crowd = &renderer->frame.crowd;
    const size_t crowd_bytes = crowd->runs.num ? crowd->instances.num * sizeof(float) : 0;
    if (crowd_bytes) {
        gl->BindBuffer(GL_ARRAY_BUFFER, renderer->crowd_buffer);
        gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)crowd_bytes, crowd->instances.data,
                       GL_STREAM_DRAW);
    }
    renderer->stats.bytes_uploaded =
        renderer->stats.texture_bytes + num * sizeof *instances + crowd_bytes;
    return true;
}

bool csg_upload_frame(struct csgcast_renderer *renderer)
{
    const double start = csg_clock_ms();
    ensure_buffers(renderer);
    const bool ok = upload_data(renderer) && upload_instances(renderer);
    renderer->stats.upload_ms = csg_clock_ms() - start;
    return ok;
}
