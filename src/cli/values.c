/* SPDX-License-Identifier: MIT */
#include "values.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MAX_FRAMES 100000 /* csgcast_animation_load's limit */

bool csg_value_int(const char *text, int *value)
{
    char *end;
    errno = 0;
    const long number = strtol(text, &end, 10);
    if (end == text || *end || errno || number < INT_MIN || number > INT_MAX)
        return false;
    *value = (int)number;
    return true;
}

const char *csg_value_frames(const char *text, int *num)
{
    return csg_value_int(text, num) && *num > 0 && *num <= MAX_FRAMES ? NULL
                                                                      : "a number from 1 to 100000";
}

bool csg_value_double(const char *text, double *value)
{
    return csg_value_list(text, value, 1) == 1;
}

size_t csg_value_list(const char *text, double *values, size_t max)
{
    for (size_t num = 0; num < max;) {
        char *end;
        values[num] = strtod(text, &end);
        if (end == text || !isfinite(values[num]))
            return 0;
        num++;
        if (!*end)
            return num;
        if (*end != ',')
            return 0;
        text = end + 1;
    }
    return 0;
}

bool csg_value_enum(const char *text, const struct csg_value_name *names, int *value)
{
    for (; names->name; names++) {
        if (!strcmp(text, names->name)) {
            *value = names->value;
            return true;
        }
    }
    return false;
}
