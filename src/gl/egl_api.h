/* SPDX-License-Identifier: MIT */
#ifndef CSG_GL_EGL_API_H
#define CSG_GL_EGL_API_H

/* The functions of libEGL, which is loaded at run time. */

#include <stdbool.h>

#ifndef EGL_NO_X11
#define EGL_NO_X11 /* else egl.h wants Xlib's headers */
#endif
#include <EGL/egl.h>
#include <EGL/eglext.h>

struct csg_egl_api {
    void *library;
    PFNEGLBINDAPIPROC BindAPI;
    PFNEGLCREATECONTEXTPROC CreateContext;
    PFNEGLDESTROYCONTEXTPROC DestroyContext;
    PFNEGLGETCURRENTCONTEXTPROC GetCurrentContext;
    PFNEGLGETCURRENTDISPLAYPROC GetCurrentDisplay;
    PFNEGLGETCURRENTSURFACEPROC GetCurrentSurface;
    PFNEGLGETDISPLAYPROC GetDisplay;
    PFNEGLGETERRORPROC GetError;
    PFNEGLGETPROCADDRESSPROC GetProcAddress;
    PFNEGLINITIALIZEPROC Initialize;
    PFNEGLMAKECURRENTPROC MakeCurrent;
    PFNEGLQUERYAPIPROC QueryAPI;
    PFNEGLQUERYSTRINGPROC QueryString;
    PFNEGLTERMINATEPROC Terminate;

    /* Extensions of the client; NULL where missing. */
    PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay;
    PFNEGLQUERYDEVICESEXTPROC QueryDevices;
    PFNEGLQUERYDEVICESTRINGEXTPROC QueryDeviceString;
};

/* Loads libEGL; false, with api->library NULL, where it is not installed or older than 1.4. */
bool csg_egl_api_open(struct csg_egl_api *api);

/* The same, but only where the process has loaded it already. */
bool csg_egl_api_find(struct csg_egl_api *api);

void csg_egl_api_close(struct csg_egl_api *api);

#endif
