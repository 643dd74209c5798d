/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_PRISM_SURFACE_H
#define CSG_PLANE_PRISM_SURFACE_H

/* A prism over a polygon of many corners, as one solid bounded by triangles. */

#include "plane/drawing.h"
#include "plane/prism.h"

enum csg_prism_result {
    CSG_PRISM_DONE,
    CSG_PRISM_NONE, /* its triangles would not close, or it has a tip: cut it into convex pieces */
    CSG_PRISM_NO_MEMORY,
};

/* Over the figure of that node. shape is zeroed. */
enum csg_prism_result csg_prism_surface(struct csg_shape *shape, const struct csg_drawing *drawing,
                                        uint32_t node, const struct csg_lift *lift);

#endif
