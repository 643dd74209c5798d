/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_SCAN_H
#define CSG_TILE_SCAN_H

/*
 * A tile's tree as steps in the order in which rays come upon its operands. What is subtracted
 * from an intersection does not matter before its first key; where the steps are sorted by that,
 * a program that looks for something nearer can stop (CSG_RECORD_BOUND).
 */

#include "csg/program.h"
#include "tile/range.h"

/* Zero-initialise it. */
struct csg_scan {
    struct csg_program program;
    struct csg_program_room room;
    CSG_ARRAY(double) bounds; /* per step; of a BOUND: where what follows begins */
    CSG_ARRAY(double) starts; /* per node: no ray is outside of its set before */
    CSG_ARRAY(struct csg_scan_operand {
        double start;
        uint32_t node;
    })
    operands;
};

void csg_scan_finish(struct csg_scan *scan);

/*
 * Fills program and bounds. ranges: of the terms' leaves, in the tile. bounded: whether there may
 * be bounds; they hold for rays that start outside. false: out of memory.
 */
bool csg_scan_fill(struct csg_scan *scan, const struct csg_terms *terms,
                   const struct csg_tree *tree, const struct csg_leaf_range *ranges, bool bounded);

#endif
