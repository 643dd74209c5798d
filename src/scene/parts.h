/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_PARTS_H
#define CSG_SCENE_PARTS_H

#include "csg/part.h"
#include "scene/walk.h"

/* Compounds inside of compounds inside of ... deeper than this are refused. */
#define CSG_PARTS_MAX_DEPTH 64

/*
 * Reads the union of the solids at [begin, end), neighbours in one node. Unless exact it is made of
 * OpenSCAD's facets: no shape has a quadric, and what cannot be facetted is reported and left out.
 * false, with a message, when memory is out.
 */
bool csg_part_read(struct csg_walk *walk, uint32_t begin, uint32_t end, bool in_boolean, bool exact,
                   struct csg_part *part);

#endif
