/* SPDX-License-Identifier: MIT */
#include "solids/quadric/normal_form.h"

#include "solids/quadric/eigen.h"

double csg_form_value(const struct csg_form *form, struct csg_vec3 p)
{
    const double x[4] = {p.x, p.y, p.z, 1};
    double value = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            value += x[i] * form->q[i][j] * x[j];
    return value;
}

struct csg_vec3 csg_form_gradient(const struct csg_form *form, struct csg_vec3 p)
{
    double g[3];
    for (int i = 0; i < 3; i++) {
        const double *q = form->q[i];
        g[i] = 2 * (q[0] * p.x + q[1] * p.y + q[2] * p.z + q[3]);
    }
    return csg_vec3_of(g);
}

void csg_form_normalise(struct csg_form *form)
{
    double largest = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            largest = fmax(largest, fabs(form->q[i][j]));
    for (int i = 0; largest > 0 && i < 4; i++)
        for (int j = 0; j < 4; j++)
            form->q[i][j] /= largest;
}

/* b / lambda is the radius of curvature where the gradient has the length 2 b. */
bool csg_form_is_flat(const struct csg_form *form)
{
    double quadratic = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            quadratic = fmax(quadratic, fabs(form->q[i][j]));
    const struct csg_vec3 b = csg_vec3(form->q[0][3], form->q[1][3], form->q[2][3]);
    return quadratic == 0 || quadratic * CSG_FORM_FLAT_RADIUS < csg_length(b);
}

static double largest_of(const double v[3])
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

/* Moves the linear term of axis i into the square. noise: what rounding may leave of a constant
 * that should be zero; the error of b^2 / lambda grows as lambda falls behind the largest. */
static void complete_square(struct csg_normal_form *normal, int i, double b, double largest,
                            double *noise)
{
    const double lambda = normal->lambda[i];
    normal->shift[i] = b / lambda;
    normal->constant -= b * normal->shift[i];
    *noise += fabs(b * normal->shift[i]) * (largest / fabs(lambda));
}

/* Whether the centre along axis i is too far away to count from; see CSG_FORM_FAR. */
static bool is_far(const struct csg_normal_form *normal, int i, double b, double largest)
{
    const double lambda = fabs(normal->lambda[i]), constant = fabs(normal->constant);
    return lambda * CSG_FORM_FAR < largest && b * b > CSG_FORM_FAR * constant * lambda;
}

/* Completes the squares, those of the largest eigenvalues first, and leaves in b what is linear. */
static void complete_squares(struct csg_normal_form *normal, double b[3])
{
    const double largest = largest_of(normal->lambda);
    double noise = fabs(normal->constant);
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < 3; i++) {
            const bool is_long = fabs(normal->lambda[i]) * CSG_FORM_FAR < largest;
            if (normal->lambda[i] == 0 || is_long != (pass == 1))
                continue;
            if (is_far(normal, i, b[i], largest)) {
                normal->lambda[i] = 0;
                continue;
            }
            complete_square(normal, i, b[i], largest, &noise);
            b[i] = 0;
        }
    }
    if (fabs(normal->constant) <= CSG_FORM_NOISE * noise)
        normal->constant = 0;
}

/* Turns the axes k and m, both straight, so that all of the slope is along k. */
static void join_slopes(struct csg_normal_form *normal, double b[3], int k, int m)
{
    const struct csg_vec3 u = normal->axis[k], v = normal->axis[m];
    const double length = hypot(b[k], b[m]);
    const double c = b[k] / length, s = b[m] / length;
    normal->axis[k] = csg_add(csg_scale(c, u), csg_scale(s, v));
    normal->axis[m] = csg_sub(csg_scale(c, v), csg_scale(s, u));
    b[k] = length;
    b[m] = 0;
}

/* slope / largest is the radius of curvature at a paraboloid's vertex, and constant / largest the
 * square of the radius of what has a centre. */
static void drop_tiny(struct csg_normal_form *normal)
{
    const double largest = largest_of(normal->lambda);
    if (fabs(normal->slope) <= largest * CSG_FORM_POINT_RADIUS) {
        normal->slope = 0;
        normal->slope_axis = -1;
    }
    if (fabs(normal->constant) <= largest * CSG_FORM_POINT_RADIUS * CSG_FORM_POINT_RADIUS)
        normal->constant = 0;
}

static void find_slope(struct csg_normal_form *normal, double b[3])
{
    normal->slope = 0;
    normal->slope_axis = -1;
    for (int i = 0; i < 3; i++) {
        if (normal->lambda[i] != 0 || b[i] == 0)
            continue;
        if (normal->slope_axis >= 0)
            join_slopes(normal, b, normal->slope_axis, i);
        else
            normal->slope_axis = i;
    }
    if (normal->slope_axis >= 0)
        normal->slope = b[normal->slope_axis];
}

void csg_form_diagonalise(const struct csg_form *form, struct csg_normal_form *normal)
{
    double quadratic[3][3], b[3];
    const struct csg_vec3 linear = csg_vec3(form->q[0][3], form->q[1][3], form->q[2][3]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            quadratic[i][j] = form->q[i][j];
    csg_eigen_symmetric(quadratic, normal->lambda, normal->axis);
    const double largest = largest_of(normal->lambda);
    for (int i = 0; i < 3; i++) {
        b[i] = csg_dot(normal->axis[i], linear);
        if (fabs(b[i]) <= CSG_FORM_NOISE * csg_length(linear))
            b[i] = 0;
        if (fabs(normal->lambda[i]) <= CSG_FORM_NOISE * largest)
            normal->lambda[i] = 0;
        normal->shift[i] = 0;
    }
    normal->constant = form->q[3][3];
    complete_squares(normal, b);
    find_slope(normal, b);
    drop_tiny(normal);
}
