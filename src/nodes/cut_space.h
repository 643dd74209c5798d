/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_CUT_SPACE_H
#define CSG_NODES_CUT_SPACE_H

#include "nodes/walk.h"
#include "polyhedra/cut.h"

/*
 * The space in which OpenSCAD cuts the faces of a polyhedron that are not plane: where it first
 * meets another solid, for up to there only its points are mapped. false, with a message, when
 * memory is out.
 */
bool csg_cut_space_find(struct csg_walk *walk, uint32_t node, struct csg_cut_space *space);

#endif
