/* SPDX-License-Identifier: MIT */
/* sphere(r = 1) or sphere(d = 2), as in OpenSCAD. Canonical form: the unit sphere. */
#include "solids/facets.h"
#include "solids/rings.h"
#include "solids/solid.h"

struct globe {
    double radius;
    int num_rings;
};

/* OpenSCAD has no corners at the poles: ring i lies at 180 (i + 1/2) / num_rings degrees from +z.
 * Here the rings are counted from below. */
static struct csg_ring ring(const void *user, int index)
{
    const struct globe *globe = user;
    const double degrees = 180 * (globe->num_rings - 1 - index + 0.5) / globe->num_rings;
    return (struct csg_ring){globe->radius * csg_sin_degrees(degrees),
                             globe->radius * csg_cos_degrees(degrees)};
}

static struct csg_box globe_box(const struct globe *globe, int n)
{
    const struct csg_ring top = ring(globe, globe->num_rings - 1);
    struct csg_box box = csg_ring_box(ring(globe, globe->num_rings / 2), n);
    box.lo.z = -top.z;
    box.hi.z = top.z;
    return box;
}

static void fill_quadric(struct csg_shape *shape, double radius)
{
    const double s = 1 / radius;
    shape->has_quadric = true;
    shape->quadric =
        (struct csg_quadric){.diag = {1, 1, 1, -1}, .to_canon = csg_map_scaling(csg_vec3(s, s, s))};
    shape->convex = true;
    shape->bounds = (struct csg_box){{-radius, -radius, -radius}, {radius, radius, radius}};
}

static enum csg_read_result read(const struct csg_args *args, struct csg_shape *shape)
{
    const struct csg_facets facets = csg_args_round_facets(args);
    const double radius = csg_args_radius(args, "r", "d", 1, &shape->rounding);
    if (!(radius > 0) || !isfinite(radius) || !isfinite(1 / radius))
        return CSG_READ_EMPTY;
    const int n = csg_facets_count(&facets, radius);
    const struct globe globe = {radius, n / 2 + n % 2};
    shape->written = globe_box(&globe, n);
    if (!csg_facets_wanted(args, &facets)) {
        fill_quadric(shape, radius);
        shape->sagitta = 2 * csg_facets_sagitta(n, radius); /* its quads are bent both ways */
        return CSG_READ_OK;
    }
    shape->bounds = shape->written;
    return csg_rings_fill(shape, args, ring, &globe, globe.num_rings, n) ? CSG_READ_OK
                                                                         : CSG_READ_ERROR;
}

const struct csg_solid_ops csg_solid_sphere = {
    .name = "sphere",
    .parameters = "r d",
    .read = read,
};
