/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_FIGURES_H
#define CSG_NODES_FIGURES_H

/* square, circle and polygon: each reads its arguments and adds its figure to a drawing, or an
 * empty union where it is empty. false, with a message, when memory is out. */

#include "nodes/nodes.h"
#include "plane/drawing.h"

bool csg_figure_square(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       const struct csg_space *space, struct csg_drawing *drawing);
bool csg_figure_circle(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       const struct csg_space *space, struct csg_drawing *drawing);
bool csg_figure_polygon(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                        const struct csg_space *space, struct csg_drawing *drawing);
/* Of the drawing in a file. */
bool csg_figure_import(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       const struct csg_space *space, struct csg_drawing *drawing);
/* Of the solids in the node. */
bool csg_figure_projection(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                           const struct csg_space *space, struct csg_drawing *drawing);

#endif
