/* SPDX-License-Identifier: MIT */
#include "nodes/origin.h"

#include <stdlib.h>

bool csg_origins_add(struct csg_origins *origins, const struct csg_shape *shape,
                     const struct csg_space *space)
{
    const uint32_t leaf = (uint32_t)origins->num;
    struct csg_origin origin = {.space = *space, .first = leaf, .num = 1};
    if (!csg_shape_copy(&origin.shape, shape))
        return false;
    if (csg_array_push(origins, origin))
        return true;
    csg_shape_finish(&origin.shape);
    return false;
}

void csg_origins_finish(struct csg_origins *origins)
{
    for (size_t i = 0; i < origins->num; i++)
        csg_shape_finish(&origins->data[i].shape);
    free(origins->data);
    free(origins->places.data);
    *origins = (struct csg_origins){0};
}
