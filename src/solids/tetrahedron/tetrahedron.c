/* SPDX-License-Identifier: MIT */
/* tetrahedron(points = [p0, p1, p2, p3]), in any orientation. Four planes, no quadric. */
#include <float.h>

#include "solids/solid.h"

/* A tetrahedron is flat when its volume, relative to the product of its three edges from a corner,
 * is what rounding makes of zero. */
#define FLAT (64 * DBL_EPSILON)

static bool read_points(const struct csg_args *args, struct csg_vec3 points[4], double *rounding)
{
    const struct csg_value *value = csg_args_find(args, "points");
    bool ok = value && value->type == CSG_VALUE_VECTOR && value->num == 4;
    for (size_t i = 0; ok && i < 4; i++) {
        double p[3], own_rounding = 0;
        ok = csg_value_numbers(&value->items[i], 3, p, &own_rounding) && isfinite(p[0]) &&
             isfinite(p[1]) && isfinite(p[2]);
        if (ok)
            points[i] = csg_vec3_of(p);
        *rounding = fmax(*rounding, own_rounding);
    }
    if (!ok)
        csg_args_error(args, "points must be four points [x, y, z] with finite coordinates");
    return ok;
}

static bool is_flat(const struct csg_vec3 points[4])
{
    struct csg_vec3 edges[3];
    for (int i = 0; i < 3; i++)
        edges[i] = csg_normalize(csg_sub(points[i + 1], points[0]));
    return !(fabs(csg_dot(edges[0], csg_cross(edges[1], edges[2]))) > FLAT);
}

/* The face opposite to points[i]. */
static bool add_face(struct csg_shape *shape, const struct csg_vec3 points[4], int i)
{
    const struct csg_vec3 a = points[(i + 1) & 3], b = points[(i + 2) & 3], c = points[(i + 3) & 3];
    const struct csg_vec3 across =
        csg_cross(csg_normalize(csg_sub(b, a)), csg_normalize(csg_sub(c, a)));
    const struct csg_vec3 unit = csg_normalize(across);
    const double side = csg_dot(unit, csg_sub(points[i], a)) > 0 ? -1 : 1;
    const struct csg_vec3 normal = csg_scale(side, unit);
    return csg_shape_add_plane(shape, normal, csg_dot(normal, a));
}

static enum csg_read_result read(const struct csg_args *args, struct csg_shape *shape)
{
    struct csg_vec3 points[4];
    if (!read_points(args, points, &shape->rounding))
        return CSG_READ_ERROR;
    if (is_flat(points))
        return csg_args_error(args, "the four points lie in one plane"), CSG_READ_ERROR;
    shape->convex = true;
    shape->bounds = csg_box_empty;
    for (int i = 0; i < 4; i++) {
        csg_box_extend(&shape->bounds, points[i]);
        if (!add_face(shape, points, i))
            return csg_log_memory(args->log), CSG_READ_ERROR;
    }
    shape->written = shape->bounds;
    return CSG_READ_OK;
}

const struct csg_solid_ops csg_solid_tetrahedron = {
    .name = "tetrahedron",
    .parameters = "points",
    .read = read,
};
