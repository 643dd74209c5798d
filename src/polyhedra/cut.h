/* SPDX-License-Identifier: MIT */
#ifndef CSG_POLYHEDRA_CUT_H
#define CSG_POLYHEDRA_CUT_H

/*
 * How a face that is not plane is cut into triangles: as OpenSCAD 2021.01 does it
 * (GeometryUtils.cc, libtess2), for the solid is not defined by the file alone. The face is
 * projected along the longest axis of its normal, swept into triangles (tess/module.h), and edges
 * are flipped until the triangles are nearly Delaunay's. All of it in float.
 */

#include <stdint.h>

#include "common/array.h"
#include "common/linear.h"

struct csg_tess_module;

/* Where faces are cut, which decides their triangles. */
struct csg_cut_space {
    struct csg_map map; /* to there */
    bool on_grid;       /* OpenSCAD moves points to its grid first, for CGAL's Booleans */
    bool in_sum;        /* it is an operand of minkowski that meets the others */
    bool reversed;      /* OpenSCAD has the corners of a face in the other order, before the map */
};

/* Whether OpenSCAD has the corners in the other order there. */
bool csg_cut_space_is_reversed(const struct csg_cut_space *space);

/* One face after the other; zero-initialise it. */
struct csg_cutter {
    const struct csg_cut_space *space;    /* NULL: that of the points */
    const uint32_t *numbers;              /* of the points in OpenSCAD; NULL: not known */
    const struct csg_tess_module *module; /* once it was needed */
    bool was_opened;
    size_t num_guessed; /* faces cut otherwise: four corners by the shorter diagonal, else a fan */
    uint32_t (*triangles)[3]; /* of the last face: its corners, from 0 on */
    size_t num_triangles;
    float (*corners)[3], (*projected)[2];
    size_t room; /* for so many corners */
};

void csg_cutter_finish(struct csg_cutter *cutter);

/* Cuts the face with the corners points[face[0]], points[face[1]]... false: out of memory. */
bool csg_cutter_cut(struct csg_cutter *cutter, const struct csg_vec3 *points, const uint32_t *face,
                    uint32_t num);

/* Of a face of four corners that crosses itself, by their numbers in OpenSCAD: which one is cut off
 * first. */
int csg_crossed_corner(const uint32_t numbers[4]);

/* Flips edges between triangles, counter-clockwise by their corners, while the angles that face the
 * edge are more than 180 degrees and 0.01 radians. false: out of memory. */
bool csg_flip_edges(const float (*points)[2], uint32_t (*triangles)[3], size_t num);

#endif
