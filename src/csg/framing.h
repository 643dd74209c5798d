/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_FRAMING_H
#define CSG_CSG_FRAMING_H

/*
 * What OpenSCAD's viewall frames (CSGProduct::getBoundingBox, 2021.01): the vertices of every solid
 * that is not subtracted, % and # included, without clipping intersections. Of a render() node it
 * is the mesh of what is left in it.
 */

#include "csg/scene.h"

/* Puts scene->wholes in order, which all below ask for. */
void csg_sort_wholes(struct csgcast_scene *scene);

/* The render() node that a leaf is in; NULL: none. */
const struct csg_whole *csg_find_whole(const struct csgcast_scene *scene, uint32_t leaf);

/* Of OpenSCAD's vertices of the leaf, in world space. */
struct csg_box csg_written_box(const struct csg_leaf *leaf);

/* Fills scene->written but for what is in render() nodes, from the simplified trees. */
void csg_framing_start(struct csgcast_scene *scene);

/* Adds what is in those nodes, to a thousandth of the size of all, along the scene's axes. Needs
 * carriers. false: out of memory. */
bool csg_framing_finish(struct csgcast_scene *scene);

#endif
