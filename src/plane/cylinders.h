/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_CYLINDERS_H
#define CSG_PLANE_CYLINDERS_H

#include "csg/part.h"

/*
 * Where all shapes of from are right circular cylinders between the same two planes, adds their
 * convex hull to part and sets taken. false: out of memory.
 */
bool csg_disc_hull(struct csg_part *part, const struct csg_part *from, bool *taken);

#endif
