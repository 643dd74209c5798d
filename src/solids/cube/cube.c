/* SPDX-License-Identifier: MIT */
/* cube(size = [x, y, z], center = false), as in OpenSCAD. Six planes, no quadric. */
#include "solids/solid.h"

/* One number for all sides, or three. OpenSCAD keeps what it can convert: the sides of [5, "a", 3]
 * are 5, 1, 1. */
static void read_size(const struct csg_args *args, double size[3], double *rounding)
{
    const struct csg_value *value = csg_args_find(args, "size");
    size[0] = size[1] = size[2] = csg_args_number(args, "size", 1, rounding);
    if (!value || value->type != CSG_VALUE_VECTOR || value->num != 3)
        return;
    for (int i = 0; i < 3 && value->items[i].type == CSG_VALUE_NUMBER; i++) {
        size[i] = value->items[i].number;
        *rounding = fmax(*rounding, (double)value->items[i].rounding);
    }
}

static bool add_faces(struct csg_shape *shape, const double lo[3], const double hi[3])
{
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 normal = csg_vec3(i == 0, i == 1, i == 2);
        if (!csg_shape_add_plane(shape, csg_scale(-1, normal), -lo[i]) ||
            !csg_shape_add_plane(shape, normal, hi[i]))
            return false;
    }
    return true;
}

static enum csg_read_result read(const struct csg_args *args, struct csg_shape *shape)
{
    double size[3], lo[3], hi[3];
    read_size(args, size, &shape->rounding);
    const bool center = csg_args_bool(args, "center");
    for (int i = 0; i < 3; i++) {
        if (!(size[i] > 0) || !isfinite(size[i]))
            return CSG_READ_EMPTY;
        lo[i] = center ? -size[i] / 2 : 0;
        hi[i] = center ? size[i] / 2 : size[i];
    }
    if (!add_faces(shape, lo, hi))
        return csg_log_memory(args->log), CSG_READ_ERROR;
    shape->convex = true;
    shape->bounds = (struct csg_box){{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
    shape->written = shape->bounds;
    return CSG_READ_OK;
}

const struct csg_solid_ops csg_solid_cube = {
    .name = "cube",
    .parameters = "size center",
    .read = read,
};
