/* SPDX-License-Identifier: MIT */
#include "carrier/directions.h"

#include "carrier/grid.h"
#include "common/hash.h"

/* Directions no face of a real model is aligned with. */
static const struct csg_vec3 generic[2] = {{0.4370160, 0.6180340, 0.6535291},
                                           {0.7236068, -0.5257311, 0.4472136}};

bool csg_direction_is_reversed(struct csg_vec3 n)
{
    return n.x != 0 ? n.x < 0 : n.y != 0 ? n.y < 0 : n.z < 0;
}

int64_t csg_direction_number(struct csg_vec3 n)
{
    const double s = csg_direction_is_reversed(n) ? -1 : 1;
    const double v[3] = {s * n.x + 0.0, s * n.y + 0.0, s * n.z + 0.0}; /* no -0 */
    uint64_t hash = 0;
    for (int i = 0; i < 3; i++)
        hash = csg_hash_double(hash, v[i]);
    return (int64_t)(hash >> 2) + 1;
}

void csg_direction_coordinates(struct csg_vec3 normal, double cell, double coordinates[2])
{
    /* A normal across the generic direction may flip under rounding: its sign says nothing. */
    for (int i = 0; i < 2; i++)
        coordinates[i] = fabs(csg_dot(normal, generic[i])) / cell;
}

/* Cells are numbered from -1, a neighbour's; what is no direction goes to the last one. */
static size_t place_of(int64_t x, int64_t y)
{
    const int64_t last = CSG_NUM_DIRECTIONS - 2;
    return (size_t)((x < last ? x : last) + 1) * CSG_NUM_DIRECTIONS +
           (size_t)((y < last ? y : last) + 1);
}

static void note(struct csg_directions *directions, size_t place, int64_t number)
{
    int64_t *there = &directions->normals[place];
    if (*there != number)
        *there = *there == 0 ? number : -1;
}

void csg_directions_add(struct csg_directions *directions, struct csg_vec3 normal)
{
    double at[2];
    csg_direction_coordinates(normal, CSG_DIRECTION_CELL, at);
    note(directions, place_of(csg_grid_cell(at[0]), csg_grid_cell(at[1])),
         csg_direction_number(normal));
}

void csg_directions_merge(struct csg_directions *to, const struct csg_directions *from)
{
    for (size_t i = 0; i < CSG_NUM_DIRECTIONS * CSG_NUM_DIRECTIONS; i++)
        if (from->normals[i] != 0)
            note(to, i, from->normals[i]);
}

static bool has_other(const struct csg_directions *directions, int64_t x, int64_t y, int64_t number)
{
    const int64_t there = directions->normals[place_of(x, y)];
    return there != 0 && there != number;
}

bool csg_directions_are_shared(const struct csg_directions *directions, struct csg_vec3 normal)
{
    const int64_t number = csg_direction_number(normal);
    double at[2];
    csg_direction_coordinates(normal, CSG_DIRECTION_CELL, at);
    for (int k = 0; k < 9; k++)
        if (has_other(directions, csg_grid_cell(at[0]) + k % 3 - 1,
                      csg_grid_cell(at[1]) + k / 3 - 1, number))
            return true;
    return false;
}

bool csg_directions_nearly_agree(const struct csg_directions *directions, struct csg_vec3 normal)
{
    const int64_t number = csg_direction_number(normal);
    double at[2];
    csg_direction_coordinates(normal, CSG_DIRECTION_CELL, at);
    for (int k = 0; k < 4; k++)
        if (has_other(directions, k & 1 ? csg_grid_neighbour(at[0]) : csg_grid_cell(at[0]),
                      k & 2 ? csg_grid_neighbour(at[1]) : csg_grid_cell(at[1]), number))
            return true;
    return false;
}
