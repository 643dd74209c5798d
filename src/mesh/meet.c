/* SPDX-License-Identifier: MIT */
/*
 * Lines and a surface, in double. The space is sheared so that the line is the third axis (Woop,
 * Benthin and Wald 2013); what remains is a plane in which the line is the origin.
 */
#include <stdlib.h>

#include "mesh/surface.h"
#include "solids/shape.h"

/* Boxes are met a little earlier: rounding of the shear is a few times 1e-16 of what goes in. */
#define BOX_MARGIN 1e-13

struct shear {
    struct csg_vec3 org;
    int x, y, z; /* axes; z is the one along which the line goes furthest */
    double sx, sy, length;
};

/* A corner across the line, and how far along. */
struct corner {
    double x, y, t;
};

static struct shear shear_for(struct csg_vec3 org, struct csg_vec3 dir)
{
    const double x = fabs(dir.x), y = fabs(dir.y), z = fabs(dir.z);
    struct shear shear = {.org = org, .z = x > y && x > z ? 0 : y > z ? 1 : 2};
    shear.x = (shear.z + 1) % 3;
    shear.y = (shear.z + 2) % 3;
    shear.length = csg_vec3_component(dir, shear.z);
    shear.sx = csg_vec3_component(dir, shear.x) / shear.length;
    shear.sy = csg_vec3_component(dir, shear.y) / shear.length;
    return shear;
}

static struct corner corner_of(const struct shear *shear, struct csg_vec3 point)
{
    const struct csg_vec3 p = csg_sub(point, shear->org);
    const double z = csg_vec3_component(p, shear->z);
    return (struct corner){csg_vec3_component(p, shear->x) - shear->sx * z,
                           csg_vec3_component(p, shear->y) - shear->sy * z, z / shear->length};
}

static bool meets_box(const struct shear *shear, const struct csg_box *box)
{
    const struct csg_vec3 middle = csg_sub(csg_box_middle(box), shear->org);
    const struct csg_vec3 half = csg_scale(0.5, csg_sub(box->hi, box->lo));
    const double z = csg_vec3_component(middle, shear->z),
                 reach = csg_vec3_component(half, shear->z);
    const double x = csg_vec3_component(middle, shear->x) - shear->sx * z;
    const double y = csg_vec3_component(middle, shear->y) - shear->sy * z;
    const double size = fabs(middle.x) + fabs(middle.y) + fabs(middle.z) + fabs(shear->org.x) +
                        fabs(shear->org.y) + fabs(shear->org.z) + reach;
    return fabs(x) <=
               csg_vec3_component(half, shear->x) + fabs(shear->sx) * reach + BOX_MARGIN * size &&
           fabs(y) <=
               csg_vec3_component(half, shear->y) + fabs(shear->sy) * reach + BOX_MARGIN * size;
}

/* Whether the edge crosses the half-line from the origin along +x: 1 upwards, -1 downwards. Asked
 * from the lower end to the upper one, so that an edge and its reverse cancel. */
static int edge_turns(const struct corner *a, const struct corner *b)
{
    if ((a->y <= 0) == (b->y <= 0))
        return 0;
    const bool upwards = a->y <= 0;
    const struct corner *lo = upwards ? a : b, *hi = upwards ? b : a;
    return lo->x * hi->y > hi->x * lo->y ? (upwards ? 1 : -1) : 0;
}

static bool meet_triangle(const struct csg_surface *surface, uint32_t i, const struct shear *shear,
                          struct csg_meetings *meetings)
{
    const uint32_t *points = surface->triangles.data[i].points;
    const struct corner a = corner_of(shear, surface->points.data[points[0]]);
    const struct corner b = corner_of(shear, surface->points.data[points[1]]);
    const struct corner c = corner_of(shear, surface->points.data[points[2]]);
    const int turns = edge_turns(&a, &b) + edge_turns(&b, &c) + edge_turns(&c, &a);
    if (turns == 0)
        return true;
    const struct csg_meeting meeting = {i, shear->length > 0 ? turns : -turns,
                                        fmin(a.t, fmin(b.t, c.t)), fmax(a.t, fmax(b.t, c.t))};
    return csg_array_push(meetings, meeting);
}

/* The line in the space of the surface, where it leaves the solid by the same triangles, also of a
 * place that mirrors. false: there is none. */
static bool enter_space(const struct csg_map *place, struct csg_vec3 *org, struct csg_vec3 *dir)
{
    struct csg_map inverse;
    if (csg_map_is_identity(place))
        return true;
    if (!csg_map_invert(place, &inverse))
        return false;
    *org = csg_map_point(&inverse, *org);
    *dir = csg_map_direction(&inverse, *dir);
    return true;
}

bool csg_surface_meet(const struct csg_surface *surface, const struct csg_map *place,
                      struct csg_vec3 org, struct csg_vec3 dir, struct csg_meetings *meetings)
{
    if (!enter_space(place, &org, &dir))
        return true;
    const struct shear shear = shear_for(org, dir);
    const struct csg_box_node *nodes = surface->nodes.data;
    for (size_t i = 0; i < surface->nodes.num;) {
        if (!meets_box(&shear, &nodes[i].box)) {
            i = nodes[i].end;
            continue;
        }
        for (uint32_t j = 0; j < nodes[i].num; j++)
            if (!meet_triangle(surface, nodes[i].first + j, &shear, meetings))
                return false;
        i++;
    }
    return true;
}

int csg_surface_winding(const struct csg_surface *surface, const struct csg_map *place,
                        struct csg_vec3 p)
{
    struct csg_vec3 dir = {0.5773, 0.2113, 0.7886}; /* along no likely face */
    struct csg_meetings meetings = {0};
    int winding = 0;
    if (enter_space(place, &p, &dir) &&
        csg_surface_meet(surface, &csg_map_identity, p, dir, &meetings))
        for (size_t i = 0; i < meetings.num; i++) {
            const struct csg_meeting *meeting = &meetings.data[i];
            const struct csg_plane *plane =
                &surface->planes.data[surface->triangles.data[meeting->triangle].plane];
            const double along = csg_dot(plane->normal, dir);
            double t = (plane->offset - csg_dot(plane->normal, p)) / along;
            t = along == 0 ? meeting->tmin : fmin(fmax(t, meeting->tmin), meeting->tmax);
            winding += t > 0 ? meeting->turns : 0;
        }
    free(meetings.data);
    return winding;
}

static bool triangle_is_at(const struct csg_surface *surface, const struct csg_triangle *triangle,
                           struct csg_vec3 p, double distance)
{
    const struct csg_plane *plane = &surface->planes.data[triangle->plane];
    if (fabs(csg_dot(plane->normal, p) - plane->offset) > distance)
        return false;
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 a = surface->points.data[triangle->points[i]];
        const struct csg_vec3 b = surface->points.data[triangle->points[(i + 1) % 3]];
        const struct csg_vec3 out = csg_normalize(csg_cross(csg_sub(b, a), plane->normal));
        if (csg_dot(out, csg_sub(p, a)) > distance)
            return false;
    }
    return true;
}

bool csg_surface_is_at(const struct csg_surface *surface, const struct csg_map *place,
                       struct csg_vec3 p, double distance)
{
    struct csg_map inverse;
    if (!csg_map_invert(place, &inverse))
        return false;
    p = csg_map_point(&inverse, p);
    distance *= csg_map_stretch(&inverse);
    const struct csg_box at = {p, p}, around = csg_box_grown(&at, distance);
    const struct csg_box_node *nodes = surface->nodes.data;
    for (size_t i = 0; i < surface->nodes.num;) {
        const bool meets = csg_box_overlaps(&nodes[i].box, &around);
        for (uint32_t j = 0; meets && j < nodes[i].num; j++)
            if (triangle_is_at(surface, &surface->triangles.data[nodes[i].first + j], p, distance))
                return true;
        i = meets ? i + 1 : nodes[i].end;
    }
    return false;
}
