/* SPDX-License-Identifier: MIT */
#include "solids/quadric/eigen.h"

/* Converges quadratically: four or five sweeps do for any matrix of doubles. */
#define MAX_SWEEPS 32

/* Adding it changes neither number: the rotation would be the identity. */
static bool is_negligible(double off_diagonal, double a, double b)
{
    const double size = fabs(off_diagonal);
    return fabs(a) + size == fabs(a) && fabs(b) + size == fabs(b);
}

/*
 * The rotation by the angle phi with cot(2 phi) = (a[q][q] - a[p][p]) / (2 a[p][q]) makes a[p][q]
 * zero; t = tan(phi) is the smaller root of t^2 + 2 cot(2 phi) t - 1 (Golub and Van Loan, 8.5).
 */
static void rotate(double a[3][3], double v[3][3], int p, int q)
{
    const double cot = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double t = (cot < 0 ? -1 : 1) / (fabs(cot) + hypot(1, cot));
    const double c = 1 / sqrt(t * t + 1), s = t * c;
    const int r = 3 - p - q;
    const double arp = a[r][p], arq = a[r][q];
    a[p][p] -= t * a[p][q];
    a[q][q] += t * a[p][q];
    a[p][q] = a[q][p] = 0;
    a[r][p] = a[p][r] = c * arp - s * arq;
    a[r][q] = a[q][r] = s * arp + c * arq;
    for (int i = 0; i < 3; i++) {
        const double vip = v[i][p], viq = v[i][q];
        v[i][p] = c * vip - s * viq;
        v[i][q] = s * vip + c * viq;
    }
}

/* false when nothing was left to do. */
static bool sweep(double a[3][3], double v[3][3])
{
    bool has_rotated = false;
    for (int p = 0; p < 2; p++) {
        for (int q = p + 1; q < 3; q++) {
            if (is_negligible(a[p][q], a[p][p], a[q][q]))
                continue;
            rotate(a, v, p, q);
            has_rotated = true;
        }
    }
    return has_rotated;
}

void csg_eigen_symmetric(double a[3][3], double values[3], struct csg_vec3 axes[3])
{
    double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < MAX_SWEEPS && sweep(a, v); i++)
        ;
    for (int i = 0; i < 3; i++) {
        values[i] = a[i][i];
        axes[i] = csg_vec3(v[0][i], v[1][i], v[2][i]);
    }
}
