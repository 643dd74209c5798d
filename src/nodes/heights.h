/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_HEIGHTS_H
#define CSG_NODES_HEIGHTS_H

/* The heights of a surface(). */

#include "common/array.h"
#include "common/file.h"

/* Rows of the longest one's length may not have more heights together. */
enum { CSG_HEIGHTS_MAX = 10000000 };

/* One height after the other, row by row; rows may differ in length. Zero-initialise it. */
struct csg_heights {
    CSG_ARRAY(double) values;
    CSG_ARRAY(size_t) rows; /* where each ends */
    size_t columns;
    double floor; /* of what stands below them */
};

enum csg_heights_result {
    CSG_HEIGHTS_DONE,
    CSG_HEIGHTS_BROKEN, /* no image that libpng reads */
    CSG_HEIGHTS_TOO_MANY,
    CSG_HEIGHTS_NO_MEMORY,
};

bool csg_heights_is_png(const struct csg_bytes *bytes);

/* The brightness of an image, white at 100 as OpenSCAD 2021.01 has it, the last row first. */
enum csg_heights_result csg_heights_read_png(struct csg_heights *heights,
                                             const struct csg_bytes *bytes, bool invert);

#endif
