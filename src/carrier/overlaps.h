/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_OVERLAPS_H
#define CSG_CARRIER_OVERLAPS_H

/*
 * Which faces of a surface may lie upon another one of it, in part: triangles of both are near each
 * other's plane and over each other. Neighbours that meet in an edge or a corner only are none, so
 * that of most meshes no face is one.
 */

#include "mesh/surface.h"

/* Sets near, by plane, to 1 where a face may be one and to 0 elsewhere; to 1 everywhere where that
 * takes longer to tell than it spares. tolerance: how far faces that coincide may be from each
 * other. Asks for extents and hierarchy. false: out of memory. */
bool csg_overlaps_find(const struct csg_surface *surface, double tolerance, int num_threads,
                       uint8_t *near);

#endif
