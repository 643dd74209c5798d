/* SPDX-License-Identifier: MIT */
#include "plane/offset.h"

#include <stdlib.h>

#include "plane/outline.h"
#include "solids/facets.h"

/*
 * Moved outwards, a region grows by a rectangle along each edge of its outline and a join at each
 * corner that sticks out; moved inwards it loses a rectangle along each edge and a join at each
 * corner that sticks in. That is the region's Minkowski sum with a disc, or the complement of the
 * complement's; mitered and square joins only differ at the corners.
 *
 * The outline, its edges moved and joined, goes round a point as often as the outline itself does
 * and, outwards, once more for each rectangle and join that the point is in: the cycles of all of
 * them add up to it. Inwards it is once less. So what it goes round is the moved region (Chen and
 * McMains, Polygon offsetting by computing winding numbers, 2005).
 */

/* A corner that turns by less is joined by facets also where discs are wanted: with them a facetted
 * circle would become a disc for each of its corners. */
#define SHARP_DEGREES 20.0

/* What Clipper allows a mitered corner, in units of the distance. */
#define MITER_LIMIT 1e6

/* OpenSCAD 2021.01 hands Clipper its lengths times this; Clipper takes arcs at least as fine as
 * that part of the distance. */
#define CLIPPER_SCALE 65536.0
#define CLIPPER_MAX_TOLERANCE 0.25

#define PI 3.14159265358979323846264338327950288

struct corner {
    struct csg_vec2 before, at, after;
    struct csg_vec2 n0, n1; /* unit normals of the edges, to the side that is moved to */
    double angle;           /* from n0 to n1, positive where the corner needs a join */
};

struct discs {
    CSG_ARRAY(struct csg_vec2) centers;
};

struct mover {
    struct csg_drawing *drawing;
    const struct csg_offset *offset;
    double size; /* of the distance */
    double side; /* 1: outwards, -1: inwards */
    struct discs discs;
};

static struct csg_vec2 moved(struct csg_vec2 p, double size, struct csg_vec2 n)
{
    return (struct csg_vec2){p.x + size * n.x, p.y + size * n.y};
}

static struct csg_vec2 normal_of(const struct mover *mover, struct csg_vec2 a, struct csg_vec2 b)
{
    const double x = b.x - a.x, y = b.y - a.y, length = hypot(x, y);
    return (struct csg_vec2){mover->side * (y / length), mover->side * (-x / length)};
}

/* The inside is to the left of the outline. */
static struct corner corner_of(const struct mover *mover, const struct csg_contour *contour,
                               uint32_t i)
{
    const struct csg_vec2 *p = mover->drawing->points.data;
    const uint32_t num = contour->end - contour->begin;
    struct corner corner = {.before = p[contour->begin + (i + num - 1) % num],
                            .at = p[contour->begin + i],
                            .after = p[contour->begin + (i + 1) % num]};
    corner.n0 = normal_of(mover, corner.before, corner.at);
    corner.n1 = normal_of(mover, corner.at, corner.after);
    const double sine = corner.n0.x * corner.n1.y - corner.n0.y * corner.n1.x;
    const double cosine = corner.n0.x * corner.n1.x + corner.n0.y * corner.n1.y;
    corner.angle = mover->side * atan2(sine, cosine);
    return corner;
}

static bool add_point(struct mover *mover, struct csg_vec2 p)
{
    return csg_drawing_add_point(mover->drawing, p.x, p.y);
}

static bool add_moved(struct mover *mover, const struct corner *corner, double size,
                      struct csg_vec2 n)
{
    return add_point(mover, moved(corner->at, size, n));
}

/* Steps of a full turn as Clipper 6 finds them for OpenSCAD 2021.01 (ClipperOffset::DoOffset): num
 * but for rounding, which decides where an arc has a half of a step. */
static double clipper_steps(int num, double size)
{
    const double delta = size * CLIPPER_SCALE;
    const double tolerance = size * (1 - csg_cos_degrees(180.0 / num)) * CLIPPER_SCALE;
    const double steps = PI / acos(1 - fmin(tolerance, CLIPPER_MAX_TOLERANCE * delta) / delta);
    return fmin(steps, delta * PI);
}

/* Clipper's arc (DoRound): equal steps from the first normal on; the last one is longer or shorter.
 */
static bool add_arc(struct mover *mover, const struct corner *corner)
{
    const double steps = clipper_steps(mover->offset->num, mover->size), step = 2 * PI / steps;
    const int num = (int)fmax(floor(steps / (2 * PI) * fabs(corner->angle) + 0.5), 1);
    bool ok = true;
    for (int i = 0; i <= num && ok; i++) {
        const double angle = mover->side * step * i, c = cos(angle), s = sin(angle);
        const struct csg_vec2 turned = {c * corner->n0.x - s * corner->n0.y,
                                        s * corner->n0.x + c * corner->n0.y};
        ok = add_moved(mover, corner, mover->size, i < num ? turned : corner->n1);
    }
    return ok;
}

/* Both edges go on until they meet. */
static bool add_miter(struct mover *mover, const struct corner *corner)
{
    const double cosine = corner->n0.x * corner->n1.x + corner->n0.y * corner->n1.y;
    const double reach = fmin(1 / (1 + cosine), MITER_LIMIT);
    const struct csg_vec2 sum = {corner->n0.x + corner->n1.x, corner->n0.y + corner->n1.y};
    return add_moved(mover, corner, mover->size, corner->n0) &&
           add_moved(mover, corner, mover->size * reach, sum) &&
           add_moved(mover, corner, mover->size, corner->n1);
}

/* Both edges go on until they meet the line across, at the same distance from the corner. */
static bool add_square(struct mover *mover, const struct corner *corner)
{
    const double d = mover->side * tan(corner->angle / 4);
    const struct csg_vec2 a = {corner->n0.x - corner->n0.y * d, corner->n0.y + corner->n0.x * d};
    const struct csg_vec2 b = {corner->n1.x + corner->n1.y * d, corner->n1.y - corner->n1.x * d};
    return add_moved(mover, corner, mover->size, corner->n0) &&
           add_moved(mover, corner, mover->size, a) && add_moved(mover, corner, mover->size, b) &&
           add_moved(mover, corner, mover->size, corner->n1);
}

/* From the end of one moved edge to the beginning of the next. Where the corner is on the other
 * side the way goes through it, so that both rectangles count. */
static bool add_join(struct mover *mover, const struct corner *corner)
{
    if (!(corner->angle > 1e-12))
        return add_moved(mover, corner, mover->size, corner->n0) && add_point(mover, corner->at) &&
               add_moved(mover, corner, mover->size, corner->n1);
    if (mover->offset->join == CSG_JOIN_MITER)
        return add_miter(mover, corner);
    if (mover->offset->join == CSG_JOIN_SQUARE)
        return add_square(mover, corner);
    if (mover->offset->exact && corner->angle > SHARP_DEGREES * PI / 180 &&
        !csg_array_push(&mover->discs.centers, corner->at))
        return false;
    return add_arc(mover, corner);
}

/* The figure's outline, moved, as a new figure. */
static bool add_all(struct mover *mover, uint32_t index)
{
    struct csg_drawing *drawing = mover->drawing;
    const struct csg_figure figure = drawing->figures.data[index];
    bool ok = csg_drawing_add_figure(drawing, figure.rounding);
    for (uint32_t i = figure.begin; i < figure.end && ok; i++) {
        const struct csg_contour contour = drawing->contours.data[i];
        ok = csg_drawing_add_contour(drawing);
        for (uint32_t j = 0; j < contour.end - contour.begin && ok; j++) {
            const struct corner corner = corner_of(mover, &contour, j);
            ok = add_join(mover, &corner);
        }
    }
    if (ok) {
        drawing->figures.data[drawing->figures.num - 1].by_winding = true;
        drawing->figures.data[drawing->figures.num - 1].facetted = figure.facetted;
    }
    return ok;
}

static bool add_disc(struct mover *mover, struct csg_vec2 center, double rounding)
{
    struct csg_drawing *drawing = mover->drawing;
    const int num = mover->offset->num;
    bool ok = csg_drawing_add_figure(drawing, rounding) && csg_drawing_add_contour(drawing);
    for (int i = 0; i < num && ok; i++) {
        const struct csg_vec2 d = {csg_cos_degrees(360.0 * i / num),
                                   csg_sin_degrees(360.0 * i / num)};
        const struct csg_vec2 p = moved(center, mover->size, d);
        ok = csg_drawing_add_point(drawing, p.x, p.y);
    }
    struct csg_figure *figure = &drawing->figures.data[drawing->figures.num - 1];
    figure->is_disc = figure->is_join = true;
    figure->disc = csg_map_scaling(csg_vec3(mover->size, mover->size, 1));
    figure->disc.m[0][3] = center.x;
    figure->disc.m[1][3] = center.y;
    return ok;
}

/* The subtree at node becomes first operand of a node with that op. */
static bool wrap(struct csg_drawing *drawing, uint32_t node, enum csg_draw_op op)
{
    if (!csg_drawing_open(drawing, op))
        return false;
    for (size_t i = drawing->nodes.num - 1; i > node; i--) {
        drawing->nodes.data[i] = drawing->nodes.data[i - 1];
        drawing->nodes.data[i].end++;
    }
    drawing->nodes.data[node] =
        (struct csg_draw_node){.op = (uint8_t)op, .end = (uint32_t)drawing->nodes.num};
    return true;
}

static bool add_discs(struct mover *mover, uint32_t node, enum csg_draw_op op, double rounding)
{
    bool ok = mover->discs.centers.num == 0 || wrap(mover->drawing, node, op);
    for (size_t i = 0; i < mover->discs.centers.num && ok; i++)
        ok = add_disc(mover, mover->discs.centers.data[i], rounding);
    if (ok && mover->discs.centers.num > 0)
        csg_drawing_close(mover->drawing, node);
    return ok;
}

/* A disc alone stays one. */
static bool move_disc(struct csg_drawing *drawing, uint32_t node, const struct csg_offset *offset)
{
    const uint32_t num = drawing->nodes.data[node].end - node;
    const struct csg_draw_node *last = &drawing->nodes.data[node + num - 1];
    if (last->op != CSG_DRAW_FIGURE || offset->join != CSG_JOIN_ROUND || !offset->exact)
        return false;
    for (uint32_t i = node; i + 1 < node + num; i++)
        if (drawing->nodes.data[i].op == CSG_DRAW_FIGURE ||
            drawing->nodes.data[i].end != node + num)
            return false;
    struct csg_figure *figure = &drawing->figures.data[last->figure];
    double(*m)[4] = figure->disc.m;
    double r;
    const bool is_round = csg_figure_is_round(figure, &r);
    const double factor = (r + offset->distance) / r;
    if (!is_round || !(factor > 0))
        return false;
    for (uint32_t i = figure->begin; i < figure->end; i++)
        for (uint32_t j = drawing->contours.data[i].begin; j < drawing->contours.data[i].end; j++) {
            struct csg_vec2 *p = &drawing->points.data[j];
            p->x = m[0][3] + factor * (p->x - m[0][3]);
            p->y = m[1][3] + factor * (p->y - m[1][3]);
        }
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            m[i][j] *= factor;
    return true;
}

static enum csg_sweep_result move_outline(struct mover *mover, uint32_t node)
{
    struct csg_drawing *drawing = mover->drawing;
    const enum csg_draw_op op = mover->side > 0 ? CSG_DRAW_UNION : CSG_DRAW_DIFFERENCE;
    enum csg_sweep_result result = csg_drawing_evaluate(drawing, node);
    if (result != CSG_SWEEP_DONE || mover->size == 0)
        return result;
    const uint32_t figure = drawing->nodes.data[node].figure;
    const double rounding = drawing->figures.data[figure].rounding;
    csg_drawing_cut(drawing, node);
    if (!add_all(mover, figure))
        return CSG_SWEEP_NO_MEMORY;
    result = csg_drawing_evaluate(drawing, node);
    if (result == CSG_SWEEP_DONE && !add_discs(mover, node, op, rounding))
        result = CSG_SWEEP_NO_MEMORY;
    return result;
}

enum csg_sweep_result csg_drawing_offset(struct csg_drawing *drawing, uint32_t node,
                                         const struct csg_offset *offset)
{
    struct mover mover = {.drawing = drawing,
                          .offset = offset,
                          .size = fabs(offset->distance),
                          .side = offset->distance < 0 ? -1 : 1};
    enum csg_sweep_result result = CSG_SWEEP_DONE;
    if (!move_disc(drawing, node, offset))
        result = move_outline(&mover, node);
    free(mover.discs.centers.data);
    return result;
}
