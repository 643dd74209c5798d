/* SPDX-License-Identifier: MIT */
/*
 * linear_extrude(height, v, center, twist, scale, ...) as OpenSCAD 2021.01 and 2025 write it.
 */
#include <limits.h>

#include "nodes/compounds.h"
#include "nodes/drawings.h"
#include "nodes/import.h"
#include "nodes/polyhedron.h"
#include "plane/extrude.h"
#include "plane/outline.h"
#include "plane/twist.h"

/* What OpenSCAD takes where height is missing. */
#define DEFAULT_HEIGHT 100.0

struct extrusion {
    double height, rounding; /* along v */
    double v[3];             /* from the bottom to the top */
    double scale[2];         /* of the top */
    double twist;
    int slices; /* 0: not given */
    struct csg_facets facets;
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
        else if (csg_nearly(to->scale[i], 1))
            to->scale[i] = 1;
    if (csg_nearly(to->scale[0], to->scale[1]))
        to->scale[1] = to->scale[0];
}

static void read_extrusion(const struct csg_args *args, struct extrusion *to)
{
    const struct csg_value *file = csg_args_find(args, "file");
    read_height(args, to);
    read_scale(args, to);
    const double slices = csg_args_number(args, "slices", 0, NULL);
    to->twist = csg_args_number(args, "twist", 0, NULL);
    if (!isfinite(to->twist) || csg_nearly(360, 360 + to->twist))
        to->twist = 0;
    to->slices = slices >= 1 && slices < INT_MAX ? (int)slices : 0;
    to->facets = csg_args_facets(args);
    to->center = csg_args_bool(args, "center");
    to->has_file = file && file->type == CSG_VALUE_STRING && file->num > 0;
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

/* What stays exact: the section is only scaled, the same along x and y. */
static bool extrude(struct csg_walk *walk, const struct extrusion *extrusion, bool in_boolean,
                    const struct csg_drawing *drawing, const double z[2], struct csg_part *part)
{
    const struct csg_lift lift = {.z0 = z[0], .s0 = 1, .z1 = z[1], .s1 = extrusion->scale[0]};
    bool too_large = false;
    if (csg_extrude(part, drawing, &lift, csg_walk_max_pieces(walk, in_boolean), &too_large))
        return true;
    part->is_too_large |= too_large;
    return too_large || csg_walk_no_memory(walk);
}

static bool refuse_twist(struct csg_walk *walk, uint32_t node, const struct csg_twist *twist,
                         const struct csg_drawing *drawing)
{
    const double num = csg_twist_num_faces(twist, drawing);
    const bool is_refused = num > CSG_TWIST_MAX_FACES;
    if (is_refused)
        csg_walk_refuse(walk, node,
                        "linear_extrude: its slices have %.3g faces, the most is %d; fewer slices "
                        "(slices, $fn, $fa, $fs, twist) or corners make less",
                        num, CSG_TWIST_MAX_FACES);
    return is_refused;
}

/* OpenSCAD's mesh, also of circles. */
static bool twist(struct csg_walk *walk, uint32_t node, const struct extrusion *extrusion,
                  struct csg_drawing *drawing, const double z[2], struct csg_part *part)
{
    const struct csg_twist twist = {.z0 = z[0],
                                    .z1 = z[1],
                                    .degrees = extrusion->twist,
                                    .scale = {extrusion->scale[0], extrusion->scale[1]},
                                    .slices = extrusion->slices,
                                    .facets = extrusion->facets};
    struct csg_mesh mesh = {0};
    const uint32_t num = (uint32_t)drawing->nodes.num;
    const bool facetted = extrusion->twist != 0 || csg_drawing_is_facetted(drawing, 0, num);
    mesh.rounding = csg_drawing_rounding(drawing, 0, num) *
                    fmax(1, fmax(extrusion->scale[0], extrusion->scale[1]));
    enum csg_sweep_result result = csg_drawing_evaluate(drawing, 0);
    if (result == CSG_SWEEP_DONE && refuse_twist(walk, node, &twist, drawing))
        return true;
    if (result == CSG_SWEEP_DONE)
        result = csg_twist_fill(&mesh, drawing, &twist);
    part->is_too_large |= result == CSG_SWEEP_TOO_LARGE;
    const bool ok = result == CSG_SWEEP_DONE
                        ? csg_polyhedron_add(walk, node, true, &mesh, part)
                        : result == CSG_SWEEP_TOO_LARGE || csg_walk_no_memory(walk);
    for (size_t i = 0; i < part->shapes.num; i++)
        part->shapes.data[i].facetted |= facetted;
    csg_mesh_finish(&mesh);
    return ok;
}

bool csg_compound_linear_extrude(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                                 bool in_boolean, struct csg_part *part)
{
    struct extrusion extrusion = {0};
    struct csg_drawing drawing = {0};
    read_extrusion(args, &extrusion);
    const double top = extrusion.v[2];
    const double z[2] = {extrusion.center ? -top / 2 : 0, extrusion.center ? top / 2 : top};
    if (!isfinite(extrusion.v[0] + extrusion.v[1] + top) || !(top > 0))
        return true;
    const bool is_even = extrusion.twist == 0 && extrusion.scale[0] == extrusion.scale[1];
    const bool ok =
        (extrusion.has_file ? csg_import_drawing(walk, node, args, extrusion.scale[0], &drawing)
                            : csg_drawing_read(walk, node, in_boolean, &drawing)) &&
        (is_even ? extrude(walk, &extrusion, in_boolean, &drawing, z, part)
                 : twist(walk, node, &extrusion, &drawing, z, part));
    for (size_t i = 0; i < part->shapes.num; i++)
        part->shapes.data[i].rounding += extrusion.rounding;
    lean(part, &extrusion);
    csg_drawing_finish(&drawing);
    return ok;
}
