/* SPDX-License-Identifier: MIT */
#ifndef CSG_PREPARE_GATHER_H
#define CSG_PREPARE_GATHER_H

/*
 * Of a node that became several solids, such as an extrusion, or of a render(), OpenSCAD's preview
 * has one mesh. Where that is drawn translucent it is one object here as well, a union below the
 * outermost one, so that the sides where its parts meet do not show. So is a turned profile whose
 * rings, each by itself, are too fine for float: what counts then is how thin its walls are
 * (sharpness/wall.h).
 */

#include "csg/scene.h"

/* Gathers in simplified trees; those that are gathered already stay. false: out of memory. */
bool csg_gather_nodes(struct csgcast_scene *scene);

#endif
