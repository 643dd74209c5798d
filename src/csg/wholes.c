/* SPDX-License-Identifier: MIT */
#include "csg/wholes.h"

#include <stdlib.h>

static int compare_wholes(const void *key, const void *item)
{
    const uint32_t leaf = *(const uint32_t *)key;
    const struct csg_whole *whole = item;
    return leaf < whole->begin ? -1 : leaf >= whole->end ? 1 : 0;
}

const struct csg_whole *csg_find_whole(const struct csgcast_scene *scene, uint32_t leaf)
{
    if (scene->wholes.num == 0)
        return NULL;
    return bsearch(&leaf, scene->wholes.data, scene->wholes.num, sizeof *scene->wholes.data,
                   compare_wholes);
}

bool csg_is_same_node(const struct csgcast_scene *scene, uint32_t a, uint32_t b)
{
    const struct csg_leaf *x = &scene->leaves[a], *y = &scene->leaves[b];
    const struct csg_whole *whole = csg_find_whole(scene, a);
    return (x->line == y->line && x->column == y->column) ||
           (whole && b >= whole->begin && b < whole->end);
}

static int compare_begins(const void *a, const void *b)
{
    const struct csg_whole *one = a, *other = b;
    return (one->begin > other->begin) - (one->begin < other->begin);
}

void csg_sort_wholes(struct csgcast_scene *scene)
{
    if (scene->wholes.num > 1)
        qsort(scene->wholes.data, scene->wholes.num, sizeof *scene->wholes.data, compare_begins);
}
