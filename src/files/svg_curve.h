/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_SVG_CURVE_H
#define CSG_FILES_SVG_CURVE_H

/* Curves of SVG's paths, as the points that OpenSCAD makes of them. */

#include "files/svg_path.h"

/* A Bezier curve: degree + 1 points, of which the first is in the path already. degree: 2 or 3. */
void csg_svg_add_curve(struct csg_svg_paths *paths, const struct csg_vec2 *p, int degree);

struct csg_svg_arc {
    double rx, ry, turn; /* degrees of the x axis */
    bool is_large, is_sweep;
};

/* From a to b. An arc without a radius, or whose ends are one, has no points. */
void csg_svg_add_arc(struct csg_svg_paths *paths, const struct csg_svg_arc *arc, struct csg_vec2 a,
                     struct csg_vec2 b);

#endif
