/* SPDX-License-Identifier: MIT */
#include "nodes/figures.h"

#include "nodes/transforms.h"
#include "solids/facets.h"
#include "solids/rings.h"

/* Circles with more facets are refused: nobody can tell them from the true circle. */
enum { max_fragments = 65536 };

static bool finish(const struct csg_args *args, bool ok)
{
    return ok || csg_log_memory(args->log);
}

static bool add_empty(const struct csg_args *args, struct csg_drawing *drawing)
{
    return finish(args, csg_drawing_open(drawing, CSG_DRAW_UNION));
}

static void warn(const struct csg_args *args, const struct csg_value *at, const char *text)
{
    csg_log_warning(args->log, CSGCAST_MESSAGE_SCENE, "%s:%u:%u: %s: %s", args->file,
                    (unsigned)(at ? at->line : args->line),
                    (unsigned)(at ? at->column : args->column), args->node, text);
}

/* Whether the part of the map that acts in the plane, OpenSCAD ignores the rest, leaves something
 * of a figure. */
static bool is_regular(const struct csg_args *args, const struct csg_space *space)
{
    struct csg_map inverse;
    if (!space->is_empty && csg_map_invert(&space->map, &inverse))
        return true;
    if (!space->is_empty)
        warn(args, NULL, "a matrix around it leaves nothing of it in its plane");
    return false;
}

static bool add_mapped(struct csg_drawing *drawing, const struct csg_space *space, double x,
                       double y)
{
    const struct csg_vec3 p = csg_map_point(&space->map, csg_vec3(x, y, 0));
    return csg_drawing_add_point(drawing, p.x, p.y);
}

static double space_rounding(const struct csg_space *space, double rounding,
                             const struct csg_box *box)
{
    return rounding * csg_space_stretch(space) + csg_space_rounding(space, box);
}

/* ---- square ------------------------------------------------------------------------------- */

bool csg_figure_square(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       const struct csg_space *space, struct csg_drawing *drawing)
{
    (void)walk, (void)node;
    const struct csg_value *value = csg_args_find(args, "size");
    double size[2] = {1, 1}, rounding = 0;
    if (value && value->type == CSG_VALUE_NUMBER) {
        size[0] = size[1] = value->number;
        rounding = (double)value->rounding;
    } else {
        csg_value_numbers(value, 2, size, &rounding);
    }
    if (!(size[0] > 0) || !(size[1] > 0) || !isfinite(size[0]) || !isfinite(size[1]) ||
        !is_regular(args, space))
        return add_empty(args, drawing);
    const bool center = csg_args_bool(args, "center");
    const struct csg_vec2 lo = {center ? -size[0] / 2 : 0, center ? -size[1] / 2 : 0};
    const struct csg_vec2 hi = {center ? size[0] / 2 : size[0], center ? size[1] / 2 : size[1]};
    const struct csg_box box = {{lo.x, lo.y, 0}, {hi.x, hi.y, 0}};
    return finish(
        args, csg_drawing_add_figure(drawing, space_rounding(space, rounding, &box)) &&
                  csg_drawing_add_contour(drawing) && add_mapped(drawing, space, lo.x, lo.y) &&
                  add_mapped(drawing, space, hi.x, lo.y) &&
                  add_mapped(drawing, space, hi.x, hi.y) && add_mapped(drawing, space, lo.x, hi.y));
}

/* ---- circle ------------------------------------------------------------------------------- */

static bool add_circle(struct csg_drawing *drawing, const struct csg_space *space, double r, int n)
{
    bool ok = csg_drawing_add_contour(drawing);
    for (int i = 0; i < n && ok; i++) {
        const double degrees = 360.0 * i / n;
        ok = add_mapped(drawing, space, r * csg_cos_degrees(degrees), r * csg_sin_degrees(degrees));
    }
    return ok;
}

bool csg_figure_circle(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       const struct csg_space *space, struct csg_drawing *drawing)
{
    (void)walk, (void)node;
    const struct csg_facets facets = csg_args_round_facets(args);
    const bool facetted = csg_facets_wanted(args, &facets);
    double rounding = 0;
    const double r = csg_args_radius(args, "r", "d", 1, &rounding);
    const struct csg_box box = {{-r, -r, 0}, {r, r, 0}};
    const struct csg_map scaling = csg_map_scaling(csg_vec3(r, r, 1));
    if (!(r > 0) || !isfinite(r) || !is_regular(args, space))
        return add_empty(args, drawing);
    const int n = csg_facets_count(&facets, r);
    if (!finish(args, csg_drawing_add_figure(drawing, space_rounding(space, rounding, &box)) &&
                          add_circle(drawing, space, r, n < max_fragments ? n : max_fragments)))
        return false;
    struct csg_figure *figure = &drawing->figures.data[drawing->figures.num - 1];
    figure->is_disc = !facetted;
    figure->facetted = facetted;
    figure->disc = csg_map_multiply(&space->map, &scaling);
    return true;
}

/* ---- polygon ------------------------------------------------------------------------------ */

/* OpenSCAD draws nothing when a point is wrong. */
static bool check_points(const struct csg_args *args, const struct csg_value *points,
                         double *rounding, struct csg_box *box)
{
    if (!points || points->type != CSG_VALUE_VECTOR) {
        warn(args, points, "points must be a vector of points; the polygon is empty");
        return false;
    }
    for (size_t i = 0; i < points->num; i++) {
        double p[2], point_rounding = 0;
        if (!csg_value_numbers(&points->items[i], 2, p, &point_rounding) || !isfinite(p[0]) ||
            !isfinite(p[1])) {
            warn(args, &points->items[i],
                 "a point must be [x, y] with finite numbers; the polygon is empty");
            return false;
        }
        *rounding = fmax(*rounding, point_rounding);
        csg_box_extend(box, csg_vec3(p[0], p[1], 0));
    }
    return points->num >= 3;
}

static bool add_vertex(struct csg_drawing *drawing, const struct csg_space *space,
                       const struct csg_value *point)
{
    return add_mapped(drawing, space, point->items[0].number, point->items[1].number);
}

/* One path of indices into the points; without a path all points. Indices that no point has are
 * left out, as in OpenSCAD. */
static bool add_path(const struct csg_args *args, struct csg_drawing *drawing,
                     const struct csg_space *space, const struct csg_value *points,
                     const struct csg_value *path)
{
    const size_t num = path ? path->num : points->num;
    bool ok = csg_drawing_add_contour(drawing);
    for (size_t i = 0; i < num && ok; i++) {
        const struct csg_value *index = path ? &path->items[i] : NULL;
        if (!path)
            ok = add_vertex(drawing, space, &points->items[i]);
        else if (index->type == CSG_VALUE_NUMBER && index->number >= 0 &&
                 index->number < (double)points->num)
            ok = add_vertex(drawing, space, &points->items[(size_t)index->number]);
        else
            warn(args, index, "a path has an index that no point has; it is left out");
    }
    return ok;
}

/* paths: undef or a vector of paths. What is no vector is a path of no points, as in OpenSCAD. */
static bool add_paths(const struct csg_args *args, struct csg_drawing *drawing,
                      const struct csg_space *space, const struct csg_value *points)
{
    const struct csg_value *paths = csg_args_find(args, "paths");
    bool ok = true;
    if (!paths || paths->type != CSG_VALUE_VECTOR || paths->num == 0)
        return add_path(args, drawing, space, points, NULL);
    for (size_t i = 0; i < paths->num && ok; i++)
        if (paths->items[i].type == CSG_VALUE_VECTOR)
            ok = add_path(args, drawing, space, points, &paths->items[i]);
        else
            warn(args, &paths->items[i], "a path must be a vector of indices; it is left out");
    return ok;
}

bool csg_figure_polygon(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                        const struct csg_space *space, struct csg_drawing *drawing)
{
    (void)walk, (void)node;
    const struct csg_value *points = csg_args_find(args, "points");
    struct csg_box box = csg_box_empty;
    double rounding = 0;
    if (!check_points(args, points, &rounding, &box) || !is_regular(args, space))
        return add_empty(args, drawing);
    return finish(args, csg_drawing_add_figure(drawing, space_rounding(space, rounding, &box)) &&
                            add_paths(args, drawing, space, points));
}
