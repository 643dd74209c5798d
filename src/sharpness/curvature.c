/* SPDX-License-Identifier: MIT */
#include "sharpness/curvature.h"

#include "solids/quadric/eigen.h"

/* Axes whose directions agree by a smaller share count as perpendicular: what they are off is less
 * than that share of any of them. */
#define PERPENDICULAR 1e-6

/* Rows of the map to the canonical coordinates in which the surface is curved. */
static int curved_rows(const struct csg_quadric *quadric, struct csg_vec3 rows[3])
{
    int num = 0;
    for (int i = 0; i < 3; i++) {
        const double *row = quadric->to_canon.m[i];
        if (quadric->diag[i] != 0 || (i == 2 && quadric->linear != 0))
            rows[num++] = csg_vec3_of(row);
    }
    return num;
}

/* Of perpendicular rows, as all have that are not sheared, the eigenvalues are their squares. */
static bool find_squares(const struct csg_vec3 *rows, int num, double values[3])
{
    for (int i = 0; i < num; i++)
        values[i] = csg_dot(rows[i], rows[i]);
    for (int i = 0; i < num; i++)
        for (int j = 0; j < i; j++) {
            const double dot = csg_dot(rows[i], rows[j]);
            if (!(dot * dot <= PERPENDICULAR * PERPENDICULAR * values[i] * values[j]))
                return false;
        }
    return true;
}

/* Of the sum of the squares of the coordinates. */
static void find_eigenvalues(const struct csg_vec3 *rows, int num, double values[3])
{
    double form[3][3] = {{0}};
    struct csg_vec3 axes[3];
    for (int i = 0; i < num; i++) {
        const double row[3] = {rows[i].x, rows[i].y, rows[i].z};
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                form[j][k] += row[j] * row[k];
    }
    csg_eigen_symmetric(form, values, axes);
}

/*
 * That of a section with the semi-axes a < b is a^2 / b. The form's eigenvalues are 1 / axis^2,
 * largest first num of them; no axis is longer than what can be seen of the surface, size.
 */
double csg_curvature(const struct csg_quadric *quadric, double size)
{
    struct csg_vec3 rows[3];
    double values[3] = {0, 0, 0};
    const int num = curved_rows(quadric, rows);
    if (!find_squares(rows, num, values))
        find_eigenvalues(rows, num, values);
    const double most = csg_most(csg_most(values[0], values[1]), values[2]);
    const double least = csg_least(csg_least(values[0], values[1]), values[2]);
    if (num < 2 || !(most > 0))
        return INFINITY;
    const double middle = values[0] + values[1] + values[2] - most - least;
    const double shortest = 1 / sqrt(most), other = num == 2 ? middle : least;
    const double longest = other * size * size > 1 ? 1 / sqrt(other) : size;
    return shortest * fmin(1, shortest / longest);
}
