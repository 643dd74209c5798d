/* SPDX-License-Identifier: MIT */
#ifndef CSG_POLYHEDRA_JOIN_H
#define CSG_POLYHEDRA_JOIN_H

#include "polyhedra/cell.h"

/* Joins cells as long as two of them have a face in common and are convex together; those that went
 * over to others are left without faces. What is nearer than near coincides. false: out of memory.
 */
bool csg_cells_join(struct csg_cell *cells, size_t num, double near);

#endif
