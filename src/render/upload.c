/* SPDX-License-Identifier: MIT */

/* A frame's data to the driver: the float texture, and the instances of what is drawn. */

#include "render/renderer.h"

#include <stdlib.h>

#include "common/clock.h"
#include "render/inputs.h"

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
    gl->GenVertexArrays(1, &renderer->point_array);
    gl->GenVertexArrays(1, &renderer->crowd_array);
    gl->GenVertexArrays(1, &renderer->empty_array);
    csg_inputs_prepare(renderer);
}

static bool upload_data(struct csgcast_renderer *renderer, bool keeps)
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
    renderer->stats.bytes_uploaded += csg_buffer_fill(gl, GL_TEXTURE_BUFFER, &renderer->data_buffer,
                                                      bytes, frame->texels.data, keeps);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_BUFFER, renderer->data_texture);
    gl->TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, renderer->data_buffer.id);
    renderer->stats.texture_bytes = bytes;
    return true;
}

static bool upload_instances(struct csgcast_renderer *renderer, const struct csg_batches *batches,
                             bool keeps)
{
    struct csg_gl *gl = renderer->gl;
    const size_t num = batches->order.num;
    struct csg_instance *instances = malloc((num + 1) * sizeof *instances);
    if (!instances)
        return csg_log_memory(&renderer->log);
    for (size_t i = 0; i < num; i++)
        instances[i] = renderer->frame.draws.data[batches->order.data[i]].instance;
    renderer->stats.bytes_uploaded += csg_buffer_fill(
        gl, GL_ARRAY_BUFFER, &renderer->instance_buffer, num * sizeof *instances, instances, keeps);
    free(instances);
    const struct csg_frame_crowd *crowd = &renderer->frame.crowd;
    const size_t crowd_bytes = crowd->runs.num ? crowd->instances.num * sizeof(float) : 0;
    if (crowd_bytes)
        renderer->stats.bytes_uploaded +=
            csg_buffer_fill(gl, GL_ARRAY_BUFFER, &renderer->crowd_buffer, crowd_bytes,
                            crowd->instances.data, keeps);
    return true;
}

static void upload_owners(struct csgcast_renderer *renderer, bool keeps)
{
    struct csg_gl *gl = renderer->gl;
    const struct csg_frame_crowd *crowd = &renderer->frame.crowd;
    const size_t bytes = crowd->owners.num * sizeof *crowd->owners.data;
    if (!bytes)
        return;
    renderer->stats.bytes_uploaded += csg_buffer_fill(
        gl, GL_TEXTURE_BUFFER, &renderer->owners_buffer, bytes, crowd->owners.data, keeps);
    gl->ActiveTexture(GL_TEXTURE0 + CSG_OWNERS_UNIT);
    gl->BindTexture(GL_TEXTURE_BUFFER, renderer->owners_texture);
    gl->TexBuffer(GL_TEXTURE_BUFFER, GL_R32I, renderer->owners_buffer.id);
    gl->ActiveTexture(GL_TEXTURE0);
    renderer->stats.texture_bytes += bytes;
}

bool csg_upload_frame(struct csgcast_renderer *renderer, const struct csg_batches *batches,
                      bool keeps)
{
    const double start = csg_clock_ms();
    ensure_buffers(renderer);
    size_t cells = 0;
    const bool ok = upload_data(renderer, keeps) && upload_instances(renderer, batches, keeps) &&
                    csg_cells_upload(renderer, &cells);
    upload_owners(renderer, keeps);
    renderer->stats.texture_bytes += renderer->frame.cells.num ? renderer->cells.buffer.bytes : 0;
    renderer->stats.bytes_uploaded += cells;
    renderer->stats.upload_ms = csg_clock_ms() - start;
    return ok;
}
