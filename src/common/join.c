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

char *csg_join_three(const char *a, const char *b, const char *c)
{
    char *joined = csg_join(a, b);
    char *all = joined ? csg_join(joined, c) : NULL;
    free(joined);
    return all;
}
