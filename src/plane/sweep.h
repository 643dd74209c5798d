/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_SWEEP_H
#define CSG_PLANE_SWEEP_H

/*
 * What a drawing covers, cut into horizontal slabs: the levels are the heights of all corners and
 * crossings, and between two neighbouring levels no edges cross. Edges keep the numbers they came
 * with, so whatever is made of two neighbouring spans shares its sides to the last bit.
 *
 * Nothing can go wrong in the topology: heights closer than the noise of double are one level, an
 * edge counts from level to level, so the edges of a closed contour cross every slab an even number
 * of times, and the order within a slab is that at its middle.
 */

#include "plane/drawing.h"

struct csg_sweep_edge {
    struct csg_vec2 low, high; /* low.y <= high.y */
    uint32_t begin, end;       /* its levels; begin < end */
    uint32_t figure;
    bool is_down; /* its contour runs from high to low */
};

/* Inside, from the edge left to the edge right, in the slab above level. */
struct csg_sweep_span {
    uint32_t level;
    uint32_t left, right;
};

/* Zero-initialise it. */
struct csg_sweep {
    CSG_ARRAY(struct csg_sweep_edge) edges;
    CSG_ARRAY(double) levels;
    CSG_ARRAY(struct csg_sweep_span) spans; /* by level, then by x */
    double size;                            /* the largest coordinate */
};

/* Differences below this share of the largest coordinate are noise: what offset() leaves between
 * two of its corners that are meant to be at one height. */
#define CSG_SWEEP_NOISE 1e-12

/* A drawing may not have more edges, nor the slabs more spans; beyond them it is not swept. */
#define CSG_SWEEP_MAX_EDGES 200000
#define CSG_SWEEP_MAX_SPANS 2000000

/* Products of larger coordinates are not numbers any more. */
#define CSG_SWEEP_MAX_SIZE 1e100

enum csg_sweep_result { CSG_SWEEP_DONE, CSG_SWEEP_TOO_LARGE, CSG_SWEEP_NO_MEMORY };

/* Sweeps the subtree at node, discs as their facets. */
enum csg_sweep_result csg_sweep(struct csg_sweep *sweep, const struct csg_drawing *drawing,
                                uint32_t node);
void csg_sweep_finish(struct csg_sweep *sweep);

/* x of an edge at one of its levels: where a corner is there, its very x. */
double csg_sweep_x(const struct csg_sweep *sweep, uint32_t edge, uint32_t level);

/* Index of the last of num ascending values that is not above limit; 0 where all are. */
size_t csg_sweep_last_up_to(const double *values, size_t num, double limit);

#endif
