/* SPDX-License-Identifier: MIT */
#include "render/buffer.h"

#include <stdlib.h>
#include <string.h>

/* Bytes that are compared, and handed over, at a time: 256 texels. */
enum { ROW = 4096 };

static void forget(struct csg_buffer *buffer)
{
    free(buffer->copy);
    buffer->copy = NULL;
    buffer->num_copied = 0;
}

/* Larger than asked for where it is kept: frames after edits need a little more or less. */
static void grow(struct csg_gl *gl, GLenum target, struct csg_buffer *buffer, size_t bytes,
                 bool keeps)
{
    forget(buffer);
    buffer->bytes = keeps ? bytes + bytes / 8 : bytes;
    gl->BufferData(target, (GLsizeiptr)buffer->bytes, NULL, GL_STREAM_DRAW);
    buffer->copy = keeps ? malloc(buffer->bytes + 1) : NULL;
}

static bool is_same(const struct csg_buffer *buffer, const char *data, size_t at, size_t end)
{
    return end <= buffer->num_copied && memcmp(buffer->copy + at, data + at, end - at) == 0;
}

static size_t row_end(size_t at, size_t bytes)
{
    return bytes - at < ROW ? bytes : at + ROW;
}

/* Hands over the rows that are not what the copy has. */
static size_t fill_changed(struct csg_gl *gl, GLenum target, struct csg_buffer *buffer,
                           size_t bytes, const char *data)
{
    size_t num = 0;
    for (size_t at = 0, end; at < bytes; at = end) {
        end = row_end(at, bytes);
        if (is_same(buffer, data, at, end))
            continue;
        while (end < bytes && !is_same(buffer, data, end, row_end(end, bytes)))
            end = row_end(end, bytes);
        gl->BufferSubData(target, (GLintptr)at, (GLsizeiptr)(end - at), data + at);
        memcpy(buffer->copy + at, data + at, end - at);
        num += end - at;
    }
    buffer->num_copied = bytes > buffer->num_copied ? bytes : buffer->num_copied;
    return num;
}

size_t csg_buffer_fill(struct csg_gl *gl, GLenum target, struct csg_buffer *buffer, size_t bytes,
                       const void *data, bool keeps)
{
    gl->BindBuffer(target, buffer->id);
    if (bytes > buffer->bytes || (keeps && !buffer->copy && bytes > 0))
        grow(gl, target, buffer, bytes, keeps);
    if (keeps && buffer->copy)
        return fill_changed(gl, target, buffer, bytes, data);
    forget(buffer);
    gl->BufferSubData(target, 0, (GLsizeiptr)bytes, data);
    return bytes;
}

void csg_buffer_finish(struct csg_gl *gl, struct csg_buffer *buffer)
{
    gl->DeleteBuffers(1, &buffer->id);
    forget(buffer);
}
