/* SPDX-License-Identifier: MIT */
#ifndef CSG_TESTS_FIGURE_H
#define CSG_TESTS_FIGURE_H

#include "plane/drawing.h"

/* Crossings of the ray from p to the right, even or odd. */
static inline bool in_figure(const struct csg_drawing *drawing, const struct csg_figure *figure,
                             double x, double y)
{
    bool inside = false;
    for (uint32_t c = figure->begin; c < figure->end; c++) {
        const struct csg_contour contour = drawing->contours.data[c];
        for (uint32_t i = contour.begin; i < contour.end; i++) {
            const struct csg_vec2 a = drawing->points.data[i];
            const struct csg_vec2 b =
                drawing->points.data[i + 1 < contour.end ? i + 1 : contour.begin];
            if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
    }
    return inside;
}

#endif
