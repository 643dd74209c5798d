/* SPDX-License-Identifier: MIT */
/* The least radius of curvature of ellipsoids and cylinders, however they came to their place. */
#include "sharpness/curvature.h"

#include <math.h>

#include "check.h"
#include "dice.h"

static void random_turn(double m[3][3])
{
    const double a[3] = {random_between(-3, 3), random_between(-3, 3), random_between(-3, 3)};
    const double c[3] = {cos(a[0]), cos(a[1]), cos(a[2])}, s[3] = {sin(a[0]), sin(a[1]), sin(a[2])};
    const double turn[3][3] = {
        {c[0] * c[1], c[0] * s[1] * s[2] - s[0] * c[2], c[0] * s[1] * c[2] + s[0] * s[2]},
        {s[0] * c[1], s[0] * s[1] * s[2] + c[0] * c[2], s[0] * s[1] * c[2] - c[0] * s[2]},
        {-s[1], c[1] * s[2], c[1] * c[2]}};
    for (int i = 0; i < 9; i++)
        m[i / 3][i % 3] = turn[i / 3][i % 3];
}

/* turned: canonical coordinates are, too, as those of a sheared solid. */
static void check_ellipsoid(bool turned)
{
    double inner[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, outer[3][3], axes[3];
    struct csg_quadric quadric = {.diag = {1, 1, 1, -1}};
    double longest = 0, shortest = INFINITY;
    random_turn(outer);
    if (turned)
        random_turn(inner);
    for (int i = 0; i < 3; i++) {
        axes[i] = exp(random_between(-3, 3));
        longest = fmax(longest, axes[i]);
        shortest = fmin(shortest, axes[i]);
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                quadric.to_canon.m[i][j] += inner[i][k] / axes[k] * outer[k][j];
    const double expected = shortest * shortest / longest, got = csg_curvature(&quadric, 1000);
    CHECK(fabs(got - expected) < 1e-9 * longest * longest / shortest, "%g, not %g", got, expected);
}

static void check_cylinder(void)
{
    const double radius = exp(random_between(-3, 3)), size = 1e6;
    struct csg_quadric quadric = {.diag = {1, 1, 0, -1}};
    for (int i = 0; i < 3; i++)
        quadric.to_canon.m[i][i] = 1 / radius;
    const double got = csg_curvature(&quadric, size);
    CHECK(fabs(got - radius) < 1e-9 * radius, "a cylinder's is %g, not %g", got, radius);
}

int main(void)
{
    for (int i = 0; i < 1000; i++) {
        check_ellipsoid(i % 2);
        check_cylinder();
    }
    return num_failed != 0;
}
