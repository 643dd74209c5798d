/* SPDX-License-Identifier: MIT */
#include "plane/drawing.h"

#include <stdlib.h>

void csg_drawing_finish(struct csg_drawing *drawing)
{
    free(drawing->nodes.data);
    free(drawing->figures.data);
    free(drawing->contours.data);
    free(drawing->points.data);
    *drawing = (struct csg_drawing){0};
}

bool csg_drawing_open(struct csg_drawing *drawing, enum csg_draw_op op)
{
    const uint32_t end = (uint32_t)drawing->nodes.num + 1;
    return csg_array_push(&drawing->nodes, ((struct csg_draw_node){.op = (uint8_t)op, .end = end}));
}

bool csg_drawing_add_figure(struct csg_drawing *drawing, double rounding)
{
    const uint32_t first = (uint32_t)drawing->contours.num;
    const struct csg_draw_node node = {.op = CSG_DRAW_FIGURE,
                                       .figure = (uint32_t)drawing->figures.num,
                                       .end = (uint32_t)drawing->nodes.num + 1};
    const struct csg_figure figure = {
        .begin = first, .end = first, .disc = csg_map_identity, .rounding = rounding};
    return csg_array_push(&drawing->figures, figure) && csg_array_push(&drawing->nodes, node);
}

bool csg_drawing_add_contour(struct csg_drawing *drawing)
{
    const uint32_t first = (uint32_t)drawing->points.num;
    if (!csg_array_push(&drawing->contours, ((struct csg_contour){first, first})))
        return false;
    drawing->figures.data[drawing->figures.num - 1].end = (uint32_t)drawing->contours.num;
    return true;
}

bool csg_drawing_add_point(struct csg_drawing *drawing, double x, double y)
{
    if (!csg_array_push(&drawing->points, ((struct csg_vec2){x, y})))
        return false;
    drawing->contours.data[drawing->contours.num - 1].end = (uint32_t)drawing->points.num;
    return true;
}

bool csg_drawing_append_figure(struct csg_drawing *drawing, const struct csg_drawing *from,
                               const struct csg_figure *figure)
{
    bool ok = csg_drawing_add_figure(drawing, figure->rounding);
    for (size_t i = 0; i < from->contours.num && ok; i++) {
        const struct csg_contour *contour = &from->contours.data[i];
        ok = csg_drawing_add_contour(drawing);
        for (uint32_t k = contour->begin; k < contour->end && ok; k++)
            ok = csg_drawing_add_point(drawing, from->points.data[k].x, from->points.data[k].y);
    }
    if (ok) {
        struct csg_figure *added = &drawing->figures.data[drawing->figures.num - 1];
        added->facetted = figure->facetted;
        added->is_outline = true;
    }
    return ok;
}

void csg_drawing_drop(struct csg_drawing *drawing, uint32_t node)
{
    uint32_t first = (uint32_t)drawing->figures.num;
    for (size_t i = node; i < drawing->nodes.num; i++)
        if (drawing->nodes.data[i].op == CSG_DRAW_FIGURE && drawing->nodes.data[i].figure < first)
            first = drawing->nodes.data[i].figure;
    drawing->nodes.num = node;
    if (first == drawing->figures.num)
        return;
    const uint32_t contour = drawing->figures.data[first].begin;
    if (contour < drawing->contours.num)
        drawing->points.num = drawing->contours.data[contour].begin;
    drawing->contours.num = contour;
    drawing->figures.num = first;
}

uint32_t csg_drawing_only(const struct csg_drawing *drawing, uint32_t node)
{
    const struct csg_draw_node *nodes = drawing->nodes.data;
    const uint32_t end = nodes[node].end;
    while (nodes[node].op != CSG_DRAW_FIGURE && node + 1 < end && nodes[node + 1].end == end)
        node++;
    return node;
}

double csg_drawing_rounding(const struct csg_drawing *drawing, uint32_t begin, uint32_t end)
{
    double rounding = 0;
    for (uint32_t i = begin; i < end; i++)
        if (drawing->nodes.data[i].op == CSG_DRAW_FIGURE)
            rounding =
                fmax(rounding, drawing->figures.data[drawing->nodes.data[i].figure].rounding);
    return rounding;
}

bool csg_drawing_is_facetted(const struct csg_drawing *drawing, uint32_t begin, uint32_t end)
{
    for (uint32_t i = begin; i < end; i++) {
        const struct csg_draw_node *node = &drawing->nodes.data[i];
        if (node->op == CSG_DRAW_FIGURE && (drawing->figures.data[node->figure].facetted ||
                                            drawing->figures.data[node->figure].is_disc))
            return true;
    }
    return false;
}

bool csg_figure_is_round(const struct csg_figure *figure, double *radius)
{
    const double(*m)[4] = figure->disc.m;
    *radius = hypot(m[0][0], m[1][0]);
    return figure->is_disc && fabs(hypot(m[0][1], m[1][1]) - *radius) <= 1e-12 * *radius &&
           fabs(m[0][0] * m[0][1] + m[1][0] * m[1][1]) <= 1e-12 * *radius * *radius;
}

static void map_figure(struct csg_drawing *drawing, struct csg_figure *figure,
                       const struct csg_map *map)
{
    figure->disc = csg_map_multiply(map, &figure->disc);
    figure->is_outline = figure->is_outline && csg_map_determinant(map) > 0;
    for (uint32_t i = figure->begin; i < figure->end; i++)
        for (uint32_t j = drawing->contours.data[i].begin; j < drawing->contours.data[i].end; j++) {
            struct csg_vec2 *at = &drawing->points.data[j];
            const struct csg_vec3 p = csg_map_point(map, csg_vec3(at->x, at->y, 0));
            *at = (struct csg_vec2){p.x, p.y};
        }
}

bool csg_drawing_map(struct csg_drawing *drawing, uint32_t begin, uint32_t end,
                     const struct csg_map *map, double stretch)
{
    bool *done = calloc(drawing->figures.num + 1, sizeof *done);
    if (!done)
        return false;
    for (uint32_t i = begin; i < end; i++) {
        const struct csg_draw_node *node = &drawing->nodes.data[i];
        if (node->op != CSG_DRAW_FIGURE || done[node->figure])
            continue;
        map_figure(drawing, &drawing->figures.data[node->figure], map);
        drawing->figures.data[node->figure].rounding *= stretch;
        done[node->figure] = true;
    }
    free(done);
    return true;
}

struct csg_box csg_figure_written(const struct csg_drawing *drawing,
                                  const struct csg_figure *figure)
{
    struct csg_box box = csg_box_empty;
    for (uint32_t i = figure->begin; i < figure->end; i++)
        for (uint32_t j = drawing->contours.data[i].begin; j < drawing->contours.data[i].end; j++)
            csg_box_extend(&box, csg_vec3(drawing->points.data[j].x, drawing->points.data[j].y, 0));
    return box;
}

double csg_contour_twice_area(const struct csg_drawing *drawing, const struct csg_contour *contour)
{
    const struct csg_vec2 *p = drawing->points.data;
    double area = 0;
    for (uint32_t i = contour->begin; i < contour->end; i++) {
        const uint32_t j = i + 1 < contour->end ? i + 1 : contour->begin;
        area += p[i].x * p[j].y - p[j].x * p[i].y;
    }
    return area;
}
