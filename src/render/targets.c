/* SPDX-License-Identifier: MIT */
#include "render/targets.h"

static GLuint make_texture(struct csg_gl *gl, GLint internal, GLenum format, GLenum type,
                           const struct csg_targets *targets)
{
    GLuint texture;
    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_RECTANGLE, texture);
    gl->TexImage2D(GL_TEXTURE_RECTANGLE, 0, internal, targets->width, targets->height, 0, format,
                   type, NULL);
    gl->TexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

static void attach(struct csg_gl *gl, GLenum attachment, GLuint texture)
{
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_RECTANGLE, texture, 0);
}

/* All passes look at the one depth buffer. */
static bool is_complete(struct csg_gl *gl, const struct csg_targets *targets)
{
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                targets->depth);
    return gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

static void make_depth(struct csg_targets *targets, struct csg_gl *gl)
{
    gl->GenRenderbuffers(1, &targets->depth);
    gl->BindRenderbuffer(GL_RENDERBUFFER, targets->depth);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, targets->width,
                            targets->height);
}

static bool make_geometry(struct csg_targets *targets, struct csg_gl *gl)
{
    targets->visible = make_texture(gl, GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, targets);
    gl->GenFramebuffers(1, &targets->geometry_fbo);
    gl->BindFramebuffer(GL_FRAMEBUFFER, targets->geometry_fbo);
    attach(gl, GL_COLOR_ATTACHMENT0, targets->visible);
    return is_complete(gl, targets);
}

static bool make_floats(struct csg_targets *targets, struct csg_gl *gl,
                        const struct csg_targets_use *use)
{
    if (!targets->shade_fbo)
        gl->GenFramebuffers(1, &targets->shade_fbo);
    gl->BindFramebuffer(GL_FRAMEBUFFER, targets->shade_fbo);
    if (!targets->color)
        targets->color = make_texture(gl, GL_RGBA32F, GL_RGBA, GL_FLOAT, targets);
    if (!targets->geometry && use->geometry)
        targets->geometry = make_texture(gl, GL_RGBA32F, GL_RGBA, GL_FLOAT, targets);
    if (!targets->leaf && use->leaf)
        targets->leaf = make_texture(gl, GL_R32F, GL_RED, GL_FLOAT, targets);
    attach(gl, GL_COLOR_ATTACHMENT0, targets->color);
    attach(gl, GL_COLOR_ATTACHMENT1, targets->geometry);
    attach(gl, GL_COLOR_ATTACHMENT2, targets->leaf);
    return is_complete(gl, targets);
}

static bool make_bytes(struct csg_targets *targets, struct csg_gl *gl)
{
    targets->bytes = make_texture(gl, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, targets);
    gl->GenFramebuffers(1, &targets->bytes_fbo);
    gl->BindFramebuffer(GL_FRAMEBUFFER, targets->bytes_fbo);
    attach(gl, GL_COLOR_ATTACHMENT0, targets->bytes);
    return is_complete(gl, targets);
}

/* What a driver of OpenGL 3.3 allows is 1024 pixels each way at least. */
static bool is_too_large(struct csg_gl *gl, int width, int height)
{
    GLint textures = 0, buffers = 0;
    gl->GetIntegerv(GL_MAX_RECTANGLE_TEXTURE_SIZE, &textures);
    gl->GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffers);
    const GLint max = textures < buffers ? textures : buffers;
    if (width <= max && height <= max)
        return false;
    csg_log_error(&gl->log, CSGCAST_MESSAGE_CONTEXT,
                  "the image has %d x %d pixels and this driver allows %d each way: use "
                  "--backend=reference, or a smaller image",
                  width, height, max);
    return true;
}

bool csg_targets_resize(struct csg_targets *targets, struct csg_gl *gl, int width, int height,
                        const struct csg_targets_use *use)
{
    bool ok = true;
    if (targets->width != width || targets->height != height) {
        if (is_too_large(gl, width, height))
            return false;
        csg_targets_finish(targets, gl);
        targets->width = width;
        targets->height = height;
        make_depth(targets, gl);
    }
    if (!use->direct && !targets->geometry_fbo)
        ok = make_geometry(targets, gl);
    if (ok && use->bytes && !targets->bytes_fbo)
        ok = make_bytes(targets, gl);
    if (ok && !use->bytes)
        ok = make_floats(targets, gl, use);
    if (ok)
        return true;
    csg_log_error(&gl->log, CSGCAST_MESSAGE_CONTEXT,
                  "the driver cannot draw into textures of %d x %d pixels", width, height);
    csg_targets_finish(targets, gl);
    return false;
}

void csg_targets_finish(struct csg_targets *targets, struct csg_gl *gl)
{
    const GLuint textures[] = {targets->visible, targets->color, targets->geometry, targets->leaf,
                               targets->bytes};
    const GLuint framebuffers[] = {targets->geometry_fbo, targets->shade_fbo, targets->bytes_fbo};
    if (targets->width) {
        gl->DeleteFramebuffers(3, framebuffers);
        gl->DeleteTextures(5, textures);
        gl->DeleteRenderbuffers(1, &targets->depth);
    }
    *targets = (struct csg_targets){0};
}
