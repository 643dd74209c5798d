/* SPDX-License-Identifier: MIT */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gl/platform.h"

/* More GPUs than any machine has. */
enum { MAX_DEVICES = 64 };

struct egl_context {
    struct csg_gl_context base;
    struct csg_egl_api api;
    EGLDisplay display;
    EGLContext context;
};

/* One search for a context: what EGL offers and why it failed so far. */
struct search {
    const struct csg_egl_api *egl;
    const struct csg_log *log;
    struct csg_gl_report *report;
    const char *extensions; /* of the client */
    EGLDeviceEXT devices[MAX_DEVICES];
    EGLint num_devices;
};

/* Whether list, words between spaces, has the word. */
static bool has_word(const char *list, const char *word)
{
    const size_t length = strlen(word);
    for (const char *at = list; at && (at = strstr(at, word)); at += length)
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}

/* ---- one context ---- */

static void destroy(struct csg_gl_context *base)
{
    struct egl_context *context = (struct egl_context *)base;
    if (context->context != EGL_NO_CONTEXT)
        context->api.DestroyContext(context->display, context->context);
    if (base->gl.ends_display)
        context->api.Terminate(context->display);
    csg_egl_api_close(&context->api);
    free(context);
}

/*
 * EGL has one display per device in a process, and eglTerminate would end the contexts that others
 * have on it, the embedding program's included. So a display stays initialised until the process
 * ends; a second eglInitialize of the same one does nothing. gl.ends_display says otherwise.
 */
static bool init_display(const struct search *search, EGLDisplay display, const char *where)
{
    const struct csg_egl_api *egl = search->egl;
    if (display == EGL_NO_DISPLAY || !egl->Initialize(display, NULL, NULL)) {
        csg_gl_report_add(search->report, " %s does not work (EGL error 0x%04x).", where,
                          (unsigned)egl->GetError());
        return false;
    }
    const char *extensions = egl->QueryString(display, EGL_EXTENSIONS);
    if (has_word(extensions, "EGL_KHR_surfaceless_context") &&
        (has_word(extensions, "EGL_KHR_no_config_context") ||
         has_word(extensions, "EGL_MESA_configless_context")))
        return true;
    csg_gl_report_add(search->report, " %s has no contexts without a surface.", where);
    return false;
}

static EGLContext create_version(const struct csg_egl_api *egl, EGLDisplay display, int major,
                                 int minor)
{
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 major,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 minor,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    return egl->CreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
}

static bool init_context(struct egl_context *context, const struct search *search,
                         EGLDisplay display, const char *where)
{
    context->display = display;
    context->context = create_version(&context->api, display, 4, 0);
    if (context->context == EGL_NO_CONTEXT)
        context->context = create_version(&context->api, display, 3, 3);
    if (context->context == EGL_NO_CONTEXT) {
        csg_gl_report_add(search->report, " %s has no OpenGL 3.3 core profile (EGL error 0x%04x).",
                          where, (unsigned)context->api.GetError());
        return false;
    }
    return csg_gl_context_init(&context->base, &csg_gl_egl, search->log, where, search->report);
}

static struct csg_gl_context *create_on_display(const struct search *search, EGLDisplay display,
                                                const char *where)
{
    if (!init_display(search, display, where))
        return NULL;
    struct egl_context *context = calloc(1, sizeof *context);
    if (!context) {
        csg_log_memory(search->log);
        return NULL;
    }
    if (csg_egl_api_open(&context->api) && init_context(context, search, display, where))
        return &context->base;
    destroy(&context->base);
    return NULL;
}

/* ---- the displays ---- */

static struct csg_gl_context *create_on_device(const struct search *search, EGLint index)
{
    char where[32];
    snprintf(where, sizeof where, "EGL device %d", (int)index);
    const EGLDisplay display =
        search->egl->GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, search->devices[index], NULL);
    return create_on_display(search, display, where);
}

static struct csg_gl_context *create_surfaceless(const struct search *search)
{
    if (!has_word(search->extensions, "EGL_MESA_platform_surfaceless")) {
        csg_gl_report_add(search->report, " EGL has no surfaceless platform.");
        return NULL;
    }
    const EGLDisplay display =
        search->egl->GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    return create_on_display(search, display, "EGL surfaceless");
}

static bool is_software_device(const struct search *search, EGLint index)
{
    const char *extensions = search->egl->QueryDeviceString(search->devices[index], EGL_EXTENSIONS);
    return has_word(extensions, "EGL_MESA_device_software");
}

static struct csg_gl_context *create_on_gpu(const struct search *search)
{
    for (EGLint i = 0; i < search->num_devices; i++) {
        if (is_software_device(search, i))
            continue;
        struct csg_gl_context *context = create_on_device(search, i);
        /* A display controller without a GPU is a device of hardware whose driver is software. */
        if (context && !context->is_software)
            return context;
        if (context)
            destroy(context);
    }
    return NULL;
}

static struct csg_gl_context *create_on_any_device(const struct search *search)
{
    struct csg_gl_context *context = NULL;
    for (EGLint i = 0; i < search->num_devices && !context; i++)
        context = create_on_device(search, i);
    return context;
}

/* number: the text of CSGCAST_EGL_DEVICE. */
static struct csg_gl_context *create_on_chosen(const struct search *search, const char *number)
{
    char *end;
    errno = 0;
    const long index = strtol(number, &end, 10);
    if (*end || errno || index < 0 || index >= search->num_devices) {
        csg_gl_report_add(search->report,
                          " CSGCAST_EGL_DEVICE is \"%.40s\", but EGL has %d devices, counted "
                          "from 0.",
                          number, (int)search->num_devices);
        return NULL;
    }
    return create_on_device(search, (EGLint)index);
}

/*
 * A GPU where there is one. Mesa's surfaceless platform finds those of its own drivers, but not
 * those of other vendors, which are EGL devices.
 */
static struct csg_gl_context *create_on_best(const struct search *search)
{
    struct csg_gl_context *context = create_on_gpu(search);
    if (!context)
        context = create_surfaceless(search);
    if (!context)
        context = create_on_any_device(search);
    return context;
}

/* ---- the platform ---- */

static void find_devices(struct search *search)
{
    const bool has_devices = has_word(search->extensions, "EGL_EXT_platform_device") &&
                             (has_word(search->extensions, "EGL_EXT_device_enumeration") ||
                              has_word(search->extensions, "EGL_EXT_device_base"));
    if (!has_devices || !search->egl->QueryDevices || !search->egl->QueryDeviceString ||
        !search->egl->QueryDevices(MAX_DEVICES, search->devices, &search->num_devices))
        search->num_devices = 0;
}

static struct csg_gl_context *create_with(const struct csg_egl_api *egl, const struct csg_log *log,
                                          struct csg_gl_report *report)
{
    struct search search = {.egl = egl, .log = log, .report = report};
    search.extensions = egl->QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has_word(search.extensions, "EGL_EXT_platform_base") || !egl->GetPlatformDisplay) {
        csg_gl_report_add(report, " libEGL has no platforms without a display.");
        return NULL;
    }
    if (!egl->BindAPI(EGL_OPENGL_API)) {
        csg_gl_report_add(report, " libEGL has no desktop OpenGL.");
        return NULL;
    }
    find_devices(&search);
    const char *number = getenv("CSGCAST_EGL_DEVICE");
    return number && *number ? create_on_chosen(&search, number) : create_on_best(&search);
}

static struct csg_gl_context *create(const struct csg_log *log, struct csg_gl_report *report)
{
    struct csg_egl_api egl;
    if (!csg_egl_api_open(&egl)) {
        csg_gl_report_add(report, " libEGL.so.1 is missing or too old.");
        return NULL;
    }
    struct csg_gl_current current = {0};
    csg_gl_current_save(&current);
    struct csg_gl_context *context = create_with(&egl, log, report);
    csg_gl_current_restore(&current);
    csg_gl_current_finish(&current);
    csg_egl_api_close(&egl);
    return context;
}

static csg_gl_proc get_proc(const struct csg_gl_context *base, const char *name)
{
    return ((const struct egl_context *)base)->api.GetProcAddress(name);
}

static bool bind(struct csg_gl_context *base)
{
    const struct egl_context *context = (const struct egl_context *)base;
    return context->api.BindAPI(EGL_OPENGL_API) &&
           context->api.MakeCurrent(context->display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                                    context->context);
}

static void unbind(struct csg_gl_context *base)
{
    const struct egl_context *context = (const struct egl_context *)base;
    context->api.MakeCurrent(context->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

const struct csg_gl_platform csg_gl_egl = {
    .name = "egl",
    .remedy = "libegl1 and libgl1-mesa-dri",
    .create = create,
    .destroy = destroy,
    .get_proc = get_proc,
    .bind = bind,
    .unbind = unbind,
};
