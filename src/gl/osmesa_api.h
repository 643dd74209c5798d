/* SPDX-License-Identifier: MIT */
#ifndef CSG_GL_OSMESA_API_H
#define CSG_GL_OSMESA_API_H

/*
 * The functions of libOSMesa, which is loaded at run time. Declared here and not taken from
 * GL/osmesa.h: that header left Mesa together with the library in 2025, and it includes GL/gl.h,
 * which does not go together with GL/glcorearb.h.
 */

#include <stdbool.h>

#include <GL/glcorearb.h>

typedef struct csg_osmesa_context_opaque *csg_osmesa_context; /* OSMesaContext */

enum {
    CSG_OSMESA_RGBA = GL_RGBA,
    CSG_OSMESA_FORMAT = 0x22, /* for contexts and GetIntegerv */
    CSG_OSMESA_TYPE = 0x23,   /* for GetIntegerv */
    CSG_OSMESA_DEPTH_BITS = 0x30,
    CSG_OSMESA_PROFILE = 0x33,
    CSG_OSMESA_CORE_PROFILE = 0x34,
    CSG_OSMESA_CONTEXT_MAJOR_VERSION = 0x36,
    CSG_OSMESA_CONTEXT_MINOR_VERSION = 0x37,
};

struct csg_osmesa_api {
    void *library;
    csg_osmesa_context (*CreateContextAttribs)(const int *attributes, csg_osmesa_context share);
    void (*DestroyContext)(csg_osmesa_context context);
    GLboolean (*MakeCurrent)(csg_osmesa_context context, void *buffer, GLenum type, GLsizei width,
                             GLsizei height);
    csg_osmesa_context (*GetCurrentContext)(void);
    GLboolean (*GetColorBuffer)(csg_osmesa_context context, GLint *width, GLint *height,
                                GLint *format, void **buffer);
    void (*GetIntegerv)(GLint name, GLint *value);
    void (*(*GetProcAddress)(const char *name))(void);
};

/* Loads libOSMesa; false, with api->library NULL, where it is missing or has no core profile. */
bool csg_osmesa_api_open(struct csg_osmesa_api *api);

/* The same, but only where the process has loaded it already. */
bool csg_osmesa_api_find(struct csg_osmesa_api *api);

void csg_osmesa_api_close(struct csg_osmesa_api *api);

#endif
