/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_OWN_FACES_H
#define CSG_CARRIER_OWN_FACES_H

/*
 * Which faces of one surface lie upon each other. That is found once, in the surface's own space,
 * and holds for all of its copies, wherever they are. Where no other solid comes near (remote.h)
 * there is nothing else to find, and a copy has no carriers of its own in memory.
 */

#include "mesh/surface.h"
#include "solids/shape.h"

/* Fills own and num_own of a surface whose extents and hierarchy are there. false: out of
 * memory. */
bool csg_own_faces_find(struct csg_surface *surface, const struct csg_box *box, int num_threads);

/* The plane of one face in a place, whose inverse is given. */
struct csg_plane csg_own_plane(const struct csg_surface *surface, uint32_t face,
                               const struct csg_map *inverse);

#endif
