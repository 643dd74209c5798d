/* SPDX-License-Identifier: MIT */
#include "gl/osmesa_api.h"

#include "gl/library.h"

static const char *const names[] = {"libOSMesa.so.8", "libOSMesa.so", "libOSMesa.so.6", NULL};

static bool load_functions(struct csg_osmesa_api *api)
{
    void *const lib = api->library;
    bool ok = true;
    ok &= csg_library_load(lib, "OSMesaCreateContextAttribs", &api->CreateContextAttribs);
    ok &= csg_library_load(lib, "OSMesaDestroyContext", &api->DestroyContext);
    ok &= csg_library_load(lib, "OSMesaMakeCurrent", &api->MakeCurrent);
    ok &= csg_library_load(lib, "OSMesaGetCurrentContext", &api->GetCurrentContext);
    ok &= csg_library_load(lib, "OSMesaGetColorBuffer", &api->GetColorBuffer);
    ok &= csg_library_load(lib, "OSMesaGetIntegerv", &api->GetIntegerv);
    ok &= csg_library_load(lib, "OSMesaGetProcAddress", &api->GetProcAddress);
    return ok;
}

static bool load(struct csg_osmesa_api *api, void *library)
{
    *api = (struct csg_osmesa_api){.library = library};
    if (library && !load_functions(api))
        csg_osmesa_api_close(api);
    return api->library != NULL;
}

bool csg_osmesa_api_open(struct csg_osmesa_api *api)
{
    return load(api, csg_library_open(names));
}

bool csg_osmesa_api_find(struct csg_osmesa_api *api)
{
    return load(api, csg_library_find(names));
}

void csg_osmesa_api_close(struct csg_osmesa_api *api)
{
    csg_library_close(api->library);
    api->library = NULL;
}
