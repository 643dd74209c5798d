/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_MODULE_H
#define CSG_COMMON_MODULE_H

/*
 * Parts of csgcast that bring libraries of their own and are loaded when they are needed. They
 * lie beside the library or the tool, where an installation under any prefix has them, or where
 * they were installed first.
 */

#include <stdbool.h>
#include <stddef.h>

/*
 * What the module of that file name, or the one that the environment variable names, has under a
 * symbol. It stays loaded: some libraries' threads do not survive the end of that. NULL: dlerror()
 * has the reason, or nothing where there is no such file.
 */
void *csg_module_symbol(const char *name, const char *variable, const char *symbol);

/* The path of that file, for what is not loaded by us; the same places. false: it is not there. */
bool csg_module_find(const char *name, const char *variable, char *path, size_t size);

/* Where modules are installed. */
extern const char csg_module_dir[];

#endif
