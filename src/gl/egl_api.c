/* SPDX-License-Identifier: MIT */
#include "gl/egl_api.h"

#include "gl/library.h"

static const char *const names[] = {"libEGL.so.1", "libEGL.so", NULL};

static bool load_core(struct csg_egl_api *api)
{
    void *const lib = api->library;
    bool ok = true;
    ok &= csg_library_load(lib, "eglBindAPI", &api->BindAPI);
    ok &= csg_library_load(lib, "eglCreateContext", &api->CreateContext);
    ok &= csg_library_load(lib, "eglDestroyContext", &api->DestroyContext);
    ok &= csg_library_load(lib, "eglGetCurrentContext", &api->GetCurrentContext);
    ok &= csg_library_load(lib, "eglGetCurrentDisplay", &api->GetCurrentDisplay);
    ok &= csg_library_load(lib, "eglGetCurrentSurface", &api->GetCurrentSurface);
    ok &= csg_library_load(lib, "eglGetDisplay", &api->GetDisplay);
    ok &= csg_library_load(lib, "eglGetError", &api->GetError);
    ok &= csg_library_load(lib, "eglGetProcAddress", &api->GetProcAddress);
    ok &= csg_library_load(lib, "eglInitialize", &api->Initialize);
    ok &= csg_library_load(lib, "eglMakeCurrent", &api->MakeCurrent);
    ok &= csg_library_load(lib, "eglQueryAPI", &api->QueryAPI);
    ok &= csg_library_load(lib, "eglQueryString", &api->QueryString);
    ok &= csg_library_load(lib, "eglTerminate", &api->Terminate);
    return ok;
}

static void load_extensions(struct csg_egl_api *api)
{
    api->GetPlatformDisplay =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)api->GetProcAddress("eglGetPlatformDisplayEXT");
    api->QueryDevices = (PFNEGLQUERYDEVICESEXTPROC)api->GetProcAddress("eglQueryDevicesEXT");
    api->QueryDeviceString =
        (PFNEGLQUERYDEVICESTRINGEXTPROC)api->GetProcAddress("eglQueryDeviceStringEXT");
}

static bool load(struct csg_egl_api *api, void *library)
{
    *api = (struct csg_egl_api){.library = library};
    if (library && !load_core(api))
        csg_egl_api_close(api);
    return api->library != NULL;
}

bool csg_egl_api_open(struct csg_egl_api *api)
{
    if (!load(api, csg_library_open(names)))
        return false;
    load_extensions(api);
    return true;
}

bool csg_egl_api_find(struct csg_egl_api *api)
{
    return load(api, csg_library_find(names));
}

void csg_egl_api_close(struct csg_egl_api *api)
{
    csg_library_close(api->library);
    api->library = NULL;
}
