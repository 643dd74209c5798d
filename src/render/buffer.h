/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_BUFFER_H
#define CSG_RENDER_BUFFER_H

/* A buffer of the driver's that is written anew with each frame. */

#include "gl/context.h"

struct csg_buffer {
    GLuint id;
    size_t bytes; /* its size */
    char *copy;   /* of what it holds; NULL: nobody knows */
    size_t num_copied;
};

/*
 * Writes data from the buffer's beginning on; nothing is drawn from it any more. keeps: frames
 * after it will differ in little, as those of scenes that are edited do: what it holds is copied,
 * and only what has changed since is handed over. Returns how many bytes were.
 */
size_t csg_buffer_fill(struct csg_gl *gl, GLenum target, struct csg_buffer *buffer, size_t bytes,
                       const void *data, bool keeps);

void csg_buffer_finish(struct csg_gl *gl, struct csg_buffer *buffer);

#endif
