/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_CLOCK_H
#define CSG_COMMON_CLOCK_H

#include <time.h>

/* Milliseconds of a clock. */
static inline double csg_clock_read(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

/* Monotonic time in milliseconds, for statistics. */
static inline double csg_clock_ms(void)
{
    return csg_clock_read(CLOCK_MONOTONIC);
}

/* Processor time of all threads of the process, in milliseconds. */
static inline double csg_clock_work_ms(void)
{
    return csg_clock_read(CLOCK_PROCESS_CPUTIME_ID);
}

#endif
