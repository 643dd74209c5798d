/* SPDX-License-Identifier: MIT */
#include "plane/twist.h"

#include <stdlib.h>

#include "plane/triangulate.h"

/* As OpenSCAD's, so that the slices are the same: GRID_FINE of its grid.h. */
#define GRID_FINE 0x1p-20

/* Diagonals whose lengths differ by less than this share of their mean are equal to OpenSCAD. */
#define SAME_LENGTH 1e-5

/* Sides that turn by less between two levels are not folded: no two directions are opposite. */
#define MAX_STEP_DEGREES 90.0

#define PI 3.14159265358979323846264338327950288

/* Where one slice begins or ends. */
struct level {
    double z, cos, sin, scale[2];
};

static struct csg_vec2 level_point(const struct level *level, struct csg_vec2 p)
{
    return (struct csg_vec2){level->scale[0] * (level->cos * p.x - level->sin * p.y),
                             level->scale[1] * (level->sin * p.x + level->cos * p.y)};
}

static struct level make_level(const struct csg_twist *twist, int i, int num)
{
    const double degrees = -twist->degrees * i / num;
    return (struct level){
        .z = twist->z0 + (twist->z1 - twist->z0) * i / num,
        .cos = csg_cos_degrees(degrees),
        .sin = csg_sin_degrees(degrees),
        .scale = {1 - (1 - twist->scale[0]) * i / num, 1 - (1 - twist->scale[1]) * i / num}};
}

/* ---- slices: Calc of OpenSCAD 2021.01 ----------------------------------------------------- */

/* The length of a helix, https://mathworld.wolfram.com/Helix.html */
static double helix_length(double radius, double height, double radians)
{
    return radians * hypot(radius, height / radians);
}

/* The length of an Archimedean spiral, https://mathworld.wolfram.com/ArchimedesSpiral.html */
static double spiral_length(double a, double angle)
{
    return 0.5 * a * (angle * sqrt(1 + angle * angle) + asinh(angle));
}

/* On a cone the helix is seen from above as a section of a spiral that ends in its apex. */
static double conical_length(double radius, double height, double radians, double scale)
{
    const double end = scale > 1 ? radians * scale / (scale - 1) : radians / (1 - scale);
    const double a = radius / end;
    return hypot(spiral_length(a, end) - spiral_length(a, end - radians), height);
}

static double count_twisted(const struct csg_twist *twist, double radius)
{
    const struct csg_facets *facets = &twist->facets;
    const double degrees = fabs(twist->degrees), radians = degrees * (PI / 180);
    const double height = twist->z1 - twist->z0;
    const double least = fmax(ceil(degrees / 120), 1);
    if (radius < GRID_FINE || !isfinite(facets->fn))
        return least;
    if (facets->fn > 0)
        return fmax(ceil(degrees / 360 * facets->fn), least);
    const bool is_conical = twist->scale[0] == twist->scale[1] && twist->scale[0] != 1;
    const double length = is_conical ? conical_length(radius, height, radians, twist->scale[0])
                                     : helix_length(radius, height, radians);
    return fmax(fmin(ceil(degrees / facets->fa), ceil(length / facets->fs)), least);
}

/* Without twist the longest way of a point from the bottom to the top decides. */
static double count_straight(const struct csg_twist *twist, double longest)
{
    const struct csg_facets *facets = &twist->facets;
    if (longest < GRID_FINE || !isfinite(facets->fn))
        return 1;
    if (facets->fn > 0)
        return fmax(floor(facets->fn), 1);
    return fmax(ceil(hypot(longest, twist->z1 - twist->z0) / facets->fs), 1);
}

static double count_slices(const struct csg_twist *twist, const struct csg_drawing *drawing,
                           const struct csg_figure *figure)
{
    double radius = 0, longest = 0;
    if (twist->slices > 0)
        return twist->slices;
    for (uint32_t i = figure->begin; i < figure->end; i++)
        for (uint32_t j = drawing->contours.data[i].begin; j < drawing->contours.data[i].end; j++) {
            const struct csg_vec2 p = drawing->points.data[j];
            radius = fmax(radius, hypot(p.x, p.y));
            longest =
                fmax(longest, hypot(p.x - p.x * twist->scale[0], p.y - p.y * twist->scale[1]));
        }
    return twist->degrees != 0 ? count_twisted(twist, radius) : count_straight(twist, longest);
}

/* ---- sides -------------------------------------------------------------------------------- */

static bool add_triangle(struct csg_mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    return csg_array_push(&mesh->corners, a) && csg_array_push(&mesh->corners, b) &&
           csg_array_push(&mesh->corners, c) && csg_mesh_close_face(mesh);
}

/* -1 where a is the shorter one, 0 where they are equal. */
static int compare_lengths(struct csg_vec3 a, struct csg_vec3 b)
{
    const double x = hypot(a.x, a.y), y = hypot(b.x, b.y);
    if (2 * fabs(x - y) <= SAME_LENGTH * (x + y))
        return 0;
    return x < y ? -1 : 1;
}

struct side {
    uint32_t low[2], high[2];
    bool flip;       /* which diagonal where both are equal */
    bool is_pointed; /* the top has no area */
};

/* Along the shorter diagonal, as seen from above; at a top without area along the other one. */
static bool add_side(struct csg_mesh *mesh, const struct side *side)
{
    const struct csg_vec3 *p = mesh->points.data;
    const int order = compare_lengths(csg_sub(p[side->low[0]], p[side->high[1]]),
                                      csg_sub(p[side->low[1]], p[side->high[0]]));
    const bool first = order < 0 || (order == 0 && !side->flip);
    if (first != side->is_pointed)
        return add_triangle(mesh, side->low[0], side->low[1], side->high[1]) &&
               add_triangle(mesh, side->high[1], side->high[0], side->low[0]);
    return add_triangle(mesh, side->low[0], side->low[1], side->high[0]) &&
           add_triangle(mesh, side->low[1], side->high[1], side->high[0]);
}

/* The points of a slice lie at low and high, in the order of the drawing's from begin on. */
static bool add_slice(struct csg_mesh *mesh, const struct csg_drawing *drawing,
                      const struct csg_twist *twist, uint32_t begin, uint32_t low, uint32_t high,
                      bool is_pointed)
{
    const struct csg_figure *figure = &drawing->figures.data[drawing->figures.num - 1];
    bool ok = true;
    for (uint32_t i = figure->begin; i < figure->end; i++) {
        const struct csg_contour *contour = &drawing->contours.data[i];
        const bool is_hole = csg_contour_twice_area(drawing, contour) < 0;
        for (uint32_t j = contour->begin; j < contour->end && ok; j++) {
            const uint32_t a = j - begin;
            const uint32_t b = (j + 1 < contour->end ? j + 1 : contour->begin) - begin;
            const struct side side = {.low = {low + a, low + b},
                                      .high = {high + a, high + b},
                                      .flip = is_hole != (twist->degrees <= 0),
                                      .is_pointed = is_pointed};
            ok = add_side(mesh, &side);
        }
    }
    return ok;
}

/* ---- the mesh ----------------------------------------------------------------------------- */

static bool add_points(struct csg_mesh *mesh, const struct csg_drawing *drawing, uint32_t begin,
                       uint32_t end, const struct level *level)
{
    bool ok = true;
    for (uint32_t i = begin; i < end && ok; i++) {
        const struct csg_vec2 p = level_point(level, drawing->points.data[i]);
        ok = csg_mesh_add_point(mesh, csg_vec3(p.x, p.y, level->z));
    }
    return ok;
}

/* The triangles of the figure at the points from first on, turned over for the bottom. */
static bool add_cap(struct csg_mesh *mesh, const struct csg_triangles *triangles, uint32_t begin,
                    uint32_t first, bool is_bottom)
{
    bool ok = true;
    for (size_t i = 0; i < triangles->corners.num && ok; i += 3) {
        const uint32_t *p = &triangles->corners.data[i];
        ok = add_triangle(mesh, first + p[is_bottom ? 2 : 0] - begin, first + p[1] - begin,
                          first + p[is_bottom ? 0 : 2] - begin);
    }
    return ok;
}

static bool add_slices(struct csg_mesh *mesh, const struct csg_drawing *drawing,
                       const struct csg_twist *twist, uint32_t begin, uint32_t end, int num)
{
    const uint32_t size = end - begin;
    const struct level bottom = make_level(twist, 0, num);
    bool ok = add_points(mesh, drawing, begin, end, &bottom);
    for (int i = 0; i < num && ok; i++) {
        const struct level top = make_level(twist, i + 1, num);
        const bool is_pointed = top.scale[0] == 0 || top.scale[1] == 0;
        ok = add_points(mesh, drawing, begin, end, &top) &&
             add_slice(mesh, drawing, twist, begin, (uint32_t)i * size, (uint32_t)(i + 1) * size,
                       is_pointed);
    }
    return ok;
}

static uint32_t count_corners(const struct csg_drawing *drawing, const struct csg_figure *figure)
{
    return figure->begin == figure->end ? 0
                                        : drawing->contours.data[figure->end - 1].end -
                                              drawing->contours.data[figure->begin].begin;
}

double csg_twist_num_faces(const struct csg_twist *twist, const struct csg_drawing *drawing)
{
    const struct csg_figure *figure = &drawing->figures.data[drawing->figures.num - 1];
    return 2 * count_slices(twist, drawing, figure) * count_corners(drawing, figure);
}

enum csg_sweep_result csg_twist_fill(struct csg_mesh *mesh, const struct csg_drawing *drawing,
                                     const struct csg_twist *twist)
{
    const struct csg_figure *figure = &drawing->figures.data[drawing->figures.num - 1];
    struct csg_triangles caps = {0};
    if (figure->begin == figure->end)
        return CSG_SWEEP_DONE;
    const uint32_t begin = drawing->contours.data[figure->begin].begin;
    const uint32_t end = drawing->contours.data[figure->end - 1].end;
    if (!(csg_twist_num_faces(twist, drawing) <= CSG_TWIST_MAX_FACES) ||
        end - begin > CSG_TRIANGULATE_MAX_CORNERS)
        return CSG_SWEEP_TOO_LARGE;
    const int num = (int)count_slices(twist, drawing, figure);
    mesh->is_simple = fabs(twist->degrees) < MAX_STEP_DEGREES * num;
    bool ok = csg_figure_triangulate(drawing, figure, &caps) &&
              add_cap(mesh, &caps, begin, 0, true) &&
              add_slices(mesh, drawing, twist, begin, end, num);
    if (ok && twist->scale[0] > 0 && twist->scale[1] > 0)
        ok = add_cap(mesh, &caps, begin, (uint32_t)num * (end - begin), false);
    free(caps.corners.data);
    return ok && csg_mesh_clean(mesh, NULL) ? CSG_SWEEP_DONE : CSG_SWEEP_NO_MEMORY;
}
