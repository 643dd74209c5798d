/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_DIRECTIONS_H
#define CSG_CARRIER_DIRECTIONS_H

/* Where a scene's planes look: in most models no two normals nearly agree, so that nobody needs to
 * look for a plane under another normal. A plane and its reverse have one direction. */

#include <stdbool.h>
#include <stdint.h>

#include "solids/shape.h"

/* Cells of directions a side, one more on each. */
#define CSG_NUM_DIRECTIONS 36

/* By direction: 0, the number of the only normal that lies there, or -1 for several.
 * Zero-initialise it. */
struct csg_directions {
    int64_t normals[CSG_NUM_DIRECTIONS * CSG_NUM_DIRECTIONS];
};

/* A number, not 0, of a normal's bits, the same for its reverse. Different ones may share it. */
int64_t csg_direction_number(struct csg_vec3 normal);

/* Whether that normal, and not its reverse, is turned for its number. */
bool csg_direction_is_reversed(struct csg_vec3 normal);

/* Side of the widest cells of directions that are of use. */
#define CSG_DIRECTION_CELL (1.0 / 32)

/* In cells of that side, the same for the reverse. Those of normals that differ by a vector differ
 * by its length at most. */
void csg_direction_coordinates(struct csg_vec3 normal, double cell, double coordinates[2]);

void csg_directions_add(struct csg_directions *directions, struct csg_vec3 normal);
void csg_directions_merge(struct csg_directions *to, const struct csg_directions *from);

/* Whether other normals are in the cell of the normal or in one next to it. */
bool csg_directions_are_shared(const struct csg_directions *directions, struct csg_vec3 normal);

/* The same of the nearest neighbours only. */
bool csg_directions_nearly_agree(const struct csg_directions *directions, struct csg_vec3 normal);

#endif
