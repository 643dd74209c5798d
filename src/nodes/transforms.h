/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_TRANSFORMS_H
#define CSG_NODES_TRANSFORMS_H

/* The nodes that move or colour their children. */

#include "nodes/nodes.h"

csg_enter_fn csg_enter_multmatrix, csg_enter_translate, csg_enter_rotate, csg_enter_scale,
    csg_enter_mirror;

/* The outermost colour whose four components are all >= 0 wins. */
csg_enter_fn csg_enter_color;

/* OpenSCAD shows what is in it as one mesh: colours in it do not count. */
csg_enter_fn csg_enter_render;

/* Bounds how far the map's error may move a point of the box; 0 for an unbounded box. */
double csg_space_rounding(const struct csg_space *space, const struct csg_box *box);

/* Bounds the factor by which the map stretches a length. */
double csg_space_stretch(const struct csg_space *space);

#endif
