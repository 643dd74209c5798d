/* SPDX-License-Identifier: MIT */
#ifndef CSG_GL_LIBRARY_H
#define CSG_GL_LIBRARY_H

/* Shared libraries and their functions, looked up at run time. */

#include <stdbool.h>
#include <stddef.h>

/*
 * Opens the first of the NULL-terminated names that loads, NULL where none does. A driver starts
 * threads and exit handlers that do not survive dlclose, so an opened library stays mapped.
 */
void *csg_library_open(const char *const *names);

/* The same, but only where the process has loaded the library already. */
void *csg_library_find(const char *const *names);

/* Another number than before where the process has loaded libraries since: looking for them by name
 * takes file operations for each name. 0: not known. */
unsigned long long csg_library_generation(void);

/* NULL is no library. */
void csg_library_close(void *library);

/* Stores the address in *function, a function pointer; false, and NULL, where it is missing. */
#define csg_library_load(library, name, function)                                                  \
    csg_library_symbol(library, name, function, sizeof *(function))
bool csg_library_symbol(void *library, const char *name, void *function, size_t size);

#endif
