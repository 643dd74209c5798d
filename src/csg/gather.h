/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_GATHER_H
#define CSG_CSG_GATHER_H

/*
 * Of a node that became several solids, such as an extrusion, or of a render(), OpenSCAD's preview
 * has one mesh. Where that is drawn translucent it is one object here as well, a union below the
 * outermost one, so that the sides where its parts meet do not show.
 */

#include "csg/scene.h"

/* Whether both leaves are of one node of the text, or in one render(). */
bool csg_is_same_node(const struct csgcast_scene *scene, uint32_t a, uint32_t b);

/* Gathers in simplified trees; those that are gathered already stay. false: out of memory. */
bool csg_gather_nodes(struct csgcast_scene *scene);

#endif
