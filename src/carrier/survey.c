/* SPDX-License-Identifier: MIT */

/* Where a scene's faces are looked up, and how far those that coincide may differ there. */

#include <stdlib.h>

#include "carrier/builder.h"
#include "common/parallel.h"
#include "csg/object.h"

/* Faces whose tolerance is a larger share of their radius than this are specks: continued to the
 * far end of the scene they stray by this many times their tolerance at most before the index may
 * miss what they coincide with. */
#define MAX_SHARE (1.0 / 128)
#define MAX_LEVER 16.0

/* Room beyond what the lever tells: of curved quadrics; of cylinders and cones from so many times
 * as large as thick on, and the most of those. */
#define CURVED_ROOM 8.0
#define THIN 16.0
#define MAX_THIN_ROOM 16.0

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

/* What happens on a leaf is so many times as large at the scene's far end. */
static double lever_of(const struct csg_carrier_builder *builder,
                       const struct csg_leaf_extent *extent)
{
    const double lever = builder->radius / extent->radius;
    return is_speck(extent) ? fmin(lever, MAX_LEVER) : lever;
}

/* Half the least side of a box around it. */
static double thickness_of(const struct csg_shape *shape)
{
    const struct csg_vec3 size = csg_sub(shape->bounds.hi, shape->bounds.lo);
    const double sides[3] = {size.x, size.y, size.z};
    double least = INFINITY;
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 axis = csg_vec3(i == 0, i == 1, i == 2);
        least = fmin(least, 0.5 * sides[i] * csg_length(csg_map_direction(&shape->frame, axis)));
    }
    return least;
}

/*
 * What the lever does not tell of a quadric: distances follow a small change of the surface only to
 * first order, and the axis of a short cylinder or cone is known less well than its size says. Of
 * random pairs of cylinders and cones with six digits those with lengths of 0.01 of the radius and
 * more are all found with a quarter of this.
 */
static double room_of_quadric(const struct csg_shape *shape, const struct csg_leaf_extent *extent)
{
    const struct csg_quadric *quadric = &shape->quadric;
    const bool is_ruled = quadric->linear == 0 && quadric->diag[0] == quadric->diag[1] &&
                          (quadric->diag[2] == 0 || quadric->diag[3] == 0);
    if (!is_ruled || !isfinite(extent->radius))
        return CURVED_ROOM;
    return fmin(fmax(extent->radius / (THIN * thickness_of(shape)), 1), MAX_THIN_ROOM);
}

/* How far a quadric that coincides with the leaf's may be from it there; 0: it has none. */
static double slack_of(const struct csg_carrier_builder *builder, uint32_t leaf,
                       const struct csg_leaf_extent *extent)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    if (!shape->has_quadric)
        return 0;
    if (is_sphere(shape))
        return 2 * double_tolerance(extent);
    return room_of_quadric(shape, extent) * double_tolerance(extent) *
           (1 + lever_of(builder, extent));
}

struct csg_carrier_spread csg_carrier_spread_of(const struct csg_carrier_builder *builder,
                                                const struct csg_leaf_extent *extent,
                                                double other_rounding)
{
    const double tolerance = csg_carrier_tolerance(extent, other_rounding);
    return (struct csg_carrier_spread){
        .slack = tolerance * (1 + lever_of(builder, extent)),
        .turn = fmax(tolerance / extent->radius, CSG_COINCIDENT_RELATIVE)};
}

/* ---- the scene's box and rounding --------------------------------------------------------- */

/* Leaves that one core looks at, at a time. */
enum { CHUNK = 4096 };

/* Of some leaves: the finite ones' box, and the largest rounding. */
struct outline {
    struct csg_box box;
    double rounding;
};

/* The most of some leaves. */
struct extremes {
    struct csg_carrier_reach reach;
    struct csg_carrier_spread
        spreads[CSG_MAX_WIDTHS]; /* by width; turn is 0 where there are none */
};

struct survey {
    const struct csg_carrier_builder *builder;
    struct outline *outlines;  /* by chunk */
    struct extremes *extremes; /* likewise */
};

static void outline_chunk(void *user, size_t chunk)
{
    const struct survey *survey = user;
    const struct csgcast_scene *scene = survey->builder->scene;
    struct outline outline = {csg_box_empty, 0};
    for (size_t i = CHUNK * chunk; i < CHUNK * (chunk + 1) && i < scene->num_leaves; i++) {
        if (!survey->builder->wanted[i])
            continue;
        const struct csg_box box = scene->leaves[i].box;
        if (csg_box_is_finite(&box))
            outline.box = csg_box_union(&outline.box, &box);
        outline.rounding = fmax(outline.rounding, scene->leaves[i].shape.rounding);
    }
    survey->outlines[chunk] = outline;
}

static struct outline find_outline(const struct survey *survey, size_t num_chunks)
{
    struct outline all = {csg_box_empty, 0};
    csg_parallel(survey->builder->scene->num_threads, num_chunks, outline_chunk, (void *)survey);
    for (size_t i = 0; i < num_chunks; i++) {
        all.box = csg_box_union(&all.box, &survey->outlines[i].box);
        all.rounding = fmax(all.rounding, survey->outlines[i].rounding);
    }
    return all;
}

/* ---- how far faces may differ ------------------------------------------------------------- */

static void merge_spread(struct csg_carrier_spread *to, const struct csg_carrier_spread *from)
{
    to->slack = fmax(to->slack, from->slack);
    to->turn = fmax(to->turn, from->turn);
}

static void note_spread(struct extremes *most, const struct csg_carrier_builder *builder,
                        const struct csg_leaf_extent *extent)
{
    const struct csg_carrier_spread spread =
        csg_carrier_spread_of(builder, extent, builder->most_rounding);
    merge_spread(&most->spreads[csg_carrier_width(&spread)], &spread);
}

/* The faces of a surface that are looked up, or will be after edits, each as large as itself, or
 * less. */
static void note_surface(struct extremes *most, const struct csg_carrier_builder *builder,
                         uint32_t leaf)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const struct csg_surface *surface = shape->surface;
    const uint8_t *near = builder->remote.near[leaf];
    struct csg_map inverse = csg_map_identity;
    csg_map_invert(&shape->frame, &inverse);
    const double stretch = csg_map_stretch(&inverse);
    for (size_t i = 0; (near || builder->has_room) && i < surface->planes.num; i++) {
        if (!builder->has_room && !near[i])
            continue;
        const struct csg_surface_extent extent = {
            csg_map_point(&shape->frame, surface->extents[i].center),
            surface->extents[i].radius / stretch};
        const struct csg_leaf_extent face = csg_carrier_face_extent(&extent, shape->rounding);
        note_spread(most, builder, &face);
    }
}

static void note_leaf(struct extremes *most, const struct csg_carrier_builder *builder,
                      uint32_t leaf)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const struct csg_leaf_extent extent = csg_leaf_extent_of(builder, leaf);
    most->reach.slack = fmax(most->reach.slack, slack_of(builder, leaf, &extent));
    most->reach.tolerance = fmax(most->reach.tolerance, double_tolerance(&extent));
    if (shape->surface)
        note_surface(most, builder, leaf);
    else if (shape->num_planes > 0)
        note_spread(most, builder, &extent);
}

static void survey_chunk(void *user, size_t chunk)
{
    const struct survey *survey = user;
    const struct csg_carrier_builder *builder = survey->builder;
    struct extremes most = {0};
    for (size_t i = CHUNK * chunk; i < CHUNK * (chunk + 1) && i < builder->scene->num_leaves; i++)
        if (builder->wanted[i])
            note_leaf(&most, builder, (uint32_t)i);
    survey->extremes[chunk] = most;
}

static void merge(struct extremes *to, const struct extremes *from)
{
    to->reach.slack = fmax(to->reach.slack, from->reach.slack);
    to->reach.tolerance = fmax(to->reach.tolerance, from->reach.tolerance);
    for (int i = 0; i < CSG_MAX_WIDTHS; i++)
        merge_spread(&to->spreads[i], &from->spreads[i]);
}

static struct extremes find_extremes(const struct survey *survey, size_t num_chunks, double room)
{
    struct extremes most = {0};
    csg_parallel(survey->builder->scene->num_threads, num_chunks, survey_chunk, (void *)survey);
    for (size_t i = 0; i < num_chunks; i++)
        merge(&most, &survey->extremes[i]);
    most.reach.slack *= room;
    most.reach.tolerance *= room;
    for (int i = 0; i < CSG_MAX_WIDTHS; i++) {
        most.spreads[i].slack *= room;
        most.spreads[i].turn *= room;
    }
    return most;
}

/* ---- the index ---------------------------------------------------------------------------- */

static size_t count_chunks(const struct csg_carrier_builder *builder)
{
    return (builder->scene->num_leaves + CHUNK - 1) / CHUNK;
}

static double room_of(const struct csg_carrier_builder *builder)
{
    return builder->has_room ? CSG_CARRIER_ROOM : 1;
}

bool csg_carrier_outline(struct csg_carrier_builder *builder)
{
    const size_t num_chunks = count_chunks(builder);
    const double room = room_of(builder);
    const struct survey survey = {.builder = builder,
                                  .outlines = malloc((num_chunks + 1) * sizeof *survey.outlines)};
    if (!survey.outlines)
        return false;
    const struct outline outline = find_outline(&survey, num_chunks);
    const struct csg_box *box = &outline.box;
    const bool empty = csg_box_is_empty(box);
    builder->center = empty ? csg_vec3(0, 0, 0) : csg_box_middle(box);
    builder->radius = empty ? 1 : room * 0.5 * csg_length(csg_sub(box->hi, box->lo));
    builder->largest_rounding = outline.rounding;
    builder->most_rounding = room * outline.rounding;
    free(survey.outlines);
    return true;
}

bool csg_carrier_start_index(struct csg_carrier_builder *builder)
{
    const size_t num_chunks = count_chunks(builder);
    const struct survey survey = {.builder = builder,
                                  .extremes = malloc((num_chunks + 1) * sizeof *survey.extremes)};
    if (!survey.extremes)
        return false;
    const struct extremes most = find_extremes(&survey, num_chunks, room_of(builder));
    const struct csg_carrier_space space =
        csg_carrier_space(builder->center, builder->radius, &most.reach, most.spreads);
    builder->reach = most.reach;
    free(survey.extremes);
    return csg_index_start(&builder->index, &space);
}

bool csg_carrier_can_follow(const struct csg_carrier_builder *builder, uint32_t leaf)
{
    const struct csg_leaf *own = &builder->scene->leaves[leaf];
    const struct csg_leaf_extent extent = csg_leaf_extent_of(builder, leaf);
    return csg_box_is_finite(&own->box) && !is_speck(&extent);
}

bool csg_carrier_can_follow_faces(const struct csg_placed_faces *placed, const uint8_t *near,
                                  const struct csg_shape *shape)
{
    for (size_t i = 0; i < shape->surface->planes.num; i++) {
        const struct csg_leaf_extent face =
            csg_carrier_face_extent(&placed->extents[i], shape->rounding);
        if (near[i] && is_speck(&face))
            return false;
    }
    return true;
}

/* Whether planes that coincide with faces of that extent are found in some width. */
static bool has_width(const struct csg_carrier_builder *builder,
                      const struct csg_leaf_extent *extent)
{
    const struct csg_carrier_space *space = &builder->index.space;
    const struct csg_carrier_spread spread =
        csg_carrier_spread_of(builder, extent, builder->most_rounding);
    return space->num_widths > 0 &&
           csg_carrier_has_spread(&space->widths[csg_carrier_narrowest(space, &spread)], &spread);
}

bool csg_carrier_has_room(const struct csg_carrier_builder *builder, uint32_t leaf)
{
    const struct csg_leaf_extent extent = csg_leaf_extent_of(builder, leaf);
    const double away = csg_length(csg_sub(extent.center, builder->index.space.center));
    const struct csg_shape *leaf_shape = &builder->scene->leaves[leaf].shape;
    return csg_carrier_can_follow(builder, leaf) && away + extent.radius <= builder->radius &&
           extent.rounding <= builder->most_rounding &&
           (leaf_shape->num_planes == 0 || has_width(builder, &extent)) &&
           slack_of(builder, leaf, &extent) <= builder->reach.slack &&
           double_tolerance(&extent) <= builder->reach.tolerance;
}

bool csg_carrier_has_room_for_faces(const struct csg_carrier_builder *builder,
                                    const struct csg_placed_faces *placed, const uint8_t *near,
                                    const struct csg_shape *shape)
{
    for (size_t i = 0; i < shape->surface->planes.num; i++) {
        const struct csg_leaf_extent face =
            csg_carrier_face_extent(&placed->extents[i], shape->rounding);
        if (near[i] && (is_speck(&face) || !has_width(builder, &face)))
            return false;
    }
    return true;
}
