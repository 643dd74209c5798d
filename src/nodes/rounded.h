/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_ROUNDED_H
#define CSG_NODES_ROUNDED_H

#include "csg/part.h"
#include "nodes/walk.h"

/*
 * hull() of spheres and boxes, and minkowski() with a sphere, whose surfaces are planes, cylinders,
 * cones and spheres. taken: it is such a node, and is in part. false, with a message, when memory
 * is out.
 */
bool csg_rounded_hull(struct csg_walk *walk, uint32_t node, bool in_boolean, struct csg_part *part,
                      bool *taken);
bool csg_rounded_sum(struct csg_walk *walk, uint32_t node, bool in_boolean, struct csg_part *part,
                     bool *taken);

#endif
