/* SPDX-License-Identifier: MIT */
#ifndef CSG_GL_GLX_API_H
#define CSG_GL_GLX_API_H

/*
 * The few functions of GLX that put a program's own context aside and back. csgcast makes no GLX
 * contexts: it needs no display. The types are declared here so that Xlib's headers are not needed.
 */

#include <stdbool.h>

typedef struct csg_glx_display_opaque *csg_glx_display; /* Display * */
typedef struct csg_glx_context_opaque *csg_glx_context; /* GLXContext */
typedef unsigned long csg_glx_drawable;                 /* GLXDrawable, an XID */

struct csg_glx_api {
    void *library;
    csg_glx_context (*GetCurrentContext)(void);
    csg_glx_display (*GetCurrentDisplay)(void);
    csg_glx_drawable (*GetCurrentDrawable)(void);
    csg_glx_drawable (*GetCurrentReadDrawable)(void);
    int (*MakeContextCurrent)(csg_glx_display display, csg_glx_drawable draw, csg_glx_drawable read,
                              csg_glx_context context);
};

/* false, with api->library NULL, where the process has not loaded GLX. */
bool csg_glx_api_find(struct csg_glx_api *api);
void csg_glx_api_close(struct csg_glx_api *api);

#endif
