/* SPDX-License-Identifier: MIT */
/* Surfaces: what a line meets of the triangles, at the carriers of their faces. */
#include <stdlib.h>

#include "reference/crossings.h"

/* A carrier may lie off its face by the file's rounding; where a line runs along both, no further
 * than this many times the face's own length on the line. */
#define MAX_OVERSHOOT 4.0

/* Where the line crosses the face's carrier, and, where it runs along it, within the triangle. */
static double crossing_of(const struct csg_plane *plane, const struct csg_ray *ray,
                          const struct csg_meeting *meeting)
{
    double along;
    const double t = csg_cross_plane(plane, ray, &along);
    const double reach = MAX_OVERSHOOT * (meeting->tmax - meeting->tmin) +
                         1e-5 * (fabs(meeting->tmin) + fabs(meeting->tmax));
    return along != 0 && t >= meeting->tmin - reach && t <= meeting->tmax + reach
               ? t
               : 0.5 * (meeting->tmin + meeting->tmax);
}

static int compare_crossings(const void *a, const void *b)
{
    const struct csg_surface_crossing *x = a, *y = b;
    if (x->t != y->t)
        return x->t < y->t ? -1 : 1;
    return x->face < y->face ? -1 : x->face > y->face;
}

bool csg_cross_surface(const struct csgcast_scene *scene, uint32_t leaf, const struct csg_ray *ray,
                       struct csg_surface_crossings *crossings)
{
    const struct csg_map *place = &scene->leaves[leaf].shape.frame;
    const struct csg_surface *surface = scene->leaves[leaf].shape.surface;
    struct csg_map inverse = csg_map_identity;
    crossings->num = crossings->meetings.num = 0;
    if (!csg_surface_meet(surface, place, ray->org, ray->dir, &crossings->meetings))
        return false;
    csg_map_invert(place, &inverse);
    for (size_t i = 0; i < crossings->meetings.num; i++) {
        const struct csg_meeting *meeting = &crossings->meetings.data[i];
        const uint32_t face = surface->triangles.data[meeting->triangle].plane;
        bool flipped;
        const struct csg_plane plane = csg_carrier_of_face(scene, leaf, face, &inverse, &flipped);
        const double t = crossing_of(&plane, ray, meeting);
        if (!csg_array_push(crossings, ((struct csg_surface_crossing){t, face, meeting->turns})))
            return false;
    }
    if (crossings->num > 1)
        qsort(crossings->data, crossings->num, sizeof *crossings->data, compare_crossings);
    return true;
}

struct csg_vec3 csg_surface_normal(const struct csgcast_scene *scene, uint32_t leaf,
                                   const struct csg_ray *ray, double t, bool enters,
                                   struct csg_surface_crossings *crossings)
{
    struct csg_map inverse = csg_map_identity;
    struct csg_vec3 normal = {0, 0, 1};
    double nearest = INFINITY, best = 0;
    csg_map_invert(&scene->leaves[leaf].shape.frame, &inverse);
    if (!csg_cross_surface(scene, leaf, ray, crossings))
        return normal;
    for (size_t i = 0; i < crossings->num; i++) {
        const struct csg_surface_crossing *crossing = &crossings->data[i];
        bool flipped;
        const struct csg_plane plane =
            csg_carrier_of_face(scene, leaf, crossing->face, &inverse, &flipped);
        const struct csg_vec3 own = csg_scale(flipped ? -1 : 1, plane.normal);
        /* Of faces at one place one that the line passes in the right sense. */
        const double right = (csg_dot(own, ray->dir) < 0) == enters ? 1 : 0;
        const double miss = fabs(crossing->t - t);
        if (miss < nearest || (miss == nearest && right > best)) {
            nearest = miss;
            best = right;
            normal = own;
        }
    }
    return normal;
}
