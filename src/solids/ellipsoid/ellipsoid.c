/* SPDX-License-Identifier: MIT */
/* ellipsoid(r = [rx, ry, rz]) or ellipsoid(d = ...), about the origin. Canonical: unit sphere. */
#include "solids/checked.h"
#include "solids/solid.h"

static bool read_radii(const struct csg_args *args, double radii[3], double *rounding)
{
    if (!csg_args_find(args, "d"))
        return csg_checked_lengths(args, "r", 3, radii, rounding);
    if (!csg_checked_lengths(args, "d", 3, radii, rounding))
        return false;
    for (int i = 0; i < 3; i++)
        radii[i] /= 2;
    return true;
}

static enum csg_read_result read(const struct csg_args *args, struct csg_shape *shape)
{
    double r[3] = {1, 1, 1};
    if (!read_radii(args, r, &shape->rounding))
        return CSG_READ_ERROR;
    shape->has_quadric = true;
    shape->quadric = (struct csg_quadric){
        .diag = {1, 1, 1, -1}, .to_canon = csg_map_scaling(csg_vec3(1 / r[0], 1 / r[1], 1 / r[2]))};
    shape->convex = true;
    shape->bounds = (struct csg_box){{-r[0], -r[1], -r[2]}, {r[0], r[1], r[2]}};
    shape->written = shape->bounds;
    return CSG_READ_OK;
}

const struct csg_solid_ops csg_solid_ellipsoid = {
    .name = "ellipsoid",
    .parameters = "r d",
    .read = read,
};
