/* SPDX-License-Identifier: MIT */
/*
 * cylinder(h = 1, r1 = 1, r2 = 1, center = false), also with r, d, d1, d2, as in OpenSCAD.
 * Canonical forms: the unit cylinder x^2 + y^2 = 1 where r1 and r2 are nearly equal, else the
 * cone x^2 + y^2 = z^2. The caps are planes.
 */
#include "solids/facets.h"
#include "solids/rings.h"
#include "solids/solid.h"

/* Below and above. */
static struct csg_ring ring(const void *user, int index)
{
    const struct csg_ring *rings = user;
    return rings[index];
}

/* OpenSCAD's order: r sets both, r1 and r2 win over it, a diameter wins over its radius. */
static void read_rings(const struct csg_args *args, struct csg_ring rings[2], double *rounding)
{
    double r_rounding = 0, h_rounding = 0;
    const double h = csg_args_number(args, "h", 1, &h_rounding);
    const double r = csg_args_radius(args, "r", "d", 1, &r_rounding);
    double roundings[2] = {r_rounding, r_rounding};
    const double r1 = csg_args_radius(args, "r1", "d1", r, &roundings[0]);
    const double r2 = csg_args_radius(args, "r2", "d2", r, &roundings[1]);
    const bool center = csg_args_bool(args, "center");
    rings[0] = (struct csg_ring){r1, center ? -h / 2 : 0};
    rings[1] = (struct csg_ring){r2, center ? h / 2 : h};
    *rounding = h_rounding + fmax(roundings[0], roundings[1]);
}

static bool is_empty(const struct csg_ring rings[2])
{
    const double largest = fmax(rings[0].radius, rings[1].radius);
    return !(rings[1].z > rings[0].z) || !isfinite(rings[1].z - rings[0].z) ||
           !(rings[0].radius >= 0) || !(rings[1].radius >= 0) || !isfinite(rings[0].radius) ||
           !isfinite(rings[1].radius) || !isfinite(1 / largest);
}

/*
 * In units of the larger radius R, canonical z of a cone is its radius at height z,
 *     p.z = (r1 + (r2 - r1) (z - z1) / h) / R,
 * so p.x, p.y, p.z are at most 1 in size on the solid and f = p.x^2 + p.y^2 - p.z^2 is as accurate
 * however far away the apex is: the apex itself is never computed. As r2 - r1 goes to 0, p.z goes
 * to 1 and f to the cylinder's. The solid lies where p.z >= 0, whichever end is the wider one.
 */
static void fill_quadric(struct csg_shape *shape, const struct csg_ring rings[2])
{
    const struct csg_ring low = rings[0], high = rings[1];
    const double largest = fmax(low.radius, high.radius);
    struct csg_quadric *quadric = &shape->quadric;
    shape->has_quadric = true;
    quadric->to_canon = csg_map_scaling(csg_vec3(1 / largest, 1 / largest, 1 / largest));
    quadric->diag[0] = quadric->diag[1] = 1;
    if (csg_nearly(low.radius, high.radius)) {
        quadric->diag[3] = -1;
        return;
    }
    /* Measured from the middle, an end that is a point comes out as one. */
    const double slope = (high.radius - low.radius) / (high.z - low.z);
    const double middle = 0.5 * (low.radius + high.radius);
    quadric->diag[2] = -1;
    quadric->to_canon.m[2][2] = slope / largest;
    quadric->to_canon.m[2][3] = (middle - slope * 0.5 * (low.z + high.z)) / largest;
    shape->sheet = 1;
}

/* The end of a cone gets its plane, too: it parts the two nappes. */
static enum csg_read_result fill(const struct csg_args *args, struct csg_shape *shape,
                                 const struct csg_ring rings[2])
{
    const double largest = fmax(rings[0].radius, rings[1].radius);
    fill_quadric(shape, rings);
    shape->convex = true;
    shape->bounds =
        (struct csg_box){{-largest, -largest, rings[0].z}, {largest, largest, rings[1].z}};
    if (csg_shape_add_plane(shape, csg_vec3(0, 0, -1), -rings[0].z) &&
        csg_shape_add_plane(shape, csg_vec3(0, 0, 1), rings[1].z))
        return CSG_READ_OK;
    csg_log_memory(args->log);
    return CSG_READ_ERROR;
}

static enum csg_read_result read(const struct csg_args *args, struct csg_shape *shape)
{
    const struct csg_facets facets = csg_args_round_facets(args);
    struct csg_ring rings[2];
    read_rings(args, rings, &shape->rounding);
    if (is_empty(rings))
        return CSG_READ_EMPTY;
    const double largest = fmax(rings[0].radius, rings[1].radius);
    const int n = csg_facets_count(&facets, largest);
    const struct csg_box boxes[2] = {csg_ring_box(rings[0], n), csg_ring_box(rings[1], n)};
    shape->written = csg_box_union(&boxes[0], &boxes[1]);
    if (!csg_facets_wanted(args, &facets)) {
        shape->sagitta = csg_facets_sagitta(n, largest);
        return fill(args, shape, rings);
    }
    shape->bounds = shape->written;
    return csg_rings_fill(shape, args, ring, rings, 2, n) ? CSG_READ_OK : CSG_READ_ERROR;
}

const struct csg_solid_ops csg_solid_cylinder = {
    .name = "cylinder",
    .parameters = "h r1 r2 center r d d1 d2",
    .read = read,
};
