/* SPDX-License-Identifier: MIT */
#include "gl/glx_api.h"

#include "gl/library.h"

static const char *const names[] = {"libGLX.so.0", "libGL.so.1", NULL};

static bool load(struct csg_glx_api *api)
{
    void *const lib = api->library;
    bool ok = true;
    ok &= csg_library_load(lib, "glXGetCurrentContext", &api->GetCurrentContext);
    ok &= csg_library_load(lib, "glXGetCurrentDisplay", &api->GetCurrentDisplay);
    ok &= csg_library_load(lib, "glXGetCurrentDrawable", &api->GetCurrentDrawable);
    ok &= csg_library_load(lib, "glXGetCurrentReadDrawable", &api->GetCurrentReadDrawable);
    ok &= csg_library_load(lib, "glXMakeContextCurrent", &api->MakeContextCurrent);
    return ok;
}

bool csg_glx_api_find(struct csg_glx_api *api)
{
    *api = (struct csg_glx_api){.library = csg_library_find(names)};
    if (api->library && !load(api))
        csg_glx_api_close(api);
    return api->library != NULL;
}

void csg_glx_api_close(struct csg_glx_api *api)
{
    csg_library_close(api->library);
    api->library = NULL;
}
