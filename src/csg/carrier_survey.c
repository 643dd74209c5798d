/* SPDX-License-Identifier: MIT */

/* Where a scene's faces are looked up, and how far those that coincide may differ there. */

#include <float.h>
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
    const double lever = shape->surface     ? MAX_LEVER
                         : is_sphere(shape) ? 1
                                            : builder->radius / extent->radius;
    return double_tolerance(extent) * (1 + (is_speck(extent) ? fmin(lever, MAX_LEVER) : lever));
}

/* By how much a face that has that rounding and coincides with one of the leaf's may be turned.
 * Faces of a surface are as small as may be. */
static double turn_of(const struct csg_carrier_builder *builder, uint32_t leaf,
                      const struct csg_leaf_extent *extent, double rounding)
{
    return builder->scene->leaves[leaf].shape.surface
               ? INFINITY
               : fmax(csg_carrier_tolerance(extent, rounding) / extent->radius,
                      CSG_COINCIDENT_RELATIVE);
}

/* Leaves that one core looks at, at a time. */
enum { CHUNK = 4096 };

/* The most of some leaves: how far two matching faces can differ, one of them exact where it is by
 * how much they are turned; their rounding; and 1 / radius. */
struct extremes {
    struct csg_carrier_reach reach;
    double rounding, smallness;
};

struct survey {
    const struct csg_carrier_builder *builder;
    struct extremes *extremes; /* by chunk */
};

static void survey_chunk(void *user, size_t chunk)
{
    const struct survey *survey = user;
    const struct csg_carrier_builder *builder = survey->builder;
    struct extremes most = {{0}, 0, 0};
    for (size_t i = CHUNK * chunk; i < CHUNK * (chunk + 1) && i < builder->scene->num_leaves; i++) {
        if (!builder->wanted[i])
            continue;
        const struct csg_leaf_extent extent = csg_leaf_extent_of(builder, (uint32_t)i);
        most.reach.slack = fmax(most.reach.slack, slack_of(builder, (uint32_t)i, &extent));
        most.reach.tolerance = fmax(most.reach.tolerance, double_tolerance(&extent));
        most.reach.turn = fmax(most.reach.turn, turn_of(builder, (uint32_t)i, &extent, 0));
        most.rounding = fmax(most.rounding, extent.rounding);
        most.smallness = fmax(most.smallness, fmin(1 / extent.radius, DBL_MAX));
    }
    survey->extremes[chunk] = most;
}

static void merge(struct extremes *to, const struct extremes *from)
{
    to->reach.slack = fmax(to->reach.slack, from->reach.slack);
    to->reach.tolerance = fmax(to->reach.tolerance, from->reach.tolerance);
    to->reach.turn = fmax(to->reach.turn, from->reach.turn);
    to->rounding = fmax(to->rounding, from->rounding);
    to->smallness = fmax(to->smallness, from->smallness);
}

static bool find_extremes(struct csg_carrier_builder *builder, double room)
{
    const size_t num = (builder->scene->num_leaves + CHUNK - 1) / CHUNK;
    struct survey survey = {builder, malloc((num + 1) * sizeof *survey.extremes)};
    struct extremes most = {{0}, 0, 0};
    if (!survey.extremes)
        return false;
    csg_parallel(builder->scene->num_threads, num, survey_chunk, &survey);
    for (size_t i = 0; i < num; i++)
        merge(&most, &survey.extremes[i]);
    free(survey.extremes);
    builder->largest_rounding = most.rounding;
    builder->most_rounding = room * most.rounding;
    builder->reach.slack = room * most.reach.slack;
    builder->reach.tolerance = room * most.reach.tolerance;
    builder->reach.turn = room * (most.reach.turn + builder->most_rounding * most.smallness);
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
    const struct csg_carrier_space space =
        csg_carrier_space(center, builder->radius, &builder->reach);
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
    return csg_carrier_can_follow(builder, leaf) && away + extent.radius <= builder->radius &&
           extent.rounding <= builder->most_rounding &&
           turn_of(builder, leaf, &extent, builder->most_rounding) <= builder->reach.turn &&
           slack_of(builder, leaf, &extent) <= builder->reach.slack &&
           double_tolerance(&extent) <= builder->reach.tolerance;
}
