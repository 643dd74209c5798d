/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMPARE_COMPARE_H
#define CSG_COMPARE_COMPARE_H

/*
 * One view of a mesh against csgcast's picture of the same view. Edge pixels may differ. So may a
 * pixel where csgcast shows what the mesh shows a fiftieth of a pixel aside: there an edge passes
 * so close to the pixel's centre that float and double need not agree ("thin").
 */

#include "compare/mesh_view.h"

enum csg_verdict {
    CSG_VERDICT_SAME,
    CSG_VERDICT_EDGE,  /* hit against miss, on an edge pixel */
    CSG_VERDICT_THIN,  /* explained by an edge within a fiftieth of a pixel */
    CSG_VERDICT_SKIN,  /* the nearer of two faces of the mesh that lie upon each other */
    CSG_VERDICT_OFF,   /* hit against miss anywhere else */
    CSG_VERDICT_DEPTH, /* both hit, too far apart */
};

struct csg_compare_tolerance {
    double depth;    /* of z, relative */
    double absolute; /* of z, scene units; above 0 it replaces depth */
    double rounding; /* scene units along the normal: what six digits in a .csg do to a surface */
    double sagitta;  /* scene units along the normal; 0: as written */
};

struct csg_errors {
    double mean, p99, p999, max;
    int x, y; /* the pixel of max */
};

struct csg_comparison {
    size_t num_hits, num_edges;           /* of the mesh */
    size_t num_missing, num_extra;        /* hits of the mesh only, of csgcast only */
    size_t num_edge_mismatches, num_thin; /* allowed */
    size_t num_off, num_depth;            /* not allowed */
    /* Of pixels that both hit, off the edges: */
    size_t num_compared;
    struct csg_errors depth;    /* |z - z_mesh|, scene units */
    struct csg_errors relative; /* |z - z_mesh| / z_mesh */
    struct csg_errors offset;   /* |z - z_mesh| |n . dir|: across the surface, scene units */
    struct csg_errors normal;   /* degrees, to the next of the 3x3 pixels around */
    double rms_offset;
    uint8_t *verdicts; /* width * height of enum csg_verdict; the caller frees */
};

/* Hits of both over hits of either; 1 where there are none. */
double csg_comparison_iou(const struct csg_comparison *comparison);

/* image: csgcast's z and normal. false: out of memory. */
bool csg_compare(const struct csg_mesh_view *view, const struct csgcast_image *image,
                 const struct csg_compare_tolerance *tolerance, struct csg_comparison *result);

#endif
