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

/* llvmpipe compiles a program anew for a texture that is empty, or whose size is a power of two, or
 * has zeros for its second byte, which Mesa 22.3.6 takes for a number of levels. No buffer is such:
 * these bits are added. */
enum { COMMON_BITS = 0x130 };

static size_t common_size(size_t bytes)
{
    return (bytes & (bytes - 1)) && (bytes & 0xff00) ? bytes : bytes | COMMON_BITS;
}

/* Larger than asked for where it is kept: frames after edits need a little more or less. */
static void grow(struct csg_gl *gl, GLenum target, struct csg_buffer *buffer, size_t bytes,
                 bool keeps)
{
    forget(buffer);
    buffer->bytes = common_size(keeps ? bytes + bytes / 8 : bytes);
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
    if (bytes > buffer->bytes || buffer->bytes == 0 || (keeps && !buffer->copy && bytes > 0))
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
