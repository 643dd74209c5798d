/* SPDX-License-Identifier: MIT */
#include "carrier/side.h"

/* Rounding of the double arithmetic below, relative to its terms. */
#define NOISE 1e-12

struct span {
    double lo, hi;
};

static struct csg_vec3 half_of(const struct csg_box *box)
{
    return csg_scale(0.5, csg_sub(box->hi, box->lo));
}

static struct csg_vec3 absolute(struct csg_vec3 a)
{
    return csg_vec3(fabs(a.x), fabs(a.y), fabs(a.z));
}

/* Inside is where the value is at most 0. */
static struct span plane_span(const struct csgcast_scene *scene, struct csg_face face,
                              const struct csg_box *box)
{
    const struct csg_plane *plane = &scene->carriers->planes[face.carrier];
    const double height = csg_dot(plane->normal, csg_box_middle(box)) - plane->offset;
    const double mid = face.flipped ? -height : height;
    const double reach = csg_dot(absolute(plane->normal), half_of(box)) +
                         NOISE * (fabs(plane->offset) + fabs(height));
    return (struct span){mid - reach, mid + reach};
}

/* f about the box's center: f + gradient.x + the quadratic part, each over the box. */
static struct span quadric_span(const struct csgcast_scene *scene, uint32_t leaf,
                                const struct csg_box *box)
{
    const struct csg_face face = scene->carriers->quadric_faces[leaf];
    const struct csg_quadric *quadric = csg_carrier_quadric(scene, scene->carriers, face.carrier);
    const struct csg_vec3 center = csg_box_middle(box), half = half_of(box);
    const struct csg_vec3 p = csg_map_point(&quadric->to_canon, center);
    const double value = csg_quadric_value(quadric, center);
    const double slope = csg_dot(absolute(csg_quadric_gradient(quadric, center)), half);
    double curve[2] = {0, 0};
    for (int i = 0; i < 3; i++) {
        const double *row = quadric->to_canon.m[i];
        const double reach = fabs(row[0]) * half.x + fabs(row[1]) * half.y + fabs(row[2]) * half.z;
        curve[quadric->diag[i] > 0] += quadric->diag[i] * reach * reach;
    }
    const double noise = NOISE * (csg_dot(p, p) + slope + 1);
    const struct span span = {value - slope + curve[0] - noise, value + slope + curve[1] + noise};
    return face.flipped ? (struct span){-span.hi, -span.lo} : span;
}

/* Of a box inside of a double cone or a hyperboloid of two sheets: whether on the leaf's sheet. */
static bool is_on_sheet(const struct csgcast_scene *scene, uint32_t leaf, const struct csg_box *box)
{
    const struct csg_face face = scene->carriers->quadric_faces[leaf];
    const struct csg_quadric *quadric = csg_carrier_quadric(scene, scene->carriers, face.carrier);
    const int sheet = scene->carriers->sheets[leaf];
    return !scene->leaves[leaf].shape.convex ||
           sheet * csg_map_point(&quadric->to_canon, csg_box_middle(box)).z >= 0;
}

bool csg_side_is_box(const struct csgcast_scene *scene, uint32_t leaf)
{
    const struct csg_shape *shape = &scene->leaves[leaf].shape;
    if (shape->has_quadric || shape->surface)
        return false;
    for (size_t i = 0; i < shape->num_planes; i++) {
        const struct csg_vec3 n = shape->planes[i].normal;
        if ((n.x != 0) + (n.y != 0) + (n.z != 0) != 1)
            return false;
    }
    return true;
}

uint8_t csg_side_of_leaf(const struct csgcast_scene *scene, uint32_t leaf, bool is_box,
                         const struct csg_box *box)
{
    const struct csg_carriers *carriers = scene->carriers;
    uint8_t known = CSG_EVERYTHING;
    const struct csg_box *own = &scene->leaves[leaf].box;
    const uint8_t by_box = csg_side_of_box(own, box);
    if (is_box || by_box == CSG_NOTHING)
        return by_box;
    if (csg_side_of_box(box, own) == CSG_EVERYTHING) /* all of its surface is in the box */
        return CSG_VARIES;
    for (uint32_t i = carriers->face_begin[leaf]; i < carriers->face_begin[leaf + 1]; i++) {
        const struct span span = plane_span(scene, carriers->faces[i], box);
        if (span.lo > 0)
            return CSG_NOTHING;
        known = span.hi < 0 ? known : CSG_VARIES;
    }
    if (!scene->leaves[leaf].shape.has_quadric)
        return known;
    const struct span span = quadric_span(scene, leaf, box);
    if (span.lo > 0 || (span.hi < 0 && !is_on_sheet(scene, leaf, box)))
        return CSG_NOTHING;
    return span.hi < 0 ? known : CSG_VARIES;
}

bool csg_side_plane_varies(const struct csgcast_scene *scene, struct csg_face face,
                           const struct csg_box *box)
{
    const struct csg_plane *plane = &scene->carriers->planes[face.carrier];
    const struct csg_vec3 n = face.flipped ? csg_scale(-1, plane->normal) : plane->normal;
    const double offset = face.flipped ? -plane->offset : plane->offset;
    const double most = csg_most(n.x * box->lo.x, n.x * box->hi.x) +
                        csg_most(n.y * box->lo.y, n.y * box->hi.y) +
                        csg_most(n.z * box->lo.z, n.z * box->hi.z);
    return most - offset + NOISE * (fabs(offset) + fabs(most)) >= 0;
}

bool csg_side_quadric_varies(const struct csgcast_scene *scene, uint32_t leaf,
                             const struct csg_box *box)
{
    return quadric_span(scene, leaf, box).hi >= 0;
}
