/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_FIGURES_H
#define CSG_NODES_FIGURES_H

/* Nodes that are drawings. */

#include "nodes/nodes.h"
#include "plane/drawing.h"

csg_figure_fn csg_figure_square, csg_figure_circle, csg_figure_polygon, csg_figure_text,
    csg_figure_import,     /* of the drawing in a file */
    csg_figure_projection; /* of the solids in the node */

#endif
