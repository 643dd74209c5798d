/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_CLOCK_H
#define CSG_COMMON_CLOCK_H

#include <time.h>

/* Monotonic time in milliseconds, for statistics. */
static inline double csg_clock_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

#endif
