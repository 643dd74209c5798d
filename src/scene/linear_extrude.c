/* SPDX-License-Identifier: MIT */
/*
 * linear_extrude(height, v, center, twist, scale, ...) as OpenSCAD 2021.01 and 2025 write it.
 */
#include "plane/extrude.h"
#include "scene/compounds.h"
#include "scene/drawings.h"

/* What OpenSCAD takes where height is missing. */
#define DEFAULT_HEIGHT 100.0

struct extrusion {
    double height, rounding; /* along v */
    double v[3];             /* from the bottom to the top */
    double scale[2];         /* of the top */
    double twist;
    bool center;
    bool has_file;
};

/* A height of 0 or less is none; v alone gives direction and length, height the length. */
static void read_height(const struct csg_args *args, struct extrusion *to)
{
    const struct csg_value *v = csg_args_find(args, "v");
    const struct csg_value *height = csg_args_find(args, "height");
    if (!height)
        height = csg_args_find(args, "h");
    const bool has_height = height && height->type == CSG_VALUE_NUMBER && isfinite(height->number);
    to->height = DEFAULT_HEIGHT;
    if (has_height) {
        to->height = height->number;
        to->rounding = (double)height->rounding;
    }
    to->v[0] = to->v[1] = 0;
    to->v[2] = to->height;
    double given[3];
    if (!csg_value_numbers(v, 3, given, NULL))
        return;
    const double length = sqrt(given[0] * given[0] + given[1] * given[1] + given[2] * given[2]);
    for (int i = 0; i < 3; i++)
        to->v[i] = has_height ? given[i] / length * to->height : given[i];
}

static void read_scale(const struct csg_args *args, struct extrusion *to)
{
    const struct csg_value *scale = csg_args_find(args, "scale");
    to->scale[0] = to->scale[1] = 1;
    if (scale && scale->type == CSG_VALUE_NUMBER && isfinite(scale->number))
        to->scale[0] = to->scale[1] = scale->number;
    else
        csg_value_numbers(scale, 2, to->scale, NULL);
    for (int i = 0; i < 2; i++)
        if (!(to->scale[i] > 0) || !isfinite(to->scale[i]))
            to->scale[i] = 0;
}

static void read_extrusion(const struct csg_args *args, struct extrusion *to)
{
    const struct csg_value *file = csg_args_find(args, "file");
    read_height(args, to);
    read_scale(args, to);
    to->twist = csg_args_number(args, "twist", 0, NULL);
    to->center = csg_args_bool(args, "center", false);
    to->has_file = file && file->type == CSG_VALUE_STRING && file->num > 0;
}

/* true: a message was given. */
static bool is_unsupported(struct csg_walk *walk, uint32_t node, const struct extrusion *extrusion)
{
    const bool twisted = extrusion->twist != 0 && isfinite(extrusion->twist);
    const bool uneven = extrusion->scale[0] != extrusion->scale[1];
    if (twisted)
        csg_walk_unsupported(walk, node, "linear_extrude with twist is not supported yet");
    else if (uneven)
        csg_walk_unsupported(walk, node,
                             "linear_extrude with different scales along x and y is "
                             "not supported yet");
    else if (extrusion->has_file)
        csg_walk_unsupported(walk, node, "linear_extrude of a file is not supported yet");
    return twisted || uneven || extrusion->has_file;
}

/* The extrusion leans when v does: z stays, x and y move along. */
static bool lean(struct csg_part *part, const struct extrusion *extrusion)
{
    struct csg_map map = csg_map_identity;
    map.m[0][2] = extrusion->v[0] / extrusion->v[2];
    map.m[1][2] = extrusion->v[1] / extrusion->v[2];
    bool ok = true;
    for (size_t i = 0; i < part->shapes.num && (map.m[0][2] != 0 || map.m[1][2] != 0); i++)
        ok = csg_shape_map(&part->shapes.data[i], &map) && ok;
    return ok;
}

bool csg_compound_linear_extrude(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                                 bool in_boolean, struct csg_part *part)
{
    struct extrusion extrusion = {0};
    struct csg_drawing drawing = {0};
    bool too_large = false;
    read_extrusion(args, &extrusion);
    const double top = extrusion.v[2];
    if (!isfinite(extrusion.v[0] + extrusion.v[1] + top) || !(top > 0) ||
        is_unsupported(walk, node, &extrusion))
        return true;
    bool ok = csg_drawing_read(walk, node, in_boolean, &drawing);
    const struct csg_lift lift = {.z0 = extrusion.center ? -top / 2 : 0,
                                  .s0 = 1,
                                  .z1 = extrusion.center ? top / 2 : top,
                                  .s1 = extrusion.scale[0]};
    if (ok && !csg_extrude(part, &drawing, &lift, &too_large))
        ok = too_large || csg_log_memory(&walk->builder->report->log);
    part->is_too_large |= too_large;
    for (size_t i = 0; i < part->shapes.num; i++)
        part->shapes.data[i].rounding += extrusion.rounding;
    lean(part, &extrusion);
    csg_drawing_finish(&drawing);
    return ok;
}
