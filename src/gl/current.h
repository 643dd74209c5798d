/* SPDX-License-Identifier: MIT */
#ifndef CSG_GL_CURRENT_H
#define CSG_GL_CURRENT_H

/*
 * What the caller of the library has made current on this thread, whichever window system it came
 * from. A program that embeds csgcast draws with GLX, EGL or OSMesa itself, and the Mesa drivers
 * behind all three share one per-thread pointer to the current context: making ours current while
 * another system's context is would break both. So that one is released first and bound again
 * afterwards.
 */

#include "gl/egl_api.h"
#include "gl/glx_api.h"
#include "gl/osmesa_api.h"

struct csg_gl_current {
    unsigned long long generation; /* of the process's libraries, when the APIs were looked for */
    struct {
        struct csg_egl_api api; /* api.library is NULL where EGL is not loaded */
        EGLenum bound_api;
        EGLDisplay display;
        EGLSurface draw, read;
        EGLContext context;
    } egl;
    struct {
        struct csg_glx_api api;
        csg_glx_display display;
        csg_glx_drawable draw, read;
        csg_glx_context context;
    } glx;
    struct {
        struct csg_osmesa_api api;
        csg_osmesa_context context;
        void *buffer;
        GLint type, width, height;
    } osmesa;
};

/* Afterwards nothing is current on this thread. Needs one restore; *current begins as zeros and may
 * be saved into again then. */
void csg_gl_current_save(struct csg_gl_current *current);
void csg_gl_current_restore(struct csg_gl_current *current);

/* Lets go of the APIs, when nothing is saved. */
void csg_gl_current_finish(struct csg_gl_current *current);

#endif
