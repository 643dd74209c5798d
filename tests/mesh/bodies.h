/* SPDX-License-Identifier: MIT */
#ifndef MESH_BODIES_H
#define MESH_BODIES_H

/* Polyhedra as .csg text. */

#include <stdbool.h>

#include "ideal/text.h"

/* A solid made of some of the unit cubes of a block of side^3, its corner at the origin. */
enum { VOXEL_SIDE = 3 };
struct voxels {
    bool cell[VOXEL_SIDE][VOXEL_SIDE][VOXEL_SIDE];
};

struct voxels voxels_random(struct dice *dice);

/* As a union of cubes, and as one polyhedron whose faces are cut into cuts^2 squares each. The
 * cubes do not overlap, so edges may belong to four faces. */
void voxels_put_cubes(struct text *text, const struct voxels *voxels);
void voxels_put_polyhedron(struct text *text, const struct voxels *voxels, int cuts);

/* A closed tube of n by m corners along a random closed curve: knotted, and now and then through
 * itself; 4 units large, about the origin. */
void tube_put(struct text *text, int n, int m, struct dice *dice);

/* A wedge of 50 by 50 by 10 units whose bottom and top are n slivers each, from its edge on z. */
void fan_put(struct text *text, int n);

#endif
