/* SPDX-License-Identifier: MIT */
#ifndef CSG_SOLIDS_QUADRIC_EIGEN_H
#define CSG_SOLIDS_QUADRIC_EIGEN_H

#include "common/linear.h"

/*
 * Eigenvalues of the symmetric matrix a, which is used up, and an orthonormal set of eigenvectors,
 * by Jacobi's rotations. The error of the values is a few units of the last place of the largest
 * one. The axes of a matrix that is diagonal already are the coordinate axes exactly.
 */
void csg_eigen_symmetric(double a[3][3], double values[3], struct csg_vec3 axes[3]);

#endif
