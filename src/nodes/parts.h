/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_PARTS_H
#define CSG_NODES_PARTS_H

#include "csg/part.h"
#include "nodes/walk.h"

/* Of a turn, a cylinder or a sphere that another node works on. */
#define CSG_OPERAND_MAX_FRAGMENTS 10000

/* Compounds inside of compounds: after so many levels the next ones get a stack of their own, so
 * that their number is limited by memory only. */
#define CSG_PARTS_LEVELS_A_STACK 64

enum csg_part_wanted {
    CSG_WANT_EXACT,
    CSG_WANT_AROUND, /* what is wanted of the compound itself, which only moves what it reads */
    CSG_WANT_FACETS, /* no shape has a quadric; what cannot be facetted is reported and left out */
    CSG_WANT_POINTS, /* facets, but a mesh that nothing is cut from is only its points: a surface
                      * that may be open or flat */
};

/* Reads the union of the solids at [begin, end), neighbours in one node. false, with a message,
 * when memory is out. */
bool csg_part_read(struct csg_walk *walk, uint32_t begin, uint32_t end, bool in_boolean,
                   enum csg_part_wanted wanted, struct csg_part *part);

#endif
