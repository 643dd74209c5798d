/* SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "gl/platform.h"

/* OSMesa wants memory to draw into before a context is current; csgcast draws into its own FBOs. */
enum { BUFFER_SIZE = 4 };

struct osmesa_context {
    struct csg_gl_context base;
    struct csg_osmesa_api api;
    csg_osmesa_context context;
    unsigned char buffer[BUFFER_SIZE * BUFFER_SIZE * 4];
};

static csg_osmesa_context create_version(const struct csg_osmesa_api *api, int major, int minor)
{
    const int attributes[] = {CSG_OSMESA_FORMAT,
                              CSG_OSMESA_RGBA,
                              CSG_OSMESA_DEPTH_BITS,
                              0,
                              CSG_OSMESA_PROFILE,
                              CSG_OSMESA_CORE_PROFILE,
                              CSG_OSMESA_CONTEXT_MAJOR_VERSION,
                              major,
                              CSG_OSMESA_CONTEXT_MINOR_VERSION,
                              minor,
                              0};
    return api->CreateContextAttribs(attributes, NULL);
}

static void destroy(struct csg_gl_context *base)
{
    struct osmesa_context *osmesa = (struct osmesa_context *)base;
    if (osmesa->context)
        osmesa->api.DestroyContext(osmesa->context);
    csg_osmesa_api_close(&osmesa->api);
    free(osmesa);
}

/* The newest core profile that OSMesa gives, with nothing current. */
static bool init(struct osmesa_context *osmesa, const struct csg_log *log,
                 struct csg_gl_report *report)
{
    osmesa->context = create_version(&osmesa->api, 4, 0);
    if (!osmesa->context)
        osmesa->context = create_version(&osmesa->api, 3, 3);
    if (!osmesa->context) {
        csg_gl_report_add(report, " OSMesa has no OpenGL 3.3 core profile.");
        return false;
    }
    return csg_gl_context_init(&osmesa->base, &csg_gl_osmesa, log, "OSMesa", report);
}

static struct csg_gl_context *create(const struct csg_log *log, struct csg_gl_report *report)
{
    struct osmesa_context *osmesa = calloc(1, sizeof *osmesa);
    if (!osmesa) {
        csg_log_memory(log);
        return NULL;
    }
    if (!csg_osmesa_api_open(&osmesa->api)) {
        csg_gl_report_add(report, " libOSMesa.so.8 is missing or too old.");
        destroy(&osmesa->base);
        return NULL;
    }
    struct csg_gl_current current = {0};
    csg_gl_current_save(&current);
    const bool ok = init(osmesa, log, report);
    if (!ok)
        destroy(&osmesa->base);
    csg_gl_current_restore(&current);
    csg_gl_current_finish(&current);
    return ok ? &osmesa->base : NULL;
}

static csg_gl_proc get_proc(const struct csg_gl_context *base, const char *name)
{
    return ((const struct osmesa_context *)base)->api.GetProcAddress(name);
}

static bool bind(struct csg_gl_context *base)
{
    struct osmesa_context *osmesa = (struct osmesa_context *)base;
    return osmesa->api.MakeCurrent(osmesa->context, osmesa->buffer, GL_UNSIGNED_BYTE, BUFFER_SIZE,
                                   BUFFER_SIZE);
}

static void unbind(struct csg_gl_context *base)
{
    ((struct osmesa_context *)base)->api.MakeCurrent(NULL, NULL, 0, 0, 0);
}

const struct csg_gl_platform csg_gl_osmesa = {
    .name = "osmesa",
    .remedy = "libosmesa6",
    .create = create,
    .destroy = destroy,
    .get_proc = get_proc,
    .bind = bind,
    .unbind = unbind,
};
