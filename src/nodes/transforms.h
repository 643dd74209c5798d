/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_TRANSFORMS_H
#define CSG_NODES_TRANSFORMS_H

/* The nodes that move or colour their children; each is the enter of a csg_node_ops. */

#include "nodes/nodes.h"

bool csg_enter_multmatrix(const struct csg_args *args, struct csg_space *space);
bool csg_enter_translate(const struct csg_args *args, struct csg_space *space);
bool csg_enter_rotate(const struct csg_args *args, struct csg_space *space);
bool csg_enter_scale(const struct csg_args *args, struct csg_space *space);
bool csg_enter_mirror(const struct csg_args *args, struct csg_space *space);

/* The outermost colour whose four components are all >= 0 wins. */
bool csg_enter_color(const struct csg_args *args, struct csg_space *space);

/* OpenSCAD shows what is in it as one mesh: colours in it do not count. */
bool csg_enter_render(const struct csg_args *args, struct csg_space *space);

/* Bounds how far the map's error may move a point of the box; 0 for an unbounded box. */
double csg_space_rounding(const struct csg_space *space, const struct csg_box *box);

/* Bounds the factor by which the map stretches a length. */
double csg_space_stretch(const struct csg_space *space);

#endif
