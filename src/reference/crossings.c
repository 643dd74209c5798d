/* SPDX-License-Identifier: MIT */
#include "reference/crossings.h"

#include <stdlib.h>

double csg_cross_plane(const struct csg_plane *plane, const struct csg_ray *ray, double *along)
{
    *along = csg_dot(plane->normal, ray->dir);
    return (plane->offset - csg_dot(plane->normal, ray->org)) / *along;
}

/* Below this share of a direction's square, the part across a quadric's axis is too small to say
 * where along the line the axis is nearest. */
#define NEARLY_PARALLEL 1e-8

/* Where p + t d is nearest to the quadric's middle, or to its axis where it has one. */
static double nearest_to_middle(const int8_t q[4], struct csg_vec3 p, struct csg_vec3 d)
{
    struct csg_vec3 w = csg_vec3(abs(q[0]), abs(q[1]), abs(q[2]));
    double dd = w.x * d.x * d.x + w.y * d.y * d.y + w.z * d.z * d.z;
    if (dd <= NEARLY_PARALLEL * csg_dot(d, d)) {
        w = csg_vec3(1, 1, 1);
        dd = csg_dot(d, d);
    }
    return dd > 0 ? -(w.x * p.x * d.x + w.y * p.y * d.y + w.z * p.z * d.z) / dd : 0;
}

/* Crossings in order, 0 to 2; *before: f < 0 (or, without crossings, everywhere).
 * f(p + t d) = a t^2 + 2 b t + c, from the point p of the line that is nearest: b is then small and
 * c is not the difference of two large squares. */
static int cross_quadric(const struct csg_quadric *quadric, const struct csg_ray *ray, double t[2],
                         bool *before)
{
    const int8_t *q = quadric->diag;
    const struct csg_vec3 d = csg_map_direction(&quadric->to_canon, ray->dir);
    struct csg_vec3 p = csg_map_point(&quadric->to_canon, ray->org);
    const double shift = nearest_to_middle(q, p, d);
    p = csg_add(p, csg_scale(shift, d));
    const double a = q[0] * d.x * d.x + q[1] * d.y * d.y + q[2] * d.z * d.z;
    const double b = q[0] * p.x * d.x + q[1] * p.y * d.y + q[2] * p.z * d.z + quadric->linear * d.z;
    const double c =
        q[0] * p.x * p.x + q[1] * p.y * p.y + q[2] * p.z * p.z + 2 * quadric->linear * p.z + q[3];
    const double disc = b * b - a * c;
    if (a == 0 && b == 0) {
        *before = c < 0;
        return 0;
    }
    *before = a != 0 ? a < 0 : b > 0;
    if (a == 0) {
        t[0] = shift - 0.5 * c / b;
        return 1;
    }
    if (!(disc >= 0))
        return 0;
    const double far = -(b + copysign(sqrt(disc), b));
    const double t0 = far / a, t1 = far != 0 ? c / far : t0;
    t[0] = shift + fmin(t0, t1);
    t[1] = shift + fmax(t0, t1);
    return 2;
}

struct span {
    double lo, hi;
};

static struct span plane_span(const struct csgcast_scene *scene, uint32_t leaf,
                              const struct csg_ray *ray)
{
    const struct csg_carriers *carriers = scene->carriers;
    struct span span = {-INFINITY, INFINITY};
    for (uint32_t i = carriers->face_begin[leaf]; i < carriers->face_begin[leaf + 1]; i++) {
        const struct csg_face face = carriers->faces[i];
        const struct csg_plane *plane = &carriers->planes[face.carrier];
        double along;
        const double t = csg_cross_plane(plane, ray, &along);
        if (along == 0) {
            const double above = csg_dot(plane->normal, ray->org) - plane->offset;
            if (face.flipped ? above < 0 : above > 0)
                return (struct span){INFINITY, -INFINITY};
        } else if ((along < 0) != face.flipped) {
            span.lo = fmax(span.lo, t);
        } else {
            span.hi = fmin(span.hi, t);
        }
    }
    return span;
}

static void add_span(struct csg_leaf_crossings *list, double lo, double hi)
{
    if (!(lo < hi))
        return;
    if (lo == -INFINITY)
        list->inside = true;
    else
        list->t[list->num++] = lo;
    if (hi < INFINITY)
        list->t[list->num++] = hi;
}

struct csg_leaf_crossings csg_cross_leaf(const struct csgcast_scene *scene, uint32_t leaf,
                                         const struct csg_ray *ray)
{
    struct csg_leaf_crossings list = {false, 0, {0}};
    const struct span span = plane_span(scene, leaf, ray);
    const struct csg_face face = scene->carriers->quadric_faces[leaf];
    if (face.carrier == CSG_NO_CARRIER) {
        add_span(&list, span.lo, span.hi);
        return list;
    }
    double t[2] = {0, 0};
    bool inside;
    const int num =
        cross_quadric(csg_carrier_quadric(scene, scene->carriers, face.carrier), ray, t, &inside);
    inside = inside != face.flipped;
    double from = -INFINITY;
    for (int i = 0; i <= num; i++, inside = !inside) {
        const double to = i < num ? t[i] : INFINITY;
        if (inside)
            add_span(&list, fmax(from, span.lo), fmin(to, span.hi));
        from = to;
    }
    return list;
}

/* Face of the leaf that a crossing is on: of those passed in the same sense, the nearest. */
struct csg_vec3 csg_leaf_normal(const struct csgcast_scene *scene, uint32_t leaf,
                                const struct csg_ray *ray, double t, bool enters)
{
    const struct csg_carriers *carriers = scene->carriers;
    double nearest = INFINITY;
    struct csg_vec3 normal = {0, 0, 1};
    for (uint32_t i = carriers->face_begin[leaf]; i < carriers->face_begin[leaf + 1]; i++) {
        const struct csg_face face = carriers->faces[i];
        const struct csg_plane *plane = &carriers->planes[face.carrier];
        double along;
        const double miss = fabs(csg_cross_plane(plane, ray, &along) - t);
        if (along != 0 && ((along < 0) != face.flipped) == enters && miss < nearest) {
            nearest = miss;
            normal = csg_scale(face.flipped ? -1 : 1, plane->normal);
        }
    }
    const struct csg_face face = carriers->quadric_faces[leaf];
    if (face.carrier == CSG_NO_CARRIER)
        return normal;
    double roots[2];
    bool before;
    const struct csg_quadric *quadric = csg_carrier_quadric(scene, carriers, face.carrier);
    const int num = cross_quadric(quadric, ray, roots, &before);
    for (int i = 0; i < num; i++)
        if (fabs(roots[i] - t) < nearest) {
            nearest = fabs(roots[i] - t);
            const struct csg_vec3 at = csg_add(ray->org, csg_scale(t, ray->dir));
            normal =
                csg_normalize(csg_scale(face.flipped ? -1 : 1, csg_quadric_gradient(quadric, at)));
        }
    return normal;
}
