/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_STRIPS_H
#define CSG_CROWD_STRIPS_H

/* A relief is drawn in strips of rows, each by one thread, the nearest keys roughly first. */

#include <stddef.h>
#include <stdint.h>

enum { CSG_NUM_STRIPS = 16, CSG_NUM_KEY_BINS = 2048 };

/* The first row of a strip, at the border of a relief's squares; of the one behind the last: the
 * picture's height. */
int csg_strip_begin(int height, size_t strip);

/* The strip of each row. NULL: out of memory; to be freed. */
uint8_t *csg_strips_of_rows(int height);

/* The range of keys. */
struct csg_key_bins {
    float lo, scale;
};

struct csg_key_bins csg_key_bins(float lo, float hi);

static inline int csg_key_bin(const struct csg_key_bins *bins, float key)
{
    const float place = (key - bins->lo) * bins->scale;
    return place < CSG_NUM_KEY_BINS ? place > 0 ? (int)place : 0 : CSG_NUM_KEY_BINS - 1;
}

#endif
