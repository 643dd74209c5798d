/* SPDX-License-Identifier: MIT */
#ifndef CSG_GL_PLATFORM_H
#define CSG_GL_PLATFORM_H

/* What makes contexts for context.c: one struct csg_gl_platform each for EGL and OSMesa. */

#include "gl/context.h"
#include "gl/current.h"
#include "gl/threads.h"

/* Why attempts to make a context failed, for one message after the last of them. */
struct csg_gl_report {
    char text[2048];
    size_t length;
};

/* Appends one sentence; what does not fit is cut off. */
void csg_gl_report_add(struct csg_gl_report *report, const char *format, ...) CSG_PRINTF(2, 3);

/* What stands behind every struct csg_gl, which is its first member. */
struct csg_gl_context {
    struct csg_gl gl;
    char name[256];
    bool is_software;             /* contexts of llvmpipe take turns */
    int depth;                    /* enters without a leave */
    struct csg_gl_current saved;  /* what was current before the first of them */
    struct csg_gl_threads others; /* rasterizers that were there before the context */
    bool settled;                 /* after the first leave, see csg_gl_leave */
};

typedef void (*csg_gl_proc)(void);

struct csg_gl_platform {
    const char *name;   /* as in --backend */
    const char *remedy; /* what to install where it is missing */

    /* NULL, and sentences in report, where there is no context. */
    struct csg_gl_context *(*create)(const struct csg_log *log, struct csg_gl_report *report);
    void (*destroy)(struct csg_gl_context *context);

    csg_gl_proc (*get_proc)(const struct csg_gl_context *context, const char *name);

    /* Make current on this thread, where nothing is, and nothing again. */
    bool (*bind)(struct csg_gl_context *context);
    void (*unbind)(struct csg_gl_context *context);
};

extern const struct csg_gl_platform csg_gl_egl;
extern const struct csg_gl_platform csg_gl_osmesa;

/*
 * The end of each create, with nothing current: loads the functions, checks the version and makes
 * up the name. where: the words for report, "EGL device 0". false, and a sentence, on failure.
 */
bool csg_gl_context_init(struct csg_gl_context *context, const struct csg_gl_platform *platform,
                         const struct csg_log *log, const char *where,
                         struct csg_gl_report *report);

#endif
