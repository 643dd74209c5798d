/* SPDX-License-Identifier: MIT */
#include "solids/rings.h"

#include <stdlib.h>

#include "solids/facets.h"

static const struct csg_value *find_number(const struct csg_args *args, const char *name)
{
    const struct csg_value *value = csg_args_find(args, name);
    return value && value->type == CSG_VALUE_NUMBER ? value : NULL;
}

double csg_args_radius(const struct csg_args *args, const char *r, const char *d, double fallback,
                       double *rounding)
{
    const struct csg_value *diameter = find_number(args, d);
    const struct csg_value *radius = diameter ? diameter : find_number(args, r);
    if (!radius)
        return fallback;
    *rounding = (double)radius->rounding / (diameter ? 2 : 1);
    return radius->number / (diameter ? 2 : 1);
}

static struct csg_vec3 corner(struct csg_ring ring, int i, int n)
{
    const double degrees = 360.0 * i / n;
    return csg_vec3(ring.radius * csg_cos_degrees(degrees), ring.radius * csg_sin_degrees(degrees),
                    ring.z);
}

/* The corners that reach furthest along +-x and +-y are next to a multiple of a quarter turn. */
struct csg_box csg_ring_box(struct csg_ring ring, int n)
{
    struct csg_box box = csg_box_empty;
    for (int quarter = 0; quarter < 4; quarter++) {
        const int i = (int)((long long)quarter * n / 4);
        csg_box_extend(&box, corner(ring, i, n));
        csg_box_extend(&box, corner(ring, i + 1, n));
    }
    return box;
}

static bool add_cap(struct csg_shape *shape, struct csg_ring ring, double side)
{
    return ring.radius <= 0 || csg_shape_add_plane(shape, csg_vec3(0, 0, side), side * ring.z);
}

/*
 * The facet through corners i and i + 1 of both rings: its normal is across the edge between these
 * corners and the slant from ring to ring. All lengths are divided by size before they are
 * multiplied, which neither overflows nor underflows then.
 */
static bool add_facet(struct csg_shape *shape, struct csg_ring low, struct csg_ring high, int i,
                      int n)
{
    const double size = fmax(fmax(low.radius, high.radius), high.z - low.z);
    const struct csg_ring unit = {1, 0};
    const struct csg_vec3 from = corner(unit, i, n), to = corner(unit, i + 1, n);
    const double rise = (high.radius - low.radius) / size;
    const struct csg_vec3 slant = csg_vec3(rise * from.x, rise * from.y, (high.z - low.z) / size);
    const struct csg_vec3 normal = csg_normalize(csg_cross(csg_sub(to, from), slant));
    const struct csg_ring wide = low.radius > high.radius ? low : high;
    const struct csg_vec3 ends = csg_add(corner(wide, i, n), corner(wide, i + 1, n));
    return csg_shape_add_plane(shape, normal, csg_dot(normal, csg_scale(0.5, ends)));
}

bool csg_rings_fill(struct csg_shape *shape, const struct csg_args *args, csg_ring_fn *ring,
                    const void *user, int num, int n)
{
    if (((double)num - 1) * n > CSG_RINGS_MAX_PLANES) {
        csg_args_error(args, "%d fragments make more than %d facets; use --facets=exact", n,
                       CSG_RINGS_MAX_PLANES);
        return false;
    }
    bool ok = add_cap(shape, ring(user, 0), -1) && add_cap(shape, ring(user, num - 1), 1);
    for (int band = 0; band + 1 < num; band++)
        for (int i = 0; i < n && ok; i++)
            ok = add_facet(shape, ring(user, band), ring(user, band + 1), i, n);
    shape->convex = true;
    shape->facetted = true;
    return ok || csg_log_memory(args->log);
}
