/* SPDX-License-Identifier: MIT */
#include "common/array.h"

#include <stdint.h>
#include <stdlib.h>

bool csg_array_grow(void **data, size_t *capacity, size_t num, size_t extra, size_t element_size)
{
    if (extra > SIZE_MAX / 2 / element_size - num)
        return false;
    size_t wanted = *capacity + *capacity / 2 + 8;
    if (wanted < num + extra)
        wanted = num + extra;
    void *grown = realloc(*data, wanted * element_size);
    if (!grown)
        return false;
    *data = grown;
    *capacity = wanted;
    return true;
}

void csg_array_shrink(void **data, size_t *capacity, size_t num, size_t element_size)
{
    void *shrunk = num > 0 && num < *capacity ? realloc(*data, num * element_size) : NULL;
    if (!shrunk)
        return;
    *data = shrunk;
    *capacity = num;
}
