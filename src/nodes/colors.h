/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_COLORS_H
#define CSG_NODES_COLORS_H

#include "solids/value.h"

/*
 * The colour of a color() node: c as [r, g, b] or [r, g, b, a], as "#rgb", "#rgba", "#rrggbb",
 * "#rrggbbaa" or as the name of a CSS colour, and alpha. A component that is not said is negative,
 * alpha then 1. false: a message was given.
 */
bool csg_color_read(const struct csg_args *args, float color[4]);

#endif
