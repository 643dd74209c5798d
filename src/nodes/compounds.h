/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_COMPOUNDS_H
#define CSG_NODES_COMPOUNDS_H

/* Nodes that become several shapes. */

#include "csg/part.h"
#include "nodes/walk.h"

csg_compound_fn csg_compound_linear_extrude, csg_compound_rotate_extrude, csg_compound_polyhedron,
    csg_compound_hull, csg_compound_minkowski, csg_compound_resize, csg_compound_import,
    csg_compound_surface, csg_compound_slab; /* a drawing by itself */

#endif
