/* SPDX-License-Identifier: MIT */
#include "carrier/nearness.h"

#include "carrier/builder.h"
#include "csg/object.h"
#include "mesh/surface.h"

/* Another leaf, seen from the space of the surface. */
struct other {
    const struct csg_surface *surface; /* its triangles; NULL: it is no surface */
    struct csg_map enter;              /* takes the surface's space to the other's */
    struct csg_box box;                /* all of it, and what lies within reach of it */
    double reach;
    /* Of a leaf that has bounds and is no surface, in the world: its shape, how large it is, and how
     * far its faces and the surface's may be from each other where they share a carrier. */
    const struct csg_shape *bounded;
    double radius, distance;
};

/* How far from each other faces may be that coincide. */
static double reach_of(const struct csg_neighbour *solid, double rounding)
{
    const struct csg_box box = solid->box;
    const double radius = csg_length(csg_sub(box.hi, box.lo));
    const struct csg_leaf_extent extent = {box.lo, radius, radius, solid->shape->rounding};
    return csg_carrier_tolerance(&extent, rounding);
}

struct csg_neighbour csg_neighbour_of(const struct csgcast_scene *scene, uint32_t leaf)
{
    return (struct csg_neighbour){&scene->leaves[leaf].shape, scene->leaves[leaf].box};
}

struct csg_box csg_nearness_around(const struct csgcast_scene *scene, uint32_t leaf,
                                   double rounding)
{
    const struct csg_neighbour self = csg_neighbour_of(scene, leaf);
    return csg_box_grown(&self.box, reach_of(&self, rounding));
}

struct csg_nearness csg_nearness_to(const struct csgcast_scene *scene, uint32_t leaf,
                                    double rounding)
{
    const struct csg_neighbour self = csg_neighbour_of(scene, leaf);
    struct csg_nearness own = {.surface = self.shape->surface,
                               .frame = &self.shape->frame,
                               .inverse = csg_map_identity,
                               .stretch = csg_map_stretch(&self.shape->frame),
                               .reach = reach_of(&self, rounding),
                               .rounding = rounding,
                               .around = csg_nearness_around(scene, leaf, rounding)};
    csg_map_invert(own.frame, &own.inverse);
    return own;
}

static struct other other_of(const struct csg_nearness *own, const struct csg_neighbour *there)
{
    const struct csg_shape *shape = there->shape;
    const struct csg_map map = csg_map_multiply(&own->inverse, &shape->frame);
    const struct csg_box box = csg_box_map(&map, &shape->bounds);
    struct csg_map back;
    struct other other = {.reach = own->reach * csg_map_stretch(&own->inverse)};
    other.box = csg_box_grown(&box, other.reach);
    if (shape->surface && csg_map_invert(&shape->frame, &back)) {
        other.surface = shape->surface;
        other.enter = csg_map_multiply(&back, own->frame);
    } else if (!shape->surface && csg_box_is_finite(&there->box)) {
        other.bounded = shape;
        other.radius = 0.5 * csg_length(csg_sub(there->box.hi, there->box.lo));
        other.distance = own->reach + reach_of(there, own->rounding);
    }
    return other;
}

/* Whether some triangle of the other one may come near the box. */
static bool comes_near(const struct other *other, const struct csg_box *box)
{
    const struct csg_box around = csg_box_grown(box, other->reach);
    const struct csg_box there = csg_box_map(&other->enter, &around);
    const struct csg_box_node *nodes = other->surface->nodes.data;
    for (size_t i = 0; i < other->surface->nodes.num;) {
        const bool meets = csg_box_overlaps(&nodes[i].box, &there);
        if (meets && nodes[i].num > 0)
            return true;
        i = meets ? i + 1 : nodes[i].end;
    }
    return false;
}

/* A plane of the other leaf. Heights above it are those in the world. */
struct side {
    struct csg_vec3 normal;
    double offset;
};

static struct side side_of(const struct csg_nearness *own, const struct csg_plane *plane)
{
    const struct csg_vec3 middle = csg_map_column(own->frame, 3);
    return (struct side){csg_map_transposed(own->frame, plane->normal),
                         plane->offset - csg_dot(plane->normal, middle)};
}

static bool passes_box(const struct side *side, const struct csg_box *box, double distance)
{
    const struct csg_vec3 n = side->normal, half = csg_scale(0.5, csg_sub(box->hi, box->lo));
    const double height = csg_dot(n, csg_box_middle(box)) - side->offset;
    const double reach = fabs(n.x) * half.x + fabs(n.y) * half.y + fabs(n.z) * half.z;
    return fabs(height) - reach <= distance;
}

/*
 * Whether a face on that side of the other leaf may share the triangle's carrier where they meet.
 * Then they are within the distance of each other all over the smaller of them: with r its radius,
 * the sine of the angle between them is at most distance / r. The triangle is at most twice as wide
 * as the radius of its face, so over it heights differ by at most that sine times twice this.
 */
static bool may_share(const struct csg_nearness *own, const struct csg_triangle *triangle,
                      const struct other *other, const struct side *side)
{
    const double radius = own->surface->extents[triangle->plane].radius * own->stretch;
    double lo = INFINITY, hi = -INFINITY;
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 point = own->surface->points.data[triangle->points[i]];
        const double height = csg_dot(side->normal, point) - side->offset;
        lo = csg_least(lo, height);
        hi = csg_most(hi, height);
    }
    return lo <= other->distance && hi >= -other->distance &&
           !((hi - lo) * csg_least(radius, other->radius) > 2 * other->distance * radius);
}

static bool may_meet(const struct csg_nearness *own, size_t node, const struct other *other)
{
    return (!own->only || own->only[node]) &&
           csg_box_overlaps(&own->surface->nodes.data[node].box, &other->box);
}

/* Marks the planes of triangles that faces of one side of the other one may coincide with. */
static bool mark_side(const struct csg_nearness *own, const struct other *other,
                      const struct csg_plane *plane, uint8_t *near)
{
    const struct csg_surface *surface = own->surface;
    const struct csg_box_node *nodes = surface->nodes.data;
    const struct side side = side_of(own, plane);
    bool is_any = false;
    for (size_t i = 0; i < surface->nodes.num;) {
        if (!may_meet(own, i, other) || !passes_box(&side, &nodes[i].box, other->distance)) {
            i = nodes[i].end;
            continue;
        }
        for (uint32_t j = 0; j < nodes[i].num; j++) {
            const struct csg_triangle *triangle = &surface->triangles.data[nodes[i].first + j];
            if (!may_share(own, triangle, other, &side))
                continue;
            near[surface->own[triangle->plane].plane] = 1;
            is_any = true;
        }
        i++;
    }
    return is_any;
}

static bool mark_sides(const struct csg_nearness *own, const struct other *other, uint8_t *near)
{
    bool is_any = false;
    for (uint32_t i = 0; i < other->bounded->num_planes; i++)
        is_any |= mark_side(own, other, &other->bounded->planes[i], near);
    return is_any;
}

/* Marks the planes of triangles that the other one may meet. */
static bool mark(const struct csg_nearness *own, const struct other *other, uint8_t *near)
{
    const struct csg_surface *surface = own->surface;
    const struct csg_box_node *nodes = surface->nodes.data;
    bool is_any = false;
    if (other->bounded)
        return mark_sides(own, other, near);
    for (size_t i = 0; i < surface->nodes.num;) {
        if (!may_meet(own, i, other) ||
            (nodes[i].num && other->surface && !comes_near(other, &nodes[i].box))) {
            i = nodes[i].end;
            continue;
        }
        for (uint32_t j = 0; j < nodes[i].num; j++)
            near[surface->own[surface->triangles.data[nodes[i].first + j].plane].plane] = 1;
        is_any |= nodes[i].num > 0;
        i++;
    }
    return is_any;
}

bool csg_nearness_mark(const struct csg_nearness *own, const struct csg_neighbour *neighbour,
                       uint8_t *near)
{
    if (!csg_box_overlaps(&neighbour->box, &own->around))
        return false;
    const struct other other = other_of(own, neighbour);
    return mark(own, &other, near);
}

void csg_nearness_spread(const struct csg_surface *surface, uint8_t *near)
{
    for (uint32_t i = 0; i < surface->planes.num; i++)
        near[i] = near[surface->own[i].plane];
}
