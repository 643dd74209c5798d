/* SPDX-License-Identifier: MIT */

/* Which carrier a leaf's face lies on, of those that are in the index: docs/coincidence.md. */

#include "carrier/builder.h"
#include "csg/object.h"
#include "solids/sample.h"

/* Points of a quadric's surface that decide whether it lies on another one; nine fix a quadric. */
enum { NUM_SAMPLES = 24, LEAST_SAMPLES = 9 };

struct csg_leaf_extent csg_leaf_extent_of(const struct csg_carrier_builder *builder, uint32_t leaf)
{
    const struct csg_box box = builder->scene->leaves[leaf].box;
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const double rounding = shape->rounding;
    if (!csg_box_is_finite(&box))
        return (struct csg_leaf_extent){csg_map_point(&shape->frame, csg_vec3(0, 0, 0)), INFINITY,
                                        builder->radius, rounding};
    const double radius = 0.5 * csg_length(csg_sub(box.hi, box.lo));
    return (struct csg_leaf_extent){csg_box_middle(&box), radius, radius, rounding};
}

double csg_carrier_tolerance(const struct csg_leaf_extent *extent, double other_rounding)
{
    const double size = csg_length(extent->center) + extent->reach;
    return extent->rounding + other_rounding + CSG_COINCIDENT_RELATIVE * size;
}

/* Largest distance between two planes over a ball; s is the sign that aligns the normals. */
static double plane_deviation(const struct csg_plane *a, const struct csg_plane *b, double s,
                              const struct csg_leaf_extent *extent)
{
    const struct csg_vec3 n = csg_sub(a->normal, csg_scale(s, b->normal));
    const double turn = csg_length(n);
    /* An unbounded face coincides only with a parallel one, to the noise of double arithmetic. */
    if (!isfinite(extent->radius) && turn > CSG_COINCIDENT_RELATIVE)
        return INFINITY;
    return fabs(csg_dot(n, extent->center) - (a->offset - s * b->offset)) + turn * extent->reach;
}

static double alignment(const struct csg_plane *a, const struct csg_plane *b)
{
    return csg_dot(a->normal, b->normal) < 0 ? -1 : 1;
}

bool csg_carrier_may_take(const struct csg_carrier_builder *builder, uint32_t carrier,
                          const struct csg_plane *plane, const struct csg_leaf_extent *extent)
{
    const struct csg_plane *there = &builder->carriers->planes[carrier];
    return plane_deviation(plane, there, alignment(plane, there), extent) <=
           csg_carrier_tolerance(extent, builder->lists[CSG_PLANE].rounding.data[carrier]);
}

/* Whether the face of that rank asks for the carrier: it comes before the face, and before what was
 * found so far. */
static bool is_asked_for(const struct csg_carrier_builder *builder, enum csg_face_kind kind,
                         uint32_t carrier, const struct csg_rank *rank, uint32_t found)
{
    const struct csg_rank *ranks = builder->lists[kind].ranks.data;
    if (!builder->keeps) /* in the order of ranks */
        return carrier < found;
    return csg_rank_compare(&ranks[carrier], rank) < 0 &&
           (found == CSG_NO_CARRIER || csg_rank_compare(&ranks[carrier], &ranks[found]) < 0);
}

/* Of the carriers parallel to like. */
static void find_parallel(const struct csg_carrier_builder *builder, const struct csg_plane *plane,
                          const struct csg_plane *like, const struct csg_leaf_extent *extent,
                          const struct csg_rank *rank, struct csg_face *face)
{
    struct csg_index_probe probe;
    csg_index_probe_parallel(&builder->index, like, &probe);
    for (uint32_t i; (i = csg_index_next(&builder->index, &probe)) != CSG_NO_CARRIER;) {
        if (!is_asked_for(builder, CSG_PLANE, i, rank, face->carrier))
            continue;
        if (csg_carrier_may_take(builder, i, plane, extent))
            *face =
                (struct csg_face){.carrier = i,
                                  .flipped = alignment(plane, &builder->carriers->planes[i]) < 0,
                                  .is_other = true};
    }
}

/* The plane through the middle of the leaf's face that has another one's normal. */
static struct csg_plane turned_plane(const struct csg_plane *plane, const struct csg_plane *other,
                                     const struct csg_leaf_extent *extent)
{
    const double s = alignment(plane, other);
    const struct csg_vec3 turn = csg_sub(plane->normal, csg_scale(s, other->normal));
    return (struct csg_plane){other->normal, s * (plane->offset - csg_dot(turn, extent->center))};
}

bool csg_carrier_find_met(const struct csg_carrier_builder *builder, const struct csg_plane *plane,
                          struct csg_face *face)
{
    struct csg_index_probe probe;
    csg_index_probe_parallel(&builder->index, plane, &probe);
    for (uint32_t i; (i = csg_index_next(&builder->index, &probe)) != CSG_NO_CARRIER;) {
        const struct csg_plane *carrier = &builder->carriers->planes[i];
        const double s = alignment(plane, carrier);
        if (plane->normal.x == s * carrier->normal.x && plane->normal.y == s * carrier->normal.y &&
            plane->normal.z == s * carrier->normal.z && plane->offset == s * carrier->offset) {
            *face = (struct csg_face){.carrier = i, .flipped = s < 0};
            return true;
        }
    }
    return csg_plane_table_find(&builder->others, plane, face);
}

bool csg_carrier_find_plane(const struct csg_carrier_builder *builder,
                            const struct csg_plane *plane, const struct csg_leaf_extent *extent,
                            const struct csg_rank *rank, struct csg_face *face)
{
    face->carrier = CSG_NO_CARRIER;
    find_parallel(builder, plane, plane, extent, rank, face);
    struct csg_index_probe probe;
    const struct csg_carrier_spread spread =
        csg_carrier_spread_of(builder, extent, builder->largest_rounding);
    const int width = csg_carrier_narrowest(&builder->index.space, &spread);
    csg_index_probe_normals(&builder->index, width, plane, &probe);
    for (uint32_t i; (i = csg_index_next(&builder->index, &probe)) != CSG_NO_CARRIER;) {
        const struct csg_plane *carrier = &builder->carriers->planes[i];
        const struct csg_plane like = turned_plane(plane, carrier, extent);
        if (plane_deviation(plane, &like, alignment(plane, &like), extent) <=
            csg_carrier_tolerance(extent, builder->largest_rounding))
            find_parallel(builder, plane, &like, extent, rank, face);
    }
    return face->carrier != CSG_NO_CARRIER;
}

/* Same normal form up to sign: the only quadrics that can be the same surface. */
static bool same_class(const struct csg_quadric *a, const struct csg_quadric *b)
{
    for (double s = 1; s >= -1; s -= 2)
        if (a->diag[0] == s * b->diag[0] && a->diag[1] == s * b->diag[1] &&
            a->diag[2] == s * b->diag[2] && a->diag[3] == s * b->diag[3] &&
            fabs(a->linear) == fabs(b->linear))
            return true;
    return false;
}

/* Whether the insides lie on different sides. The normal form does not tell: a saddle's complement
 * has the same one. */
static bool is_flipped(const struct csg_quadric *a, const struct csg_quadric *b, struct csg_vec3 at)
{
    return csg_dot(csg_quadric_gradient(a, at), csg_quadric_gradient(b, at)) < 0;
}

static bool is_on(const struct csg_quadric *carrier, struct csg_vec3 point, double tolerance_length)
{
    const double slope = csg_length(csg_quadric_gradient(carrier, point));
    return fabs(csg_quadric_value(carrier, point)) <= tolerance_length * slope;
}

/* Points of a leaf's quadric. Nearly all carriers that are asked for are told apart by the first
 * one, so that the others are found only when they are needed. */
struct samples {
    struct csg_vec3 points[NUM_SAMPLES];
    size_t num;
    bool are_all;
};

static void sample(struct samples *samples, const struct csg_shape *shape, size_t num)
{
    samples->num = csg_shape_sample(shape, samples->points, num);
    samples->are_all = num == NUM_SAMPLES;
}

static bool same_surface(const struct csg_quadric *carrier, const struct csg_shape *shape,
                         struct samples *samples, double tolerance_length)
{
    if (!samples->num && !samples->are_all)
        sample(samples, shape, 1);
    if (samples->num && !is_on(carrier, samples->points[0], tolerance_length))
        return false;
    if (!samples->are_all)
        sample(samples, shape, NUM_SAMPLES);
    for (size_t i = 0; i < samples->num; i++)
        if (!is_on(carrier, samples->points[i], tolerance_length))
            return false;
    return samples->num >= LEAST_SAMPLES;
}

bool csg_carrier_find_quadric(const struct csg_carrier_builder *builder, uint32_t leaf,
                              const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                              struct csg_face *face)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    struct samples samples;
    samples.num = 0;
    samples.are_all = false;
    struct csg_index_probe probe;
    face->carrier = CSG_NO_CARRIER;
    csg_index_probe_quadric(&builder->index, &shape->quadric, &probe);
    for (uint32_t i; (i = csg_index_next(&builder->index, &probe)) != CSG_NO_CARRIER;) {
        const struct csg_quadric *carrier =
            csg_carrier_quadric(builder->scene, builder->carriers, i);
        if (!is_asked_for(builder, CSG_QUADRIC, i, rank, face->carrier) ||
            !same_class(&shape->quadric, carrier))
            continue;
        const double rounding = builder->lists[CSG_QUADRIC].rounding.data[i];
        if (same_surface(carrier, shape, &samples, csg_carrier_tolerance(extent, rounding)))
            *face = (struct csg_face){
                .carrier = i, .flipped = is_flipped(&shape->quadric, carrier, samples.points[0])};
    }
    return face->carrier != CSG_NO_CARRIER;
}
