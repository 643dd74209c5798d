/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_WHOLES_H
#define CSG_CSG_WHOLES_H

/* The leaves that are in render() nodes. */

#include "csg/scene.h"

/* Puts scene->wholes in order, which the others ask for. */
void csg_sort_wholes(struct csgcast_scene *scene);

/* The render() node that a leaf is in; NULL: none. */
const struct csg_whole *csg_find_whole(const struct csgcast_scene *scene, uint32_t leaf);

/* Whether both leaves are of one node of the text, or in one render(). */
bool csg_is_same_node(const struct csgcast_scene *scene, uint32_t a, uint32_t b);

#endif
