/* SPDX-License-Identifier: MIT */
#include "plane/resize.h"

#include "plane/outline.h"
#include "plane/piece.h"

void csg_resize_factors(const double *newsize, const bool *automatic, const double *size, int num,
                        double *factors)
{
    int largest = 0;
    for (int i = 1; i < num; i++)
        if (newsize[i] > newsize[largest])
            largest = i;
    for (int i = 0; i < num; i++)
        factors[i] = newsize[i] > 0 ? newsize[i] / size[i] : 1;
    const double automatically = factors[largest];
    for (int i = 0; i < num; i++)
        if (automatic[i] && !(newsize[i] > 0))
            factors[i] = automatically;
}

void csg_resize_factors_signed(const double *newsize, const bool *automatic, const double *size,
                               int num, double *factors)
{
    int largest = 0;
    for (int i = 1; i < num; i++)
        if (newsize[i] != 0 && newsize[i] > newsize[largest])
            largest = i;
    const double automatically = newsize[largest] != 0 ? newsize[largest] / size[largest] : 1;
    for (int i = 0; i < num; i++)
        factors[i] = newsize[i] != 0 ? newsize[i] / size[i] : automatic[i] ? automatically : 1;
}

enum csg_sweep_result csg_drawing_resize(struct csg_drawing *drawing, uint32_t node,
                                         const double newsize[2], const bool automatic[2])
{
    struct csg_pieces pieces = {0};
    struct csg_box box = csg_box_empty;
    struct csg_map map = csg_map_identity;
    const enum csg_sweep_result result = csg_pieces_cut(&pieces, drawing, node);
    for (size_t i = 0; i < pieces.corners.num; i++)
        csg_box_extend(&box, csg_vec3(pieces.corners.data[i].x, pieces.corners.data[i].y, 0));
    csg_pieces_finish(&pieces);
    if (result != CSG_SWEEP_DONE || csg_box_is_empty(&box))
        return result;
    const double size[2] = {box.hi.x - box.lo.x, box.hi.y - box.lo.y};
    double factors[2];
    csg_resize_factors(newsize, automatic, size, 2, factors);
    map.m[0][0] = factors[0];
    map.m[1][1] = factors[1];
    return csg_drawing_map(drawing, node, (uint32_t)drawing->nodes.num, &map,
                           fmax(factors[0], factors[1]))
               ? CSG_SWEEP_DONE
               : CSG_SWEEP_NO_MEMORY;
}

/* Each outer contour becomes a figure: islands in holes are covered by what is around them. */
enum csg_sweep_result csg_drawing_fill(struct csg_drawing *drawing, uint32_t node)
{
    const enum csg_sweep_result result = csg_drawing_evaluate(drawing, node);
    if (result != CSG_SWEEP_DONE)
        return result;
    const struct csg_figure figure = drawing->figures.data[drawing->nodes.data[node].figure];
    csg_drawing_cut(drawing, node);
    bool ok = csg_drawing_open(drawing, CSG_DRAW_UNION);
    for (uint32_t i = figure.begin; i < figure.end && ok; i++) {
        const struct csg_contour contour = drawing->contours.data[i];
        if (csg_contour_twice_area(drawing, &contour) <= 0)
            continue;
        ok = csg_drawing_add_figure(drawing, figure.rounding) && csg_drawing_add_contour(drawing);
        for (uint32_t j = contour.begin; j < contour.end && ok; j++)
            ok = csg_drawing_add_point(drawing, drawing->points.data[j].x,
                                       drawing->points.data[j].y);
        if (ok)
            drawing->figures.data[drawing->figures.num - 1].facetted = figure.facetted;
    }
    if (ok)
        csg_drawing_close(drawing, node);
    return ok ? CSG_SWEEP_DONE : CSG_SWEEP_NO_MEMORY;
}
