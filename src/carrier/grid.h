/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_GRID_H
#define CSG_CARRIER_GRID_H

/* Coordinates that are counted in cells: what nearly agrees is in one cell or in neighbours. */

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

static inline int64_t csg_grid_cell(double coordinate)
{
    const double limit = 1e15;
    return (int64_t)floor(fmin(coordinate, limit));
}

/* The neighbour of a coordinate's cell that it is nearer to. */
static inline int64_t csg_grid_neighbour(double coordinate)
{
    const int64_t cell = csg_grid_cell(coordinate);
    return coordinate - floor(coordinate) < 0.5 ? cell - 1 : cell + 1;
}

/* Whether it is as near to that neighbour, in cells. */
static inline bool csg_grid_is_near(double coordinate, double near)
{
    const double part = coordinate - floor(coordinate);
    return !(fmin(part, 1 - part) > near);
}

#endif
