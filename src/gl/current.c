/* SPDX-License-Identifier: MIT */
#include "gl/current.h"

#include <stddef.h>

#include "gl/library.h"

/* The bound API is a state of the thread as well, and csgcast binds desktop OpenGL. */
static void save_egl(struct csg_gl_current *current)
{
    const struct csg_egl_api *egl = &current->egl.api;
    if (!egl->library)
        return;
    current->egl.bound_api = egl->QueryAPI();
    current->egl.context = egl->GetCurrentContext();
    if (current->egl.context == EGL_NO_CONTEXT)
        return;
    current->egl.display = egl->GetCurrentDisplay();
    current->egl.draw = egl->GetCurrentSurface(EGL_DRAW);
    current->egl.read = egl->GetCurrentSurface(EGL_READ);
    egl->MakeCurrent(current->egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

static void restore_egl(struct csg_gl_current *current)
{
    const struct csg_egl_api *egl = &current->egl.api;
    if (!egl->library)
        return;
    egl->BindAPI(current->egl.bound_api);
    if (current->egl.context != EGL_NO_CONTEXT)
        egl->MakeCurrent(current->egl.display, current->egl.draw, current->egl.read,
                         current->egl.context);
}

static void save_glx(struct csg_gl_current *current)
{
    const struct csg_glx_api *glx = &current->glx.api;
    if (!glx->library)
        return;
    current->glx.context = glx->GetCurrentContext();
    if (!current->glx.context)
        return;
    current->glx.display = glx->GetCurrentDisplay();
    current->glx.draw = glx->GetCurrentDrawable();
    current->glx.read = glx->GetCurrentReadDrawable();
    glx->MakeContextCurrent(current->glx.display, 0, 0, NULL);
}

static void restore_glx(struct csg_gl_current *current)
{
    const struct csg_glx_api *glx = &current->glx.api;
    if (!glx->library)
        return;
    if (current->glx.context)
        glx->MakeContextCurrent(current->glx.display, current->glx.draw, current->glx.read,
                                current->glx.context);
}

/* OSMesa draws into the caller's memory: what is in flight has to arrive there. */
static void finish_osmesa(const struct csg_osmesa_api *osmesa)
{
    const PFNGLFINISHPROC finish = (PFNGLFINISHPROC)osmesa->GetProcAddress("glFinish");
    if (finish)
        finish();
}

static void save_osmesa(struct csg_gl_current *current)
{
    const struct csg_osmesa_api *osmesa = &current->osmesa.api;
    if (!osmesa->library)
        return;
    current->osmesa.context = osmesa->GetCurrentContext();
    if (!current->osmesa.context)
        return;
    GLint format;
    finish_osmesa(osmesa);
    osmesa->GetColorBuffer(current->osmesa.context, &current->osmesa.width, &current->osmesa.height,
                           &format, &current->osmesa.buffer);
    osmesa->GetIntegerv(CSG_OSMESA_TYPE, &current->osmesa.type);
    osmesa->MakeCurrent(NULL, NULL, 0, 0, 0);
}

static void restore_osmesa(struct csg_gl_current *current)
{
    const struct csg_osmesa_api *osmesa = &current->osmesa.api;
    if (!osmesa->library)
        return;
    if (current->osmesa.context)
        osmesa->MakeCurrent(current->osmesa.context, current->osmesa.buffer,
                            (GLenum)current->osmesa.type, current->osmesa.width,
                            current->osmesa.height);
}

/* The process may have loaded them since. */
static void find_apis(struct csg_gl_current *current)
{
    const unsigned long long generation = csg_library_generation();
    if (generation && generation == current->generation)
        return;
    csg_gl_current_finish(current);
    csg_egl_api_find(&current->egl.api);
    csg_glx_api_find(&current->glx.api);
    csg_osmesa_api_find(&current->osmesa.api);
    current->generation = generation;
}

/*
 * OSMesa comes last: OSMesaGetCurrentContext reads the pointer that Mesa's drivers share and would
 * take an EGL or GLX context for its own.
 */
void csg_gl_current_save(struct csg_gl_current *current)
{
    find_apis(current);
    save_egl(current);
    save_glx(current);
    save_osmesa(current);
}

void csg_gl_current_restore(struct csg_gl_current *current)
{
    restore_osmesa(current);
    restore_glx(current);
    restore_egl(current);
}

void csg_gl_current_finish(struct csg_gl_current *current)
{
    csg_egl_api_close(&current->egl.api);
    csg_glx_api_close(&current->glx.api);
    csg_osmesa_api_close(&current->osmesa.api);
}
