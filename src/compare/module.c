/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* RTLD_NODELETE */
#endif
#include "compare/module.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define MODULE_NAME "csgcast-compare.so"

/* Embree's threads do not survive dlclose. */
#define MODULE_FLAGS (RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)

static bool find_own_folder(char folder[PATH_MAX])
{
    const ssize_t length = readlink("/proc/self/exe", folder, PATH_MAX - 1);
    if (length < 0)
        return false;
    folder[length] = '\0';
    char *slash = strrchr(folder, '/');
    if (slash)
        *slash = '\0';
    return slash != NULL;
}

/* The reason is left for dlerror where the file is there but does not load. */
static void *open_in(const char *folder, const char *below)
{
    char path[PATH_MAX + 128];
    snprintf(path, sizeof path, "%s%s/" MODULE_NAME, folder, below);
    return access(path, F_OK) == 0 ? dlopen(path, MODULE_FLAGS) : NULL;
}

static void *open_module(void)
{
    char folder[PATH_MAX];
    const char *chosen = getenv("CSGCAST_COMPARE_MODULE");
    dlerror();
    if (chosen && *chosen)
        return dlopen(chosen, MODULE_FLAGS);
    if (!find_own_folder(folder))
        return NULL;
    void *module = open_in(folder, "");
    return module ? module : open_in(folder, "/" CSGCAST_MODULE_FROM_TOOL);
}

bool csg_compare_module_load(struct csg_compare_module *module, const struct csg_log *log)
{
    void *const library = open_module();
    void *const address = library ? dlsym(library, CSG_COMPARE_MODULE_ENTRY_NAME) : NULL;
    csg_compare_module_fn *entry;
    memcpy(&entry, &address, sizeof entry);
    if (address) {
        entry(module);
        return true;
    }
    const char *reason = dlerror();
    csg_log_error(log, CSGCAST_MESSAGE_FILE,
                  "meshes need " MODULE_NAME " with Embree and assimp (%s): on Debian apt-get "
                  "install libembree3-3 libassimp5, to build it libembree-dev libassimp-dev, or "
                  "set CSGCAST_COMPARE_MODULE",
                  reason ? reason : "it is not beside csgcast, nor where it is installed");
    return false;
}
