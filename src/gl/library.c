/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* dl_iterate_phdr */
#endif
#include "gl/library.h"

#include <assert.h>
#include <dlfcn.h>
#include <link.h>
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

/* Of the first library, which tells of all. */
static int take_generation(struct dl_phdr_info *info, size_t size, void *generation)
{
    if (size >= offsetof(struct dl_phdr_info, dlpi_adds) + sizeof info->dlpi_adds)
        *(unsigned long long *)generation = info->dlpi_adds;
    return 1;
}

unsigned long long csg_library_generation(void)
{
    unsigned long long generation = 0;
    dl_iterate_phdr(take_generation, &generation);
    return generation;
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
