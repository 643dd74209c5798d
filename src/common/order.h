/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_ORDER_H
#define CSG_COMMON_ORDER_H

/* For qsort: ascending numbers. */

#include <stdint.h>

static inline int csg_compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static inline int csg_compare_indices(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

#endif
