/* SPDX-License-Identifier: MIT */
#ifndef CSG_PREPARE_FRAMING_H
#define CSG_PREPARE_FRAMING_H

/*
 * What OpenSCAD's viewall frames (CSGProduct::getBoundingBox, 2021.01): the vertices of every solid
 * that is not subtracted, % and # included, without clipping intersections. Of a render() node it
 * is the mesh of what is left in it.
 */

#include "csg/scene.h"

/* Of OpenSCAD's vertices of the leaf, in world space. */
struct csg_box csg_written_box(const struct csg_leaf *leaf);

/* Fills scene->written but for what is in render() nodes, from the simplified trees. */
void csg_framing_start(struct csgcast_scene *scene);

/* Adds what is in those nodes, to a thousandth of the size of all, along the scene's axes. Needs
 * carriers. false: out of memory. */
bool csg_framing_finish(struct csgcast_scene *scene);

#endif
