/* SPDX-License-Identifier: MIT */

/* Where a scene's faces are looked up, and how far those that coincide may differ there. */

#include <stdlib.h>

#include "common/parallel.h"
#include "csg/carrier_builder.h"
#include "csg/object.h"

/* Faces whose tolerance is a larger share of their radius than this, which are specks, and those of
 * surfaces: continued to the far end of the scene they stray by this many times their tolerance at
 * most before the index may miss what they coincide with. */
#define MAX_SHARE (1.0 / 128)
#define MAX_LEVER 16.0

/* The finite part of the scene: where the faces are hashed. */
static struct csg_box finite_box(const struct csg_carrier_builder *builder)
{
    const struct csgcast_scene *scene = builder->scene;
    struct csg_box box = csg_box_empty;
    for (size_t i = 0; i < scene->num_leaves; i++) {
        const struct csg_box leaf = csg_leaf_box(&scene->leaves[i]);
        if (builder->wanted[i] && csg_box_is_finite(&leaf))
            box = csg_box_union(&box, &leaf);
    }
    return box;
}

/* How far a face that coincides with one of the leaf's may be from it, over the leaf. */
static double double_tolerance(const struct csg_leaf_extent *extent)
{
    return 2 * csg_carrier_tolerance(extent, extent->rounding);
}

static bool is_speck(const struct csg_leaf_extent *extent)
{
    return !(double_tolerance(extent) <= MAX_SHARE * extent->radius);
}

/* All of a sphere is on the leaf: center and radius are off by a tolerance each, and so no distance
 * from it by more than two. */
static bool is_sphere(const struct csg_shape *shape)
{
    struct csg_vec3 center;
    double radius;
    return shape->has_quadric && shape->num_planes == 0 &&
           csg_quadric_ball(&shape->quadric, &center, &radius);
}

/* The same at the scene's far end. */
static double slack_of(const struct csg_carrier_builder *builder, uint32_t leaf,
                       const struct csg_leaf_extent *extent)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const double lever = shape->surface      ? MAX_LEVER
                         : is_sphere(shape) ? 1
                                             : builder->radius / extent->radius;
    return double_tolerance(extent) *
           (1 + (is_speck(extent) ? fmin(lever, MAX_LEVER) : lever));
}

/* Leaves that one core looks at, at a time. */
enum { CHUNK = 4096 };

/* The most of some leaves: how far two matching faces can differ, and their rounding. */
struct extremes {
    double slack, tolerance, rounding;
};

struct survey {
    const struct csg_carrier_builder *builder;
    struct extremes *extremes; /* by chunk */
};

static void survey_chunk(void *user, size_t chunk)
{
    const struct survey *survey = user;
    const struct csg_carrier_builder *builder = survey->builder;
    struct extremes most = {0, 0, 0};
    for (size_t i = CHUNK * chunk; i < CHUNK * (chunk + 1) && i < builder->scene->num_leaves; i++) {
        if (!builder->wanted[i])
            continue;
        const struct csg_leaf_extent extent = csg_leaf_extent_of(builder, (uint32_t)i);
        most.slack = fmax(most.slack, slack_of(builder, (uint32_t)i, &extent));
        most.tolerance = fmax(most.tolerance, double_tolerance(&extent));
        most.rounding = fmax(most.rounding, extent.rounding);
    }
    survey->extremes[chunk] = most;
}

static bool find_extremes(struct csg_carrier_builder *builder, double room)
{
    const size_t num = (builder->scene->num_leaves + CHUNK - 1) / CHUNK;
    struct survey survey = {builder, malloc((num + 1) * sizeof *survey.extremes)};
    builder->largest_slack = builder->largest_tolerance = builder->largest_rounding = 0;
    if (!survey.extremes)
        return false;
    csg_parallel(builder->scene->num_threads, num, survey_chunk, &survey);
    for (size_t i = 0; i < num; i++) {
        const struct extremes *most = &survey.extremes[i];
        builder->largest_slack = fmax(builder->largest_slack, room * most->slack);
        builder->largest_tolerance = fmax(builder->largest_tolerance, room * most->tolerance);
        builder->largest_rounding = fmax(builder->largest_rounding, most->rounding);
    }
    free(survey.extremes);
    return true;
}

bool csg_carrier_start_index(struct csg_carrier_builder *builder)
{
    const struct csg_box box = finite_box(builder);
    const bool empty = csg_box_is_empty(&box);
    const struct csg_vec3 center =
        empty ? csg_vec3(0, 0, 0) : csg_scale(0.5, csg_add(box.lo, box.hi));
    const double room = builder->keeps ? CSG_CARRIER_ROOM : 1;
    builder->radius = empty ? 1 : room * 0.5 * csg_length(csg_sub(box.hi, box.lo));
    if (!find_extremes(builder, room))
        return false;
    const struct csg_carrier_space space = csg_carrier_space(
        center, builder->radius, builder->largest_slack, builder->largest_tolerance);
    return csg_index_start(&builder->index, &space);
}

bool csg_carrier_can_follow(const struct csg_carrier_builder *builder, uint32_t leaf)
{
    const struct csg_leaf *own = &builder->scene->leaves[leaf];
    const struct csg_leaf_extent extent = csg_leaf_extent_of(builder, leaf);
    return csg_box_is_finite(&own->box) && !own->shape.surface && !is_speck(&extent);
}

bool csg_carrier_has_room(const struct csg_carrier_builder *builder, uint32_t leaf)
{
    const struct csg_leaf_extent extent = csg_leaf_extent_of(builder, leaf);
    const double away = csg_length(csg_sub(extent.center, builder->index.space.center));
    return csg_carrier_can_follow(builder, leaf) &&
           away + extent.radius <= builder->radius &&
           slack_of(builder, leaf, &extent) <= builder->largest_slack &&
           double_tolerance(&extent) <= builder->largest_tolerance;
}
