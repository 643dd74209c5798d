/* SPDX-License-Identifier: MIT */
#ifndef _DEFAULT_SOURCE
#define _DEFAULT_SOURCE /* realpath, symlink */
#endif

#include "document/digits.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/join.h"
#include "common/module.h"

extern char **environ;

const char csg_digits_module[] = "csgcast-digits.so";

static const char preload[] = "LD_PRELOAD=", folder_variable[] = "CSGCAST_DIGITS=";

bool csg_digits_are_all(const char *text, size_t size)
{
    const size_t length = sizeof CSG_DIGITS_MARK - 1;
    return size >= length && memcmp(text + size - length, CSG_DIGITS_MARK, length) == 0;
}

static bool begins_with(const char *text, const char *begin)
{
    return strncmp(text, begin, strlen(begin)) == 0;
}

/* "LD_PRELOAD=theirs:module"; NULL: out of memory. */
static char *preload_setting(const char *module)
{
    const char *before = getenv("LD_PRELOAD");
    const bool is_set = before && before[0];
    char *begin = csg_join_three(preload, is_set ? before : "", is_set ? ":" : "");
    char *setting = begin ? csg_join(begin, module) : NULL;
    free(begin);
    return setting;
}

/* The variables that are not set anew, then room for two more and the end. */
static char **copy_environment(size_t *num)
{
    size_t size = 0;
    while (environ[size])
        size++;
    char **copy = calloc(size + 3, sizeof *copy);
    *num = 0;
    for (size_t i = 0; i < size && copy; i++) {
        if (begins_with(environ[i], preload) || begins_with(environ[i], folder_variable))
            continue;
        copy[*num] = csg_join(environ[i], "");
        if (!copy[(*num)++]) {
            csg_digits_environment_free(copy);
            copy = NULL;
        }
    }
    return copy;
}

/* A name for the module that has no blank and no colon, which LD_PRELOAD takes for its end: if need
 * be of a link to it in the folder. For the caller to free; NULL: there is none. */
static char *preloadable(const char *module, const char *folder)
{
    char real[PATH_MAX];
    if (!strpbrk(module, " :"))
        return csg_join(module, "");
    if (strpbrk(folder, " :") || !realpath(module, real))
        return NULL;
    char *link = csg_join_three(folder, "/", csg_digits_module);
    if (link && symlink(real, link) == 0)
        return link;
    free(link);
    return NULL;
}

char **csg_digits_environment(const char *folder)
{
    char module[PATH_MAX + 64];
    size_t num;
    if (!csg_module_find(csg_digits_module, "CSGCAST_DIGITS_MODULE", module, sizeof module))
        return NULL;
    char *name = preloadable(module, folder);
    char **environment = name ? copy_environment(&num) : NULL;
    if (!environment) {
        free(name);
        return NULL;
    }
    environment[num] = preload_setting(name);
    free(name);
    environment[num + 1] = csg_join(folder_variable, folder);
    if (environment[num] && environment[num + 1])
        return environment;
    free(environment[num + 1]); /* behind a NULL it would not be found */
    environment[num + 1] = NULL;
    csg_digits_environment_free(environment);
    return NULL;
}

void csg_digits_environment_free(char **environment)
{
    for (size_t i = 0; environment && environment[i]; i++)
        free(environment[i]);
    free(environment);
}
