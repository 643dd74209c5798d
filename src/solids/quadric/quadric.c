/* SPDX-License-Identifier: MIT */
/*
 * quadric(coefficients = [A, B, C, D, E, F, G, H, I, J]) or quadric(matrix = 4x4): all points with
 *     A x^2 + 2 B xy + 2 C xz + 2 D x + E y^2 + 2 F yz + 2 G y + H z^2 + 2 I z + J <= 0.
 * Any of the 17 classes, and the planes and constants they degenerate to. The principal axes
 * become the canonical axes, scaled so that the coefficients are -1, 0 or 1.
 */
#include "solids/checked.h"
#include "solids/halfspace/halfspace.h"
#include "solids/quadric/normal_form.h"
#include "solids/sample.h"
#include "solids/solid.h"

/* A matrix counts as symmetric when mirrored entries differ by no more than this share of the
 * largest entry: a few units of the six digits that OpenSCAD prints. */
#define ASYMMETRY 1e-5

/* Points of the surface at which the rounding of the coefficients is turned into a length. */
#define NUM_SAMPLES 16

/* ---- arguments ---------------------------------------------------------------------------- */

/* The ten coefficients, row by row of the upper triangle. */
static bool read_coefficients(const struct csg_args *args, const struct csg_value *value,
                              struct csg_form *form, struct csg_form *rounding)
{
    double c[10];
    if (!csg_value_numbers(value, 10, c, NULL)) {
        csg_args_error(args, "coefficients must be ten numbers [A, B, C, D, E, F, G, H, I, J]");
        return false;
    }
    for (int i = 0, k = 0; i < 4; i++) {
        for (int j = i; j < 4; j++, k++) {
            form->q[i][j] = form->q[j][i] = c[k];
            rounding->q[i][j] = rounding->q[j][i] = (double)value->items[k].rounding;
        }
    }
    return true;
}

static bool read_rows(const struct csg_value *value, struct csg_form *form,
                      struct csg_form *rounding)
{
    if (value->type != CSG_VALUE_VECTOR || value->num != 4)
        return false;
    for (int i = 0; i < 4; i++) {
        if (!csg_value_numbers(&value->items[i], 4, form->q[i], NULL))
            return false;
        for (int j = 0; j < 4; j++)
            rounding->q[i][j] = (double)value->items[i].items[j].rounding;
    }
    return true;
}

static double largest_entry(const struct csg_form *form)
{
    double largest = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            largest = fmax(largest, fabs(form->q[i][j]));
    return largest;
}

static bool read_matrix(const struct csg_args *args, const struct csg_value *value,
                        struct csg_form *form, struct csg_form *rounding)
{
    if (!read_rows(value, form, rounding)) {
        csg_args_error(args, "matrix must be four rows of four numbers");
        return false;
    }
    const double largest = largest_entry(form);
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < i; j++) {
            const double a = form->q[i][j], b = form->q[j][i];
            if (fabs(a - b) > ASYMMETRY * largest) {
                csg_args_error(args, "matrix is not symmetric: [%d][%d] is %g, [%d][%d] is %g", i,
                               j, a, j, i, b);
                return false;
            }
            form->q[i][j] = form->q[j][i] = 0.5 * a + 0.5 * b;
        }
    }
    return true;
}

static bool read_form(const struct csg_args *args, struct csg_form *form, struct csg_form *rounding)
{
    const struct csg_value *coefficients = csg_args_find(args, "coefficients");
    const struct csg_value *matrix = csg_args_find(args, "matrix");
    if (!coefficients == !matrix) {
        csg_args_error(args, "needs either coefficients or matrix");
        return false;
    }
    if (coefficients ? !read_coefficients(args, coefficients, form, rounding)
                     : !read_matrix(args, matrix, form, rounding))
        return false;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            if (!isfinite(form->q[i][j])) {
                csg_args_error(args, "the coefficients must be finite numbers");
                return false;
            }
    return true;
}

/* ---- the solid ---------------------------------------------------------------------------- */

static int8_t sign_of(double x)
{
    return (int8_t)((x > 0) - (x < 0));
}

static int count_sign(const struct csg_normal_form *normal, int sign)
{
    int num = 0;
    for (int i = 0; i < 3; i++)
        num += sign_of(normal->lambda[i]) == sign;
    return num;
}

/*
 * f and -f are the two sides of one surface, so both get the same canonical axes: those of the one
 * that has more positive eigenvalues or, with as many of both, a positive constant. 1 where this is
 * f, -1 where it is -f.
 */
static int orientation(const struct csg_normal_form *normal)
{
    const int excess = count_sign(normal, 1) - count_sign(normal, -1);
    if (excess != 0)
        return excess > 0 ? 1 : -1;
    return normal->slope_axis < 0 && normal->constant < 0 ? -1 : 1;
}

/* Canonical order: positive eigenvalues, then zeros, then negative ones; the axis with the linear
 * term, which is p.z, last. */
static void sort_axes(const struct csg_normal_form *normal, int side, int order[3])
{
    int num = 0;
    for (int sign = 1; sign >= -1; sign--)
        for (int i = 0; i < 3; i++)
            if (i != normal->slope_axis && sign_of(side * normal->lambda[i]) == sign)
                order[num++] = i;
    if (normal->slope_axis >= 0)
        order[2] = normal->slope_axis;
}

static void set_row(struct csg_map *map, int row, double scale, struct csg_vec3 axis, double offset)
{
    map->m[row][0] = scale * axis.x;
    map->m[row][1] = scale * axis.y;
    map->m[row][2] = scale * axis.z;
    map->m[row][3] = offset;
}

static double largest_lambda(const struct csg_normal_form *normal)
{
    return fmax(fabs(normal->lambda[0]), fmax(fabs(normal->lambda[1]), fabs(normal->lambda[2])));
}

/*
 * What f is divided by. With a constant and no linear term it must be the constant's size, so that
 * the constant becomes 1. Else it is free: a paraboloid is measured by its radius of curvature, or
 * by its width where the origin is if that is more; a cone in scene units.
 */
static double unit_of(const struct csg_normal_form *normal)
{
    const double largest = largest_lambda(normal);
    if (normal->slope_axis >= 0)
        return fmax(normal->slope / largest * normal->slope, fabs(normal->constant));
    return normal->constant != 0 ? fabs(normal->constant) : largest;
}

static void fill_quadric(const struct csg_normal_form *normal, struct csg_quadric *quadric)
{
    const int side = orientation(normal);
    const double unit = unit_of(normal);
    const double straight = sqrt(largest_lambda(normal) / unit); /* free: as the narrowest axis */
    int order[3];
    sort_axes(normal, side, order);
    for (int row = 0; row < 3; row++) {
        const int i = order[row];
        const double lambda = normal->lambda[i];
        const double scale = lambda != 0 ? sqrt(fabs(lambda) / unit) : straight;
        quadric->diag[row] = sign_of(lambda);
        set_row(&quadric->to_canon, row, scale, normal->axis[i], scale * normal->shift[i]);
    }
    quadric->diag[3] = normal->slope_axis >= 0 ? 0 : sign_of(normal->constant);
    if (normal->slope_axis < 0)
        return;
    /* side f / unit = ... + side (2 slope u + constant) / unit = ... - p.z */
    quadric->linear = (float)(-0.5 * side);
    set_row(&quadric->to_canon, 2, -side * 2 * normal->slope / unit,
            normal->axis[normal->slope_axis], -side * normal->constant / unit);
}

/* Two parallel planes: |scale u + shift| <= 1 along the only curved axis. */
static bool fill_slab(const struct csg_normal_form *normal, struct csg_shape *shape)
{
    int i = 0;
    while (normal->lambda[i] == 0)
        i++;
    const double half = sqrt(-normal->constant / normal->lambda[i]);
    return csg_shape_add_plane(shape, normal->axis[i], half - normal->shift[i]) &&
           csg_shape_add_plane(shape, csg_scale(-1, normal->axis[i]), half + normal->shift[i]);
}

/* Along axis i the set reaches from lo to hi: adds what this means for x, y and z. */
static void add_reach(struct csg_vec3 axis, double lo, double hi, double box_lo[3],
                      double box_hi[3])
{
    const double a[3] = {axis.x, axis.y, axis.z};
    for (int i = 0; i < 3; i++) {
        if (a[i] == 0)
            continue;
        box_lo[i] += fmin(a[i] * lo, a[i] * hi);
        box_hi[i] += fmax(a[i] * lo, a[i] * hi);
    }
}

/*
 * Box of a set without negative eigenvalues. The straight axes reach to infinity and a paraboloid's
 * p.z from 0 on; the ellipse of the others, with semi-axes r_i, reaches sqrt(sum of (a_i r_i)^2)
 * from its centre along an axis of space with components a_i.
 */
static void fill_bounds(const struct csg_normal_form *normal, struct csg_box *bounds)
{
    double lo[3] = {0, 0, 0}, hi[3] = {0, 0, 0}, squares[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 axis = normal->axis[i];
        const double r = normal->lambda[i] > 0 && normal->slope_axis < 0
                             ? sqrt(-normal->constant / normal->lambda[i])
                             : INFINITY;
        if (i == normal->slope_axis) { /* 2 slope u + constant <= 0 */
            const double end = -normal->constant / (2 * normal->slope);
            add_reach(axis, normal->slope > 0 ? -INFINITY : end, normal->slope > 0 ? end : INFINITY,
                      lo, hi);
        } else if (!isfinite(r)) {
            add_reach(axis, -INFINITY, INFINITY, lo, hi);
        } else {
            const double a[3] = {axis.x, axis.y, axis.z};
            add_reach(axis, -normal->shift[i], -normal->shift[i], lo, hi);
            for (int j = 0; j < 3; j++)
                squares[j] += (a[j] * r) * (a[j] * r);
        }
    }
    *bounds = (struct csg_box){
        {lo[0] - sqrt(squares[0]), lo[1] - sqrt(squares[1]), lo[2] - sqrt(squares[2])},
        {hi[0] + sqrt(squares[0]), hi[1] + sqrt(squares[1]), hi[2] + sqrt(squares[2])}};
}

/* All points or none: the quadratic terms cannot become as negative, or as positive, as the
 * constant is. Sets of measure zero (a point, a line, a plane) count as none. */
static bool is_constant(const struct csg_normal_form *normal, bool *is_everything)
{
    const bool has_negative = count_sign(normal, -1) > 0, has_positive = count_sign(normal, 1) > 0;
    *is_everything = !has_positive;
    if (normal->slope_axis >= 0 || (has_negative && has_positive))
        return false;
    return has_positive ? normal->constant >= 0 : normal->constant <= 0;
}

static enum csg_read_result fill_curved(const struct csg_args *args, const struct csg_form *form,
                                        struct csg_shape *shape)
{
    struct csg_normal_form normal;
    bool is_everything;
    csg_form_diagonalise(form, &normal);
    if (is_constant(&normal, &is_everything))
        return is_everything ? CSG_READ_OK : CSG_READ_EMPTY;
    /* No negative eigenvalue is a convex set: ellipsoid, paraboloid, their cylinders, slab. */
    shape->convex = count_sign(&normal, -1) == 0;
    if (shape->convex)
        fill_bounds(&normal, &shape->bounds);
    if (shape->convex && count_sign(&normal, 1) == 1 && normal.slope_axis < 0) {
        if (!fill_slab(&normal, shape))
            return csg_log_memory(args->log), CSG_READ_ERROR;
        return CSG_READ_OK;
    }
    shape->has_quadric = true;
    fill_quadric(&normal, &shape->quadric);
    return CSG_READ_OK;
}

/* 2 D x + 2 G y + 2 I z + J <= 0 */
static enum csg_read_result fill_flat(const struct csg_args *args, const struct csg_form *form,
                                      struct csg_shape *shape)
{
    const struct csg_vec3 normal = csg_vec3(form->q[0][3], form->q[1][3], form->q[2][3]);
    if (csg_length(normal) == 0)
        return form->q[3][3] > 0 ? CSG_READ_EMPTY : CSG_READ_OK;
    if (!csg_halfspace_fill(shape, normal, -0.5 * form->q[3][3]))
        return csg_log_memory(args->log), CSG_READ_ERROR;
    return CSG_READ_OK;
}

/* How far the surface moves when every coefficient moves by its rounding: |change of f| over the
 * gradient, at the worst of some points. */
static double rounding_length(const struct csg_form *form, const struct csg_form *rounding,
                              const struct csg_shape *shape)
{
    struct csg_vec3 points[NUM_SAMPLES];
    double largest = 0;
    const size_t num = csg_shape_sample(shape, points, NUM_SAMPLES);
    for (size_t i = 0; i < num; i++) {
        const struct csg_vec3 p = points[i];
        const struct csg_vec3 size = csg_vec3(fabs(p.x), fabs(p.y), fabs(p.z));
        const double slope = csg_length(csg_form_gradient(form, p));
        if (slope > 0)
            largest = fmax(largest, csg_form_value(rounding, size) / slope);
    }
    return largest;
}

static enum csg_read_result read(const struct csg_args *args, struct csg_shape *shape)
{
    struct csg_form written, rounding;
    if (!read_form(args, &written, &rounding))
        return CSG_READ_ERROR;
    struct csg_form form = written;
    csg_form_normalise(&form);
    shape->convex = true;
    shape->bounds = csg_box_all;
    const enum csg_read_result result =
        csg_form_is_flat(&form) ? fill_flat(args, &form, shape) : fill_curved(args, &form, shape);
    if (result == CSG_READ_OK && shape->has_quadric)
        shape->rounding = rounding_length(&written, &rounding, shape);
    shape->written = shape->bounds;
    return result;
}

const struct csg_solid_ops csg_solid_quadric = {
    .name = "quadric",
    .parameters = "coefficients matrix",
    .read = read,
};
