/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_ANTIALIAS_H
#define CSG_CLI_ANTIALIAS_H

/* --antialias=N: a pixel is the mean of N x N rays. */

#include "csgcast/csgcast.h"

#define CSG_ANTIALIAS_MAX 8

/* The view of N x N times the pixels. false, with a message, where csgcast does not draw so many. */
bool csg_antialias_view(const struct csgcast_view *view, int n, struct csgcast_view *fine);

/* From the image of the fine view to that of width x height pixels, in place: its colours. */
void csg_antialias_reduce(const struct csgcast_image *image, int width, int height, int n);

#endif
