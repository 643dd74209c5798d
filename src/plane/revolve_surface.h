/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_REVOLVE_SURFACE_H
#define CSG_PLANE_REVOLVE_SURFACE_H

/* A profile of many corners turned in flat segments, as one solid bounded by OpenSCAD's faces. */

#include "plane/revolve.h"
#include "polyhedra/mesh.h"

/* The faces that the last figure of the drawing, an outline of csg_drawing_evaluate, sweeps over.
 * mesh and gaps are zeroed; mesh stays empty where nothing, or too much, would come of it. false:
 * out of memory. */
bool csg_revolve_mesh(struct csg_mesh *mesh, struct csg_mesh_gaps *gaps,
                      const struct csg_drawing *drawing, const struct csg_profile *profile,
                      const struct csg_turn *turn, double rounding);

/* Turns the last figure of the drawing, an outline of csg_drawing_evaluate. shape is zeroed and
 * stays so where nothing, or too much, would come of it. false: out of memory. */
bool csg_revolve_surface(struct csg_shape *shape, const struct csg_drawing *drawing,
                         const struct csg_profile *profile, const struct csg_turn *turn,
                         double rounding);

#endif
