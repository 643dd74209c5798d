/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_TWIST_H
#define CSG_PLANE_TWIST_H

/* linear_extrude with twist, or with different scales along x and y: no planes and quadrics but the
 * closed mesh that OpenSCAD 2021.01 makes of it. */

#include "plane/sweep.h"
#include "polyhedra/mesh.h"
#include "solids/facets.h"

struct csg_twist {
    double z0, z1;
    double degrees;  /* clockwise, seen from above, from the bottom to the top */
    double scale[2]; /* of the top, not negative */
    int slices;      /* 0: counted by facets */
    struct csg_facets facets;
};

/* Meshes with more faces are refused: they take 4 GB, and openscad as much. */
#define CSG_TWIST_MAX_FACES 5000000

/* How many faces the sides of the mesh over the last figure of the drawing have. */
double csg_twist_num_faces(const struct csg_twist *twist, const struct csg_drawing *drawing);

/* Adds the mesh over the last figure of the drawing, an outline of csg_drawing_evaluate. */
enum csg_sweep_result csg_twist_fill(struct csg_mesh *mesh, const struct csg_drawing *drawing,
                                     const struct csg_twist *twist);

#endif
