/* SPDX-License-Identifier: MIT */
/*
 * halfspace(normal = [0, 0, 1], offset = 0) or halfspace(normal, point = [x, y, z]): everything
 * behind the plane that normal points out of. One plane, no quadric, unbounded.
 */
#include "solids/halfspace/halfspace.h"

#include "solids/checked.h"
#include "solids/solid.h"

/* The plane bounds the axis that it is square to. */
static void bound_axis(double normal, double offset, double *lo, double *hi)
{
    if (normal > 0)
        *hi = offset / normal;
    else
        *lo = offset / normal;
}

bool csg_halfspace_fill(struct csg_shape *shape, struct csg_vec3 normal, double offset)
{
    struct csg_box *bounds = &shape->bounds;
    if (!csg_shape_add_plane(shape, normal, offset))
        return false;
    const struct csg_plane *plane = &shape->planes[shape->num_planes - 1];
    const struct csg_vec3 n = plane->normal;
    shape->convex = true;
    *bounds = csg_box_all;
    if (n.y == 0 && n.z == 0)
        bound_axis(n.x, plane->offset, &bounds->lo.x, &bounds->hi.x);
    else if (n.x == 0 && n.z == 0)
        bound_axis(n.y, plane->offset, &bounds->lo.y, &bounds->hi.y);
    else if (n.x == 0 && n.y == 0)
        bound_axis(n.z, plane->offset, &bounds->lo.z, &bounds->hi.z);
    shape->written = *bounds;
    return true;
}

static enum csg_read_result read(const struct csg_args *args, struct csg_shape *shape)
{
    double n[3] = {0, 0, 1}, point[3] = {0, 0, 0}, offset = 0, turn = 0;
    if (!csg_checked_vector(args, "normal", 3, n, &turn) ||
        !csg_checked_number(args, "offset", &offset, &shape->rounding) ||
        !csg_checked_vector(args, "point", 3, point, &shape->rounding))
        return CSG_READ_ERROR;
    const double size = fmax(fabs(n[0]), fmax(fabs(n[1]), fabs(n[2])));
    if (!(size > 0))
        return csg_args_error(args, "normal must not be zero"), CSG_READ_ERROR;
    if (csg_args_find(args, "offset") && csg_args_find(args, "point"))
        return csg_args_error(args, "offset and point exclude each other"), CSG_READ_ERROR;
    const struct csg_vec3 unit = csg_normalize(csg_vec3(n[0] / size, n[1] / size, n[2] / size));
    const double along = csg_dot(unit, csg_vec3_of(point));
    shape->rounding += turn / size * fabs(offset + along);
    if (!csg_halfspace_fill(shape, unit, offset + along))
        return csg_log_memory(args->log), CSG_READ_ERROR;
    return CSG_READ_OK;
}

const struct csg_solid_ops csg_solid_halfspace = {
    .name = "halfspace",
    .parameters = "normal offset point",
    .read = read,
};
