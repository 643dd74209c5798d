/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* dladdr */
#endif

#include "common/module.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef CSGCAST_MODULE_DIR
#define CSGCAST_MODULE_DIR "/usr/local/lib/csgcast"
#define CSGCAST_MODULE_FROM_BINDIR "../lib/csgcast"
#endif

/* Where modules lie, seen from the library's folder or the program's. */
static const char *const places[] = {"", "/csgcast", ("/" CSGCAST_MODULE_FROM_BINDIR)};

const char csg_module_dir[] = CSGCAST_MODULE_DIR;

/* The folder of the file that this text is in: the library, or a program it is linked into. */
static bool find_own_folder(char folder[PATH_MAX])
{
    Dl_info info;
    const int found = dladdr((const void *)csg_module_dir, &info);
    if (found && info.dli_fname && strchr(info.dli_fname, '/')) {
        snprintf(folder, PATH_MAX, "%s", info.dli_fname);
    } else {
        const ssize_t length = readlink("/proc/self/exe", folder, PATH_MAX - 1);
        if (length < 0)
            return false;
        folder[length] = '\0';
    }
    char *slash = strrchr(folder, '/');
    if (slash)
        *slash = '\0';
    return slash != NULL;
}

static bool is_in(const char *folder, const char *below, const char *name, char *path, size_t size)
{
    const int length = snprintf(path, size, "%s%s/%s", folder, below, name);
    return length > 0 && (size_t)length < size && access(path, F_OK) == 0;
}

static bool find(const char *name, char *path, size_t size)
{
    char folder[PATH_MAX];
    if (find_own_folder(folder))
        for (size_t i = 0; i < sizeof places / sizeof *places; i++)
            if (is_in(folder, places[i], name, path, size))
                return true;
    return is_in(csg_module_dir, "", name, path, size);
}

void *csg_module_symbol(const char *name, const char *variable, const char *symbol)
{
    char path[PATH_MAX + 64];
    const char *chosen = getenv(variable);
    dlerror(); /* what was said before is not about this one */
    if (!chosen || !*chosen)
        chosen = find(name, path, sizeof path) ? path : NULL;
    void *const module = chosen ? dlopen(chosen, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE) : NULL;
    return module ? dlsym(module, symbol) : NULL;
}

bool csg_module_find(const char *name, const char *variable, char *path, size_t size)
{
    const char *chosen = getenv(variable);
    if (chosen && *chosen)
        return snprintf(path, size, "%s", chosen) < (int)size && access(path, F_OK) == 0;
    return find(name, path, size);
}
