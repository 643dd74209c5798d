/* SPDX-License-Identifier: MIT */

/* In which order leaves' faces get their carriers: the largest first, as they are the least turned
 * by rounding, so that they become the carriers. */

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "carrier/builder.h"
#include "common/parallel.h"
#include "csg/object.h"

/* Sizes are so many, and leaves that one core looks at, at a time. */
enum { NUM_SIZES = 1 << 12, CHUNK = 4096 };

/* Exponent and four bits of the mantissa: grows with the radius, which is not negative. */
static uint32_t size_of(double radius)
{
    const float rounded = (float)fmin(radius, FLT_MAX);
    uint32_t bits;
    memcpy(&bits, &rounded, sizeof bits);
    return bits >> 19;
}

/* A surface's faces are small and come last. */
struct csg_rank csg_carrier_rank(const struct csg_carrier_builder *builder, uint32_t leaf,
                                 uint32_t face)
{
    const double radius =
        builder->scene->leaves[leaf].shape.surface ? 0 : csg_leaf_extent_of(builder, leaf).radius;
    return (struct csg_rank){size_of(radius), leaf, face};
}

struct sizing {
    const struct csg_carrier_builder *builder;
    uint16_t *sizes; /* by leaf */
};

static void size_chunk(void *user, size_t chunk)
{
    const struct sizing *sizing = user;
    const size_t num = sizing->builder->scene->num_leaves;
    for (size_t i = CHUNK * chunk; i < CHUNK * (chunk + 1) && i < num; i++)
        if (sizing->builder->wanted[i])
            sizing->sizes[i] = (uint16_t)csg_carrier_rank(sizing->builder, (uint32_t)i, 0).size;
}

/* By counting them. */
static void sort(struct csg_carrier_builder *builder, const uint16_t *sizes)
{
    const size_t num = builder->scene->num_leaves;
    uint32_t next[NUM_SIZES] = {0}, sum = 0;
    for (size_t i = 0; i < num; i++)
        next[sizes[i]] += builder->wanted[i];
    for (size_t i = NUM_SIZES; i-- > 0;) {
        const uint32_t count = next[i];
        next[i] = sum;
        sum += count;
    }
    for (uint32_t i = 0; i < num; i++)
        if (builder->wanted[i])
            builder->leaves.data[next[sizes[i]]++] = (struct csg_rank){sizes[i], i, 0};
    builder->leaves.num = sum;
}

void csg_carrier_mark_wanted(const struct csgcast_scene *scene, bool *wanted)
{
    for (size_t i = 0; i < scene->objects->num; i++) {
        const struct csg_object *object = &scene->objects->data[i];
        const struct csg_node *nodes = scene->trees[object->layer].data;
        for (uint32_t j = object->begin; j < object->end; j++)
            if (nodes[j].op == CSG_LEAF && !nodes[j].spare)
                wanted[nodes[j].leaf] = true;
    }
}

bool csg_carrier_rank_leaves(struct csg_carrier_builder *builder)
{
    const size_t num = builder->scene->num_leaves;
    struct sizing sizing = {builder, calloc(num + 1, sizeof *sizing.sizes)};
    builder->wanted = calloc(num + 1, sizeof *builder->wanted);
    const bool ok = sizing.sizes && builder->wanted && csg_array_reserve(&builder->leaves, num + 1);
    if (ok) {
        csg_carrier_mark_wanted(builder->scene, builder->wanted);
        csg_parallel(builder->scene->num_threads, (num + CHUNK - 1) / CHUNK, size_chunk, &sizing);
        sort(builder, sizing.sizes);
    }
    free(sizing.sizes);
    return ok;
}
