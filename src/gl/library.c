/* SPDX-License-Identifier: MIT */
#include "gl/library.h"

#include <assert.h>
#include <dlfcn.h>
#include <string.h>

static void *open_first(const char *const *names, int mode)
{
    void *library = NULL;
    for (size_t i = 0; names[i] && !library; i++)
        library = dlopen(names[i], mode);
    return library;
}

void *csg_library_open(const char *const *names)
{
    return open_first(names, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
}

void *csg_library_find(const char *const *names)
{
    return open_first(names, RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD);
}

void csg_library_close(void *library)
{
    if (library)
        dlclose(library);
}

bool csg_library_symbol(void *library, const char *name, void *function, size_t size)
{
    void *const address = dlsym(library, name);
    assert(size == sizeof address);
    memcpy(function, &address, size); /* ISO C has no cast from void * to a function */
    return address != NULL;
}
