/* SPDX-License-Identifier: MIT */
#ifndef BENCH_LIBFIVE_WRAP_H
#define BENCH_LIBFIVE_WRAP_H

/* The heightmap of libfive, which its C interface leaves out. */

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A box of voxels, looked at from its upper z. */
struct libfive_view {
    float lower[3], upper[3];
    int num[3]; /* voxels */
};

/* tree: a libfive_tree. rgba: view->num[0] x num[1] pixels, the least y first; alpha is 0 where
 * nothing is met, colours are the components of the normal in the voxels' space. */
bool libfive_heightmap(const void *tree, const struct libfive_view *view, unsigned char *rgba);

#ifdef __cplusplus
}
#endif

#endif
