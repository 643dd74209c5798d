/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_FLATTEN_H
#define CSG_NODES_FLATTEN_H

/* Nodes that make a new drawing of the one in them. */

#include "nodes/walk.h"
#include "plane/drawing.h"

csg_flatten_fn csg_flatten_hull, csg_flatten_offset, csg_flatten_minkowski, csg_flatten_resize,
    csg_flatten_fill;

#endif
