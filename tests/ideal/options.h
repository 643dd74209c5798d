/* SPDX-License-Identifier: MIT */
#ifndef TESTS_IDEAL_OPTIONS_H
#define TESTS_IDEAL_OPTIONS_H

/* The options of tests, --name=value. Each function says whether the argument was its own. */

#include <csgcast/csgcast.h>

#include <stdlib.h>
#include <string.h>

/* name: with dashes and '='. */
static inline bool option_text(const char *argument, const char *name, const char **value)
{
    const size_t length = strlen(name);
    if (strncmp(argument, name, length) != 0)
        return false;
    *value = argument + length;
    return true;
}

static inline bool option_int(const char *argument, const char *name, int *value)
{
    const char *text;
    if (!option_text(argument, name, &text))
        return false;
    *value = atoi(text);
    return true;
}

static inline bool option_seed(const char *argument, unsigned long long *seed)
{
    const char *text;
    if (!option_text(argument, "--seed=", &text))
        return false;
    *seed = strtoull(text, NULL, 0);
    return true;
}

static inline bool option_backend(const char *argument, enum csgcast_backend *backend)
{
    static const struct {
        const char *name;
        enum csgcast_backend backend;
    } backends[] = {{"egl", CSGCAST_BACKEND_EGL},
                    {"osmesa", CSGCAST_BACKEND_OSMESA},
                    {"reference", CSGCAST_BACKEND_REFERENCE}};
    const char *text;
    if (!option_text(argument, "--backend=", &text))
        return false;
    for (size_t i = 0; i < sizeof backends / sizeof *backends; i++)
        if (strcmp(text, backends[i].name) == 0) {
            *backend = backends[i].backend;
            return true;
        }
    return false;
}

#endif
