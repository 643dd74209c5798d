/* SPDX-License-Identifier: MIT */
#include "crowd/strips.h"

#include <stdlib.h>

#include "crowd/relief.h"

int csg_strip_begin(int height, size_t strip)
{
    const int row = (int)((size_t)height * strip / CSG_NUM_STRIPS);
    return strip < CSG_NUM_STRIPS ? row - row % CSG_RELIEF_SQUARE : height;
}

uint8_t *csg_strips_of_rows(int height)
{
    uint8_t *strips = malloc((size_t)height + 1);
    for (size_t strip = 0; strips && strip < CSG_NUM_STRIPS; strip++)
        for (int y = csg_strip_begin(height, strip); y < csg_strip_begin(height, strip + 1); y++)
            strips[y] = (uint8_t)strip;
    return strips;
}

struct csg_key_bins csg_key_bins(float lo, float hi)
{
    return (struct csg_key_bins){lo, hi > lo ? CSG_NUM_KEY_BINS / (hi - lo) : 0};
}
