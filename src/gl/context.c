/* SPDX-License-Identifier: MIT */
#include "gl/context.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/heap.h"
#include "gl/lock.h"
#include "gl/platform.h"

/* glGetError returns one flag at a time, and on a lost context the same one for ever. */
enum { MAX_ERRORS = 8 };

static const struct csg_gl_platform *const platforms[] = {&csg_gl_egl, &csg_gl_osmesa};

enum { NUM_PLATFORMS = sizeof platforms / sizeof *platforms };

void csg_gl_report_add(struct csg_gl_report *report, const char *format, ...)
{
    const size_t room = sizeof report->text - report->length;
    va_list args;
    va_start(args, format);
    const int length = vsnprintf(report->text + report->length, room, format, args);
    va_end(args);
    if (length > 0)
        report->length += (size_t)length < room ? (size_t)length : room - 1;
}

/* ---- a new context ---- */

static bool load_functions(struct csg_gl_context *context, const char *where,
                           struct csg_gl_report *report)
{
    struct csg_gl *gl = &context->gl;
    const char *missing = NULL;
#define CSG_GL_FUNCTION(type, name)                                                                \
    gl->name = (type)gl->platform->get_proc(context, "gl" #name);                                  \
    missing = gl->name ? missing : "gl" #name;
#include "gl/functions.def"
#undef CSG_GL_FUNCTION
    if (missing)
        csg_gl_report_add(report, " %s lacks the function %s.", where, missing);
    return !missing;
}

static bool has_extension(const struct csg_gl *gl, const char *name)
{
    GLint num = 0;
    gl->GetIntegerv(GL_NUM_EXTENSIONS, &num);
    for (GLuint i = 0; i < (GLuint)num; i++) {
        const char *extension = (const char *)gl->GetStringi(GL_EXTENSIONS, i);
        if (extension && !strcmp(extension, name))
            return true;
    }
    return false;
}

static bool init_version(struct csg_gl_context *context, const char *where,
                         struct csg_gl_report *report)
{
    struct csg_gl *gl = &context->gl;
    GLint major = 0, minor = 0;
    gl->GetIntegerv(GL_MAJOR_VERSION, &major);
    gl->GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major < 3 || (major == 3 && minor < 3)) {
        csg_gl_report_add(report, " %s gave OpenGL %d.%d.", where, major, minor);
        return false;
    }
    const char *renderer = (const char *)gl->GetString(GL_RENDERER);
    snprintf(context->name, sizeof context->name, "%s: %.200s, %d.%d core", gl->platform->name,
             renderer ? renderer : "unknown", major, minor);
    gl->name = context->name;
    gl->is_llvmpipe = strstr(context->name, "llvmpipe") != NULL;
    context->is_software =
        gl->is_llvmpipe || strstr(context->name, "softpipe") || strstr(context->name, "swrast");
    gl->has_double =
        (major >= 4 || has_extension(gl, "GL_ARB_gpu_shader_fp64")) && !getenv("CSGCAST_NO_DOUBLE");
    gl->has_pack_invert = has_extension(gl, "GL_MESA_pack_invert");
    if (has_extension(gl, "GL_ARB_base_instance"))
        gl->DrawArraysInstancedBaseInstance =
            (PFNGLDRAWARRAYSINSTANCEDBASEINSTANCEPROC)gl->platform->get_proc(
                context, "glDrawArraysInstancedBaseInstance");
    return true;
}

bool csg_gl_context_init(struct csg_gl_context *context, const struct csg_gl_platform *platform,
                         const struct csg_log *log, const char *where, struct csg_gl_report *report)
{
    context->gl.platform = platform;
    context->gl.log = log ? *log : (struct csg_log){0};
    if (!platform->bind(context)) {
        csg_gl_report_add(report, " %s made a context but cannot make it current.", where);
        return false;
    }
    const bool ok = load_functions(context, where, report) && init_version(context, where, report);
    platform->unbind(context);
    return ok;
}

/* ---- choosing a platform ---- */

/* Who names a device wants that one and not OSMesa's software in its place. */
static bool is_device_chosen(void)
{
    const char *device = getenv("CSGCAST_EGL_DEVICE");
    return device && *device;
}

static bool is_wanted(const struct csg_gl_platform *platform, enum csgcast_backend backend)
{
    if (backend == CSGCAST_BACKEND_AUTO)
        return platform == &csg_gl_egl || !is_device_chosen();
    return platform == (backend == CSGCAST_BACKEND_EGL ? &csg_gl_egl : &csg_gl_osmesa);
}

/* What to do about it: the packages of the platforms that were tried, in Debian's words. */
static void add_remedy(struct csg_gl_report *report, enum csgcast_backend backend)
{
    if (is_device_chosen() && backend != CSGCAST_BACKEND_OSMESA) {
        csg_gl_report_add(report, " Choose another CSGCAST_EGL_DEVICE, or unset it.");
        return;
    }
    const char *before = " Install ";
    for (int i = 0; i < NUM_PLATFORMS; i++)
        if (is_wanted(platforms[i], backend)) {
            csg_gl_report_add(report, "%s%s", before, platforms[i]->remedy);
            before = ", or ";
        }
    csg_gl_report_add(report, ", or use the backend reference, which needs no OpenGL.");
}

struct csg_gl *csg_gl_create(enum csgcast_backend backend, const struct csg_log *log)
{
    if (backend != CSGCAST_BACKEND_AUTO && backend != CSGCAST_BACKEND_EGL &&
        backend != CSGCAST_BACKEND_OSMESA) {
        csg_log_error(log, CSGCAST_MESSAGE_ARGUMENT, "backend %d has no OpenGL context", backend);
        return NULL;
    }
    struct csg_gl_report report = {0};
    struct csg_gl_context *context = NULL;
    struct csg_gl_threads others;
    csg_gl_lock();
    csg_gl_threads_list(&others);
    for (int i = 0; i < NUM_PLATFORMS && !context; i++)
        if (is_wanted(platforms[i], backend))
            context = platforms[i]->create(log, &report);
    csg_gl_unlock();
    if (context) {
        context->others = others;
        return &context->gl;
    }
    add_remedy(&report, backend);
    csg_log_error(log, CSGCAST_MESSAGE_CONTEXT, "no OpenGL 3.3 core context:%s", report.text);
    return NULL;
}

void csg_gl_destroy(struct csg_gl *gl)
{
    if (!gl)
        return;
    struct csg_gl_context *context = (struct csg_gl_context *)gl;
    assert(context->depth == 0);
    csg_gl_lock();
    csg_gl_current_finish(&context->saved);
    gl->platform->destroy(context);
    csg_gl_unlock();
}

/* ---- enter and leave ---- */

static void unlock(const struct csg_gl_context *context)
{
    if (context->is_software)
        csg_gl_unlock();
}

/* Enters of the same context nest: only the outermost one makes it current. */
bool csg_gl_enter(struct csg_gl *gl)
{
    struct csg_gl_context *context = (struct csg_gl_context *)gl;
    if (context->depth++ > 0)
        return true;
    if (context->is_software)
        csg_gl_lock();
    csg_gl_current_save(&context->saved);
    if (gl->platform->bind(context))
        return true;
    csg_gl_current_restore(&context->saved);
    context->depth = 0;
    unlock(context);
    csg_log_error(&gl->log, CSGCAST_MESSAGE_CONTEXT,
                  "%s: the context cannot be made current; is it in use by another thread?",
                  gl->name);
    return false;
}

static const char *error_name(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM:
        return "invalid enum";
    case GL_INVALID_VALUE:
        return "invalid value";
    case GL_INVALID_OPERATION:
        return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "invalid framebuffer operation";
    case GL_OUT_OF_MEMORY:
        return "out of memory";
    case GL_CONTEXT_LOST:
        return "context lost";
    default:
        return "unknown";
    }
}

static bool report_errors(const struct csg_gl *gl)
{
    bool ok = true;
    GLenum error;
    for (int i = 0; i < MAX_ERRORS && (error = gl->GetError()) != GL_NO_ERROR; i++) {
        csg_log_error(&gl->log, CSGCAST_MESSAGE_CONTEXT, "%s: OpenGL error 0x%04x, %s", gl->name,
                      error, error_name(error));
        ok = false;
    }
    return ok;
}

bool csg_gl_leave(struct csg_gl *gl)
{
    struct csg_gl_context *context = (struct csg_gl_context *)gl;
    assert(context->depth > 0);
    const bool ok = report_errors(gl);
    if (--context->depth > 0)
        return ok;
    if (context->is_software && !context->settled) {
        csg_gl_threads_spread(&context->others);
        csg_heap_keep();
    }
    context->settled = true;
    gl->platform->unbind(context);
    csg_gl_current_restore(&context->saved);
    unlock(context);
    return ok;
}
