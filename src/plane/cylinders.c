/* SPDX-License-Identifier: MIT */
#include "plane/cylinders.h"

#include "plane/extrude.h"
#include "plane/hull.h"
#include "solids/facets.h"

/* Directions and lengths that differ by less, relatively, are the same: six digits in the file. */
#define SAME 2e-6

/* Of the polygon that bounds a disc where facets are asked for. */
enum { num_corners = 64 };

/* Axes u, v and n of a common frame. */
struct basis {
    struct csg_vec3 u, v, n;
    double lo, hi; /* the planes: n.x is between lo and hi */
};

static bool is_cylinder(const struct csg_shape *shape)
{
    const int8_t *diag = shape->quadric.diag;
    return shape->has_quadric && shape->num_planes == 2 && diag[0] == 1 && diag[1] == 1 &&
           diag[2] == 0 && diag[3] == -1;
}

static struct basis basis_of(const struct csg_shape *shape)
{
    struct basis basis = {.n = shape->planes[1].normal};
    basis.u = csg_normalize(csg_map_row(&shape->quadric.to_canon, 0));
    basis.v = csg_cross(basis.n, basis.u);
    basis.hi = shape->planes[1].offset;
    basis.lo = -shape->planes[0].offset;
    return basis;
}

/* Canonical x and y are a.p + s and b.p + t: a circle across n where a and b are as long, across
 * each other and across n. */
static bool find_disc(const struct csg_shape *shape, const struct basis *basis,
                      struct csg_vec2 *center, double *radius)
{
    const struct csg_map *to = &shape->quadric.to_canon;
    const struct csg_vec3 a = csg_map_row(to, 0), b = csg_map_row(to, 1), n = basis->n;
    const double length = csg_length(a), size = basis->hi - basis->lo + 1 / length;
    const double side = csg_dot(n, shape->planes[1].normal) < 0 ? -1 : 1;
    const struct csg_plane *hi = &shape->planes[side > 0 ? 1 : 0];
    const struct csg_plane *lo = &shape->planes[side > 0 ? 0 : 1];
    const struct csg_vec3 turn = csg_sub(hi->normal, n), back = csg_add(lo->normal, n);
    *radius = 1 / length;
    const struct csg_vec3 c = csg_add(csg_scale(-to->m[0][3] / (length * length), a),
                                      csg_scale(-to->m[1][3] / (length * length), b));
    *center = (struct csg_vec2){csg_dot(c, basis->u), csg_dot(c, basis->v)};
    return fabs(csg_length(b) - length) <= SAME * length &&
           fabs(csg_dot(a, b)) <= SAME * length * length && fabs(csg_dot(a, n)) <= SAME * length &&
           fabs(csg_dot(b, n)) <= SAME * length && csg_length(turn) <= SAME &&
           csg_length(back) <= SAME && fabs(hi->offset - basis->hi) <= SAME * size &&
           fabs(-lo->offset - basis->lo) <= SAME * size;
}

static bool add_disc(struct csg_drawing *drawing, struct csg_vec2 center, double radius,
                     double rounding)
{
    bool ok = csg_drawing_add_figure(drawing, rounding) && csg_drawing_add_contour(drawing);
    for (int i = 0; i < num_corners && ok; i++)
        ok = csg_drawing_add_point(drawing,
                                   center.x + radius * csg_cos_degrees(360.0 * i / num_corners),
                                   center.y + radius * csg_sin_degrees(360.0 * i / num_corners));
    if (!ok)
        return false;
    struct csg_figure *figure = &drawing->figures.data[drawing->figures.num - 1];
    figure->is_disc = true;
    figure->disc = csg_map_scaling(csg_vec3(radius, radius, 1));
    figure->disc.m[0][3] = center.x;
    figure->disc.m[1][3] = center.y;
    return true;
}

static bool collect(const struct csg_part *from, const struct basis *basis,
                    struct csg_drawing *drawing, bool *all)
{
    bool ok = csg_drawing_open(drawing, CSG_DRAW_UNION);
    *all = true;
    for (size_t i = 0; i < from->shapes.num && ok && *all; i++) {
        const struct csg_shape *shape = &from->shapes.data[i];
        struct csg_vec2 center;
        double radius;
        *all = is_cylinder(shape) && find_disc(shape, basis, &center, &radius);
        if (*all)
            ok = add_disc(drawing, center, radius, shape->rounding);
    }
    if (ok)
        csg_drawing_close(drawing, 0);
    return ok;
}

/* The largest of the hull's cylinders: the discs here have corners of our own. */
static double largest_sagitta(const struct csg_part *from)
{
    double largest = 0;
    for (size_t i = 0; i < from->shapes.num; i++)
        largest = fmax(largest, from->shapes.data[i].sagitta);
    return largest;
}

static bool extrude(struct csg_part *part, const struct basis *basis,
                    const struct csg_drawing *drawing, double sagitta)
{
    const struct csg_lift lift = {basis->lo, 1, basis->hi, 1};
    const struct csg_map map = {{{basis->u.x, basis->v.x, basis->n.x, 0},
                                 {basis->u.y, basis->v.y, basis->n.y, 0},
                                 {basis->u.z, basis->v.z, basis->n.z, 0}}};
    bool too_large;
    bool ok = csg_extrude(part, drawing, &lift, SIZE_MAX, &too_large) || too_large;
    for (size_t i = 0; i < part->shapes.num; i++) {
        ok = csg_shape_map(&part->shapes.data[i], &map) && ok;
        part->shapes.data[i].sagitta = part->shapes.data[i].has_quadric ? sagitta : 0;
    }
    part->is_too_large |= too_large;
    return ok;
}

bool csg_disc_hull(struct csg_part *part, const struct csg_part *from, bool *taken)
{
    struct csg_drawing drawing = {0};
    bool all = false, ok = true;
    *taken = false;
    if (from->shapes.num == 0 || !is_cylinder(&from->shapes.data[0]))
        return true;
    const struct basis basis = basis_of(&from->shapes.data[0]);
    ok = collect(from, &basis, &drawing, &all);
    if (ok && all)
        ok = csg_drawing_hull(&drawing, 0) == CSG_SWEEP_DONE &&
             extrude(part, &basis, &drawing, largest_sagitta(from));
    *taken = ok && all;
    csg_drawing_finish(&drawing);
    return ok;
}
