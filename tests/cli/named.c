/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* O_TMPFILE, RTLD_NEXT */
#endif

/* To be preloaded: a file system that has no files without names. */

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <string.h>

typedef int open_fn(const char *path, int flags, ...);

int open(const char *path, int flags, ...)
{
    open_fn *real = NULL;
    void *const address = dlsym(RTLD_NEXT, "open");
    memcpy(&real, &address, sizeof real);
    va_list rest;
    va_start(rest, flags);
    const int mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, int) : 0;
    va_end(rest);
    if ((flags & O_TMPFILE) == O_TMPFILE) {
        errno = EOPNOTSUPP;
        return -1;
    }
    return real(path, flags, mode);
}
