/* SPDX-License-Identifier: MIT */
#ifndef CSG_SOLIDS_QUADRIC_NORMAL_FORM_H
#define CSG_SOLIDS_QUADRIC_NORMAL_FORM_H

/*
 * From ten coefficients to principal axes. In the coordinates u_i = axis[i].x,
 *     f = sum of lambda[i] u_i^2 + 2 b[i] u_i + constant,
 * and where lambda[i] is not zero, (u_i + b[i] / lambda[i])^2 has taken up b[i]:
 *     f = sum over lambda[i] != 0 of lambda[i] (u_i + shift[i])^2 + 2 slope u_k + constant.
 */

#include "common/linear.h"

/* f(x, y, z) = A x^2 + 2 B xy + 2 C xz + 2 D x + E y^2 + 2 F yz + 2 G y + H z^2 + 2 I z + J as a
 * symmetric 4x4 matrix (Sigg et al. 2006, eq. 1): rows A B C D, B E F G, C F H I, D G I J. */
struct csg_form {
    double q[4][4];
};

struct csg_normal_form {
    double lambda[3]; /* 0 where the quadric is straight along the axis */
    struct csg_vec3 axis[3];
    double shift[3]; /* 0 where lambda is */
    double slope;    /* of the linear rest; 0: none */
    int slope_axis;  /* its axis k, with lambda[k] == 0; -1: none */
    double constant;
};

/*
 * An eigenvalue or constant is zero when it is no larger than what rounding makes of zero: this
 * share of the largest eigenvalue, or of the terms that made the constant.
 */
#define CSG_FORM_NOISE 4e-15

/*
 * A quadric so long along an axis that its centre is further off than its nearest end by this
 * factor is taken for the paraboloid or parabolic cylinder that it is there: counted from a centre
 * that far away, its other terms would drown. Applies to eigenvalues below the inverse share of
 * the largest only. Ellipsoids with a centre in reach may be as long as they like.
 */
#define CSG_FORM_FAR 1e10

/* A quadric is a plane when its radius of curvature is beyond so many scene units. */
#define CSG_FORM_FLAT_RADIUS 1e15

/* Radii below so many scene units are zero: such a sphere is a point, such a hyperboloid a cone. */
#define CSG_FORM_POINT_RADIUS 1e-30

double csg_form_value(const struct csg_form *form, struct csg_vec3 p);
struct csg_vec3 csg_form_gradient(const struct csg_form *form, struct csg_vec3 p);

/* Divides by the largest coefficient, which changes no sign. All zero stays zero. */
void csg_form_normalise(struct csg_form *form);

/* Degree 1 or 0: no quadratic term to speak of. */
bool csg_form_is_flat(const struct csg_form *form);

/* form must be normalised and not flat. */
void csg_form_diagonalise(const struct csg_form *form, struct csg_normal_form *normal);

#endif
