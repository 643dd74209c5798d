/* SPDX-License-Identifier: MIT */
#ifndef CSG_GL_CONTEXT_H
#define CSG_GL_CONTEXT_H

/*
 * An OpenGL 3.3 core context without a window: EGL surfaceless, an EGL device, or OSMesa, each
 * loaded at run time. The functions of the context are members of struct csg_gl, so that two
 * contexts of different drivers can live in one process: gl->Clear(GL_COLOR_BUFFER_BIT).
 */

#include <GL/glcorearb.h>

#include "common/log.h"

struct csg_gl {
    struct csg_log log;
    const char *name;     /* "egl: <renderer>, <version>"; lives as long as the context */
    bool has_double;      /* GL_ARB_gpu_shader_fp64 or 4.0 */
    bool has_pack_invert; /* GL_MESA_pack_invert */
    bool is_llvmpipe;
    /* Set by the owner: csg_gl_destroy ends all that the process has on the display, with which
     * Mesa writes what it has compiled to its cache; else a thread does, when a core is idle. */
    bool ends_display;
    const struct csg_gl_platform *platform;
    PFNGLDRAWARRAYSINSTANCEDBASEINSTANCEPROC DrawArraysInstancedBaseInstance; /* or NULL */
#define CSG_GL_FUNCTION(type, name) type name;
#include "gl/functions.def"
#undef CSG_GL_FUNCTION
};

/* backend: AUTO, EGL or OSMESA. NULL, with a message, where there is no such context. */
struct csg_gl *csg_gl_create(enum csgcast_backend backend, const struct csg_log *log);
void csg_gl_destroy(struct csg_gl *gl);

/* Makes the context current and remembers what was current; false, with a message, on failure. */
bool csg_gl_enter(struct csg_gl *gl);

/* Reports any pending GL error (false), then restores what was current before enter. */
bool csg_gl_leave(struct csg_gl *gl);

#endif
