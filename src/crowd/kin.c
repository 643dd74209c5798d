/* SPDX-License-Identifier: MIT */
#include "crowd/kin.h"

#include <stdlib.h>
#include <string.h>

#include "carrier/carrier.h"
#include "csg/object.h"

uint32_t csg_kin_root(uint32_t *parents, uint32_t object)
{
    while (parents[object] != object) {
        parents[object] = parents[parents[object]];
        object = parents[object];
    }
    return object;
}

/* The smaller number becomes the root, so that roots do not depend on the order. */
static void join(uint32_t *parents, uint32_t a, uint32_t b)
{
    a = csg_kin_root(parents, a);
    b = csg_kin_root(parents, b);
    if (a < b)
        parents[b] = a;
    else
        parents[a] = b;
}

static void join_user(uint32_t *parents, uint32_t *first, uint32_t object)
{
    if (*first == UINT32_MAX)
        *first = object;
    else
        join(parents, *first, object);
}

/* planes, quadrics: by carrier, the first object that has it. */
static void join_object(const struct csgcast_scene *scene, uint32_t *parents, uint32_t index,
                        uint32_t *planes, uint32_t *quadrics)
{
    const struct csg_carriers *carriers = scene->carriers;
    const struct csg_object *object = &scene->objects->data[index];
    const struct csg_node *nodes = scene->trees[object->layer].data;
    for (uint32_t i = object->begin; i < object->end; i++) {
        if (nodes[i].op != CSG_LEAF || nodes[i].spare)
            continue;
        const uint32_t leaf = nodes[i].leaf, quadric = carriers->quadric_faces[leaf].carrier;
        for (uint32_t j = carriers->face_begin[leaf]; j < carriers->face_begin[leaf + 1]; j++)
            if (carriers->faces[j].carrier != CSG_NO_CARRIER)
                join_user(parents, &planes[carriers->faces[j].carrier], index);
        if (quadric != CSG_NO_CARRIER)
            join_user(parents, &quadrics[quadric], index);
    }
}

bool csg_kin_find(const struct csgcast_scene *scene, uint32_t *parents)
{
    const struct csg_carriers *carriers = scene->carriers;
    const size_t num = carriers->num_planes + carriers->num_quadrics;
    uint32_t *first = malloc((num + 1) * sizeof *first);
    if (!first)
        return false;
    memset(first, 0xff, num * sizeof *first);
    for (uint32_t i = 0; i < scene->objects->num; i++)
        join_object(scene, parents, i, first, first + carriers->num_planes);
    free(first);
    return true;
}
