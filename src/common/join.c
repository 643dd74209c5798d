/* SPDX-License-Identifier: MIT */
#include "common/join.h"

#include <stdlib.h>
#include <string.h>

char *csg_join(const char *a, const char *b)
{
    const size_t length = strlen(a), size = strlen(b) + 1;
    char *joined = malloc(length + size);
    if (joined) {
        memcpy(joined, a, length);
        memcpy(joined + length, b, size);
    }
    return joined;
}
