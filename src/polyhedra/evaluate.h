/* SPDX-License-Identifier: MIT */
#ifndef CSG_POLYHEDRA_EVALUATE_H
#define CSG_POLYHEDRA_EVALUATE_H

/* Boolean trees of convex shapes without quadrics as unions of convex sets, each by its corners:
 * what hull and minkowski work on. */

#include "csg/part.h"
#include "polyhedra/clusters.h"

/* Appends the sets; points_only: they need not be convex, it is their hull that counts.
 * CSG_HULL_FLAT: they would be too many, or a surface is none or is cut. */
enum csg_hull_result csg_part_evaluate(const struct csg_part *part, bool points_only,
                                       struct csg_clusters *clusters);

/* Replaces a union of shapes by the points that a singular map takes their corners to. */
enum csg_hull_result csg_part_press(struct csg_part *part, const struct csg_map *map);

#endif
