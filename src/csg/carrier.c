/* SPDX-License-Identifier: MIT */
#include "csg/carrier.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "csg/carrier_index.h"
#include "csg/loners.h"
#include "csg/object.h"
#include "csg/plane_table.h"
#include "csg/remote.h"
#include "mesh/surface.h"
#include "solids/sample.h"

/* Points of a quadric's surface that decide whether it lies on another one; nine fix a quadric. */
#define CSG_NUM_SAMPLES 24

/* A small leaf's face, continued to the far end of the scene, strays by this many times its
 * tolerance at most before the index may miss it. */
#define MAX_LEVER 16.0

/* Where a leaf is and how much its faces may be off. Of an unbounded leaf the finite part of the
 * scene is what matters; center is its own place. */
struct extent {
    struct csg_vec3 center;
    double radius; /* infinite for an unbounded leaf */
    double reach;  /* the same, but finite */
    double rounding;
};

/* Leaves within a sixteenth of an octave in size count as equal: what follows goes through large
 * scenes in the order of their file then, and so of memory, most of the time. */
struct ranked_leaf {
    uint32_t size, leaf;
};

struct builder {
    const struct csgcast_scene *scene;
    const struct csg_carriers_before *before; /* may be NULL */
    struct csg_carriers *carriers;
    CSG_ARRAY(double) plane_rounding; /* of the leaf each carrier came from */
    CSG_ARRAY(double) quadric_rounding;
    struct csg_carrier_index index;
    struct csg_plane_table planes; /* that were met */
    bool *wanted;               /* by leaf: it is in leaves */
    bool is_alone;              /* the only leaf: no face can coincide with another */
    struct csg_loners loners;   /* neither in the index nor in the table */
    double radius;              /* of the finite part of the scene */
    double largest_rounding;    /* of the leaves at hand */
    CSG_ARRAY(struct ranked_leaf) leaves; /* largest first */
};

static struct extent leaf_extent(const struct builder *builder, uint32_t leaf)
{
    const struct csg_box box = csg_leaf_box(&builder->scene->leaves[leaf]);
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const double rounding = shape->rounding;
    if (!csg_box_is_finite(&box))
        return (struct extent){csg_map_point(&shape->frame, csg_vec3(0, 0, 0)), INFINITY,
                               builder->radius, rounding};
    const double radius = 0.5 * csg_length(csg_sub(box.hi, box.lo));
    return (struct extent){csg_scale(0.5, csg_add(box.lo, box.hi)), radius, radius, rounding};
}

static double tolerance(const struct extent *extent, double other_rounding)
{
    const double size = csg_length(extent->center) + extent->reach;
    return extent->rounding + other_rounding + CSG_COINCIDENT_RELATIVE * size;
}

/* Largest distance between two planes over a ball; s is the sign that aligns the normals. */
static double plane_deviation(const struct csg_plane *a, const struct csg_plane *b, double s,
                              const struct extent *extent)
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

/* Of the carriers parallel to like. */
static bool find_parallel(const struct builder *builder, const struct csg_plane *plane,
                          const struct csg_plane *like, const struct extent *extent,
                          struct csg_face *face)
{
    struct csg_index_probe probe;
    csg_index_probe_parallel(&builder->index, like, &probe);
    for (uint32_t i; (i = csg_index_next(&builder->index, &probe)) != CSG_NO_CARRIER;) {
        const struct csg_plane *carrier = &builder->carriers->planes[i];
        const double s = alignment(plane, carrier);
        if (plane_deviation(plane, carrier, s, extent) <=
            tolerance(extent, builder->plane_rounding.data[i])) {
            *face = (struct csg_face){i, s < 0};
            return true;
        }
    }
    return false;
}

/* The plane through the middle of the leaf's face that has another one's normal. */
static struct csg_plane turned_plane(const struct csg_plane *plane, const struct csg_plane *other,
                                     const struct extent *extent)
{
    const double s = alignment(plane, other);
    const struct csg_vec3 turn = csg_sub(plane->normal, csg_scale(s, other->normal));
    return (struct csg_plane){other->normal,
                              s * (plane->offset - csg_dot(turn, extent->center))};
}

static bool find_plane(const struct builder *builder, const struct csg_plane *plane,
                       const struct extent *extent, struct csg_face *face)
{
    if (find_parallel(builder, plane, plane, extent, face))
        return true;
    struct csg_index_probe probe;
    csg_index_probe_normals(&builder->index, plane, &probe);
    for (uint32_t i; (i = csg_index_next(&builder->index, &probe)) != CSG_NO_CARRIER;) {
        const struct csg_plane *carrier = &builder->carriers->planes[i];
        const struct csg_plane like = turned_plane(plane, carrier, extent);
        if (plane_deviation(plane, &like, alignment(plane, &like), extent) <=
                tolerance(extent, builder->largest_rounding) &&
            find_parallel(builder, plane, &like, extent, face))
            return true;
    }
    return false;
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

static bool same_surface(const struct csg_quadric *carrier, const struct csg_vec3 *points,
                         size_t num_points, double tolerance_length)
{
    for (size_t i = 0; i < num_points; i++) {
        const double slope = csg_length(csg_quadric_gradient(carrier, points[i]));
        if (!(fabs(csg_quadric_value(carrier, points[i])) <= tolerance_length * slope))
            return false;
    }
    return num_points >= 9;
}

/* Whether the leaf lay on the carrier before, with nothing changed that decides it: of a leaf
 * without bounds the whole scene does. */
static bool was_on(const struct builder *builder, uint32_t leaf, const struct extent *extent,
                   uint32_t carrier, struct csg_face *face)
{
    const struct csg_carriers_before *before = builder->before;
    if (!before || before->changed[leaf] || !isfinite(extent->radius))
        return false;
    const struct csg_face was = before->carriers->quadric_faces[leaf];
    const uint32_t owner = builder->carriers->quadric_leaves[carrier];
    if (was.carrier == CSG_NO_CARRIER || before->changed[owner] ||
        before->carriers->quadric_leaves[was.carrier] != owner)
        return false;
    *face = (struct csg_face){carrier, was.flipped};
    return true;
}

static bool find_quadric(const struct builder *builder, uint32_t leaf,
                         const struct extent *extent, struct csg_face *face)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    struct csg_vec3 points[CSG_NUM_SAMPLES];
    size_t num_points = 0;
    struct csg_index_probe probe;
    csg_index_probe_quadric(&builder->index, &shape->quadric, &probe);
    for (uint32_t i; (i = csg_index_next(&builder->index, &probe)) != CSG_NO_CARRIER;) {
        const struct csg_quadric *carrier =
            csg_carrier_quadric(builder->scene, builder->carriers, i);
        if (!same_class(&shape->quadric, carrier))
            continue;
        if (was_on(builder, leaf, extent, i, face))
            return true;
        if (!num_points)
            num_points = csg_shape_sample(shape, points, CSG_NUM_SAMPLES);
        if (same_surface(carrier, points, num_points,
                         tolerance(extent, builder->quadric_rounding.data[i]))) {
            *face = (struct csg_face){i, is_flipped(&shape->quadric, carrier, points[0])};
            return true;
        }
    }
    return false;
}

/* Appends to an array that lives in struct csg_carriers. */
#define push_carrier(carriers, name, value)                                                        \
    (((carriers)->num_##name < (carriers)->name##_capacity ||                                      \
      csg_array_grow((void **)&(carriers)->name, &(carriers)->name##_capacity,                     \
                     (carriers)->num_##name, 1, sizeof *(carriers)->name))                         \
         ? ((carriers)->name[(carriers)->num_##name++] = (value), true)                            \
         : false)

static bool add_plane(struct builder *builder, const struct csg_plane *plane,
                      const struct extent *extent, bool alone, struct csg_face *face)
{
    struct csg_carriers *carriers = builder->carriers;
    *face = (struct csg_face){(uint32_t)carriers->num_planes, false};
    return push_carrier(carriers, planes, *plane) &&
           csg_array_push(&builder->plane_rounding, extent->rounding) &&
           (alone || csg_index_add_plane(&builder->index, plane, face->carrier));
}

static bool add_quadric(struct builder *builder, uint32_t leaf, const struct extent *extent,
                        bool alone, struct csg_face *face)
{
    struct csg_carriers *carriers = builder->carriers;
    const struct csg_quadric *quadric = &builder->scene->leaves[leaf].shape.quadric;
    *face = (struct csg_face){(uint32_t)carriers->num_quadrics, false};
    carriers->num_quadrics++;
    return push_carrier(carriers, quadric_boxes, csg_box_empty) &&
           push_carrier(carriers, quadric_leaves, leaf) &&
           csg_array_push(&builder->quadric_rounding, extent->rounding) &&
           (alone || csg_index_add_quadric(&builder->index, quadric, face->carrier));
}

/* The sheet as the carrier's canonical space counts it: its z axis may point the other way. */
static int8_t carrier_sheet(const struct csg_shape *shape, const struct csg_quadric *carrier)
{
    const double *a = shape->quadric.to_canon.m[2], *b = carrier->to_canon.m[2];
    return (int8_t)(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < 0 ? -shape->sheet : shape->sheet);
}

static bool is_loner(const struct builder *builder, const uint8_t *loners, size_t i)
{
    return builder->is_alone || (loners && loners[i]);
}

static bool assign_plane(struct builder *builder, const struct csg_plane *plane,
                         const struct extent *extent, struct csg_face *face)
{
    struct csg_carriers *carriers = builder->carriers;
    const bool alone =
        is_loner(builder, builder->loners.planes, (size_t)(face - carriers->faces));
    if (alone)
        return add_plane(builder, plane, extent, alone, face);
    const bool was_met = csg_plane_table_find(&builder->planes, carriers->planes, plane, face);
    const bool is_shared = was_met || find_plane(builder, plane, extent, face);
    carriers->num_shared += is_shared;
    return (is_shared || add_plane(builder, plane, extent, alone, face)) &&
           (was_met || csg_plane_table_add(&builder->planes, carriers->planes, plane, face));
}

struct ranked_plane {
    double radius;
    uint32_t plane;
};

static int compare_planes(const void *a, const void *b)
{
    const struct ranked_plane *x = a, *y = b;
    if (x->radius != y->radius)
        return x->radius > y->radius ? -1 : 1;
    return x->plane < y->plane ? -1 : x->plane > y->plane;
}

static bool is_same_plane(const struct csg_plane *a, const struct csg_plane *b)
{
    return a->normal.x == b->normal.x && a->normal.y == b->normal.y && a->normal.z == b->normal.z &&
           a->offset == b->offset;
}

/* A face that no other one comes near gets a carrier of its own, or that of the face before it. */
static bool assign_remote(struct builder *builder, const struct csg_surface *surface, uint32_t i,
                          bool was_remote, const struct extent *extent, struct csg_face *faces)
{
    const struct csg_plane *planes = surface->planes.data;
    if (was_remote && is_same_plane(&planes[i - 1], &planes[i])) {
        faces[i] = faces[i - 1];
        return true;
    }
    return add_plane(builder, &planes[i], extent, true, &faces[i]);
}

static struct extent face_extent(const struct csg_surface_extent *extent, double rounding)
{
    return (struct extent){extent->center, extent->radius, extent->radius, rounding};
}

/* Assigns the faces that are remote and ranks the others; SIZE_MAX: out of memory. */
static size_t rank_planes(struct builder *builder, uint32_t leaf,
                          const struct csg_surface_extent *extents, struct ranked_plane *ranked)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const struct csg_surface *surface = shape->surface;
    struct csg_face *faces = &builder->carriers->faces[builder->carriers->face_begin[leaf]];
    const struct csg_remote remote = csg_remote_start(builder->scene, builder->wanted, leaf);
    bool was_remote = false;
    size_t num = 0;
    for (uint32_t i = 0; i < surface->planes.num; i++) {
        const struct extent extent = face_extent(&extents[i], shape->rounding);
        const double reach = extent.radius + tolerance(&extent, builder->largest_rounding);
        const bool is_remote = csg_remote_is(&remote, extent.center, reach);
        if (!is_remote)
            ranked[num++] = (struct ranked_plane){extent.radius, i};
        else if (!assign_remote(builder, surface, i, was_remote, &extent, faces))
            return SIZE_MAX;
        was_remote = is_remote;
    }
    return num;
}

/* Each face of a surface counts where it is, the largest first. */
static bool assign_surface(struct builder *builder, uint32_t leaf)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const struct csg_surface *surface = shape->surface;
    struct csg_face *faces = &builder->carriers->faces[builder->carriers->face_begin[leaf]];
    struct csg_surface_extent *extents = csg_surface_extents(surface);
    struct ranked_plane *ranked = malloc((surface->planes.num + 1) * sizeof *ranked);
    const size_t num = extents && ranked ? rank_planes(builder, leaf, extents, ranked) : SIZE_MAX;
    bool ok = num != SIZE_MAX;
    if (ok && num > 1)
        qsort(ranked, num, sizeof *ranked, compare_planes);
    for (size_t i = 0; ok && i < num; i++) {
        const uint32_t plane = ranked[i].plane;
        const struct extent extent = face_extent(&extents[plane], shape->rounding);
        ok = assign_plane(builder, &surface->planes.data[plane], &extent, &faces[plane]);
    }
    free(extents);
    free(ranked);
    return ok;
}

static bool assign_leaf(struct builder *builder, uint32_t leaf)
{
    struct csg_carriers *carriers = builder->carriers;
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    const struct extent extent = leaf_extent(builder, leaf);
    if (shape->surface)
        return assign_surface(builder, leaf);
    for (size_t i = 0; i < shape->num_planes; i++) {
        struct csg_face *face = &carriers->faces[carriers->face_begin[leaf] + i];
        if (!assign_plane(builder, &shape->planes[i], &extent, face))
            return false;
    }
    if (!shape->has_quadric)
        return true;
    struct csg_face *face = &carriers->quadric_faces[leaf];
    const bool alone = is_loner(builder, builder->loners.quadrics, leaf);
    if (!alone && find_quadric(builder, leaf, &extent, face))
        carriers->num_shared++;
    else if (!add_quadric(builder, leaf, &extent, alone, face))
        return false;
    carriers->sheets[leaf] = carrier_sheet(
        shape, csg_carrier_quadric(builder->scene, carriers, face->carrier));
    return true;
}

/* Exponent and four bits of the mantissa: grows with the radius, which is not negative. */
static uint32_t size_of(double radius)
{
    const float rounded = (float)fmin(radius, FLT_MAX);
    uint32_t bits;
    memcpy(&bits, &rounded, sizeof bits);
    return bits >> 19;
}

static int compare_ranked(const void *a, const void *b)
{
    const struct ranked_leaf *x = a, *y = b;
    if (x->size != y->size)
        return x->size > y->size ? -1 : 1;
    return x->leaf < y->leaf ? -1 : x->leaf > y->leaf;
}

static bool rank_object(struct builder *builder, const struct csg_object *object)
{
    const struct csgcast_scene *scene = builder->scene;
    const struct csg_tree *tree = &scene->trees[object->layer];
    bool ok = true;
    for (uint32_t i = object->begin; i < object->end && ok; i++) {
        const uint32_t leaf = tree->data[i].leaf;
        if (tree->data[i].op != CSG_LEAF || tree->data[i].spare || builder->wanted[leaf])
            continue;
        builder->wanted[leaf] = true;
        const double radius =
            scene->leaves[leaf].shape.surface ? 0 : leaf_extent(builder, leaf).radius;
        ok = csg_array_push(&builder->leaves, ((struct ranked_leaf){size_of(radius), leaf}));
    }
    return ok;
}

/* The objects' leaves, the largest first: its faces are the least turned by rounding, so they
 * become the carriers. A surface's faces are small and come last. A leaf can be in two layers; its
 * first object counts. */
static bool rank_leaves(struct builder *builder)
{
    const struct csgcast_scene *scene = builder->scene;
    builder->wanted = calloc(scene->num_leaves + 1, sizeof *builder->wanted);
    bool ok = builder->wanted && csg_array_reserve(&builder->leaves, scene->num_leaves);
    for (size_t i = 0; i < scene->objects->num && ok; i++)
        ok = rank_object(builder, &scene->objects->data[i]);
    if (ok && builder->leaves.num)
        qsort(builder->leaves.data, builder->leaves.num, sizeof *builder->leaves.data,
              compare_ranked);
    return ok;
}

/* The finite part of the scene: where the faces are hashed. */
static struct csg_box finite_box(const struct builder *builder)
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

/* ... and how far two matching faces can differ there at most. */
static bool start_index(struct builder *builder)
{
    const struct csgcast_scene *scene = builder->scene;
    const struct csg_box box = finite_box(builder);
    const bool empty = csg_box_is_empty(&box);
    const struct csg_vec3 center =
        empty ? csg_vec3(0, 0, 0) : csg_scale(0.5, csg_add(box.lo, box.hi));
    builder->radius = empty ? 1 : 0.5 * csg_length(csg_sub(box.hi, box.lo));
    double slack = 0, largest = 0;
    builder->largest_rounding = 0;
    for (uint32_t i = 0; i < scene->num_leaves; i++) {
        if (!builder->wanted[i])
            continue;
        const struct extent extent = leaf_extent(builder, i);
        const double length = 2 * tolerance(&extent, extent.rounding);
        const double lever =
            scene->leaves[i].shape.surface ? MAX_LEVER : builder->radius / extent.radius;
        slack = fmax(slack, length * (1 + fmin(lever, MAX_LEVER)));
        largest = fmax(largest, length);
        builder->largest_rounding = fmax(builder->largest_rounding, extent.rounding);
    }
    return csg_index_start(&builder->index, center, builder->radius, slack, largest);
}

/* Coincidence is looked for among all leaves: flush faces of different objects share carriers too,
 * so that the depth buffer sees equal depths and the first object wins everywhere. */
static bool assign_all(struct builder *builder)
{
    if (!rank_leaves(builder))
        return false;
    builder->is_alone = builder->leaves.num == 1 &&
                        !builder->scene->leaves[builder->leaves.data[0].leaf].shape.surface;
    if (!builder->is_alone &&
        (!start_index(builder) ||
         !csg_loners_find(&builder->loners, builder->scene, builder->wanted,
                          builder->carriers->face_begin, &builder->index)))
        return false;
    for (size_t i = 0; i < builder->leaves.num; i++)
        if (!assign_leaf(builder, builder->leaves.data[i].leaf))
            return false;
    return true;
}

/* What can be seen of each quadric: its leaves, as far as the objects reach that they are in. */
static void fill_boxes(const struct csgcast_scene *scene, struct csg_carriers *carriers)
{
    for (size_t i = 0; i < scene->objects->num; i++) {
        const struct csg_object *object = &scene->objects->data[i];
        const struct csg_node *nodes = scene->trees[object->layer].data;
        for (uint32_t j = object->begin; j < object->end; j++) {
            const struct csg_face face = nodes[j].op == CSG_LEAF && !nodes[j].spare
                                             ? carriers->quadric_faces[nodes[j].leaf]
                                             : (struct csg_face){CSG_NO_CARRIER, false};
            if (face.carrier == CSG_NO_CARRIER)
                continue;
            struct csg_box box = csg_leaf_box(&scene->leaves[nodes[j].leaf]);
            box = csg_box_intersection(&box, &object->box);
            if (!csg_box_is_empty(&box))
                carriers->quadric_boxes[face.carrier] =
                    csg_box_union(&carriers->quadric_boxes[face.carrier], &box);
        }
    }
}

static bool allocate(struct csg_carriers *carriers, const struct csgcast_scene *scene)
{
    const size_t num = scene->num_leaves;
    carriers->face_begin = malloc((num + 1) * sizeof *carriers->face_begin);
    if (!carriers->face_begin)
        return false;
    uint32_t total = 0;
    for (size_t i = 0; i < num; i++) {
        carriers->face_begin[i] = total;
        const struct csg_shape *shape = &scene->leaves[i].shape;
        total += (uint32_t)(shape->surface ? shape->surface->planes.num : shape->num_planes);
    }
    carriers->face_begin[num] = total;
    carriers->faces = calloc(total + 1, sizeof *carriers->faces);
    carriers->quadric_faces = malloc((num + 1) * sizeof *carriers->quadric_faces);
    carriers->sheets = calloc(num + 1, sizeof *carriers->sheets);
    if (!carriers->faces || !carriers->quadric_faces || !carriers->sheets)
        return false;
    for (size_t i = 0; i < num; i++)
        carriers->quadric_faces[i] = (struct csg_face){CSG_NO_CARRIER, false};
    return true;
}

struct csg_carriers *csg_carriers_create(const struct csgcast_scene *scene,
                                         const struct csg_carriers_before *before)
{
    struct builder builder = {
        .scene = scene, .before = before, .carriers = calloc(1, sizeof *builder.carriers)};
    const bool ok =
        builder.carriers && allocate(builder.carriers, scene) && assign_all(&builder);
    if (ok)
        fill_boxes(scene, builder.carriers);
    csg_index_finish(&builder.index);
    csg_loners_finish(&builder.loners);
    free(builder.wanted);
    csg_plane_table_finish(&builder.planes);
    free(builder.plane_rounding.data);
    free(builder.quadric_rounding.data);
    free(builder.leaves.data);
    if (ok)
        return builder.carriers;
    csg_carriers_destroy(builder.carriers);
    return NULL;
}

void csg_carriers_destroy(struct csg_carriers *carriers)
{
    if (!carriers)
        return;
    free(carriers->planes);
    free(carriers->quadric_boxes);
    free(carriers->quadric_leaves);
    free(carriers->face_begin);
    free(carriers->faces);
    free(carriers->quadric_faces);
    free(carriers->sheets);
    free(carriers);
}
