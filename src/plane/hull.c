/* SPDX-License-Identifier: MIT */
#include "plane/hull.h"

#include <stdlib.h>

#include "plane/outline.h"
#include "plane/wrap.h"

#define PI 3.14159265358979323846264338327950288

/* A circle, or a point of radius 0. */
struct ball {
    struct csg_vec2 center;
    double radius;
    uint32_t figure; /* of the disc */
};

struct balls {
    CSG_ARRAY(struct ball) list;
};

/* ---- what is to be wrapped ---------------------------------------------------------------- */

static bool collect(const struct csg_drawing *drawing, uint32_t index, struct balls *discs,
                    struct csg_flat_points *points)
{
    const struct csg_figure *figure = &drawing->figures.data[index];
    struct ball ball = {.figure = index};
    if (csg_figure_is_round(figure, &ball.radius)) {
        ball.center = (struct csg_vec2){figure->disc.m[0][3], figure->disc.m[1][3]};
        return csg_array_push(&discs->list, ball);
    }
    for (uint32_t i = figure->begin; i < figure->end; i++)
        for (uint32_t j = drawing->contours.data[i].begin; j < drawing->contours.data[i].end; j++)
            if (!csg_array_push(&points->list, drawing->points.data[j]))
                return false;
    return true;
}

/* Booleans are evaluated first, with OpenSCAD's facets. */
static bool is_union(const struct csg_drawing *drawing, uint32_t node)
{
    for (uint32_t i = node; i < drawing->nodes.data[node].end; i++) {
        const uint8_t op = drawing->nodes.data[i].op;
        if (op != CSG_DRAW_UNION && op != CSG_DRAW_FIGURE)
            return false;
    }
    return true;
}

/* ---- circles ------------------------------------------------------------------------------ */

/*
 * In direction u the hull reaches as far as the ball with the largest c.u + r. From ball i on, at
 * the direction theta, ball j takes over where (cj - ci).u = ri - rj: with d = cj - ci at
 * phi = phi(d) - acos((ri - rj) / |d|). The ball that does so first comes next (gift wrapping).
 */
static double takeover(const struct ball *from, const struct ball *to, double theta)
{
    const double x = to->center.x - from->center.x, y = to->center.y - from->center.y;
    const double distance = hypot(x, y), cosine = (from->radius - to->radius) / distance;
    if (!(fabs(cosine) < 1))
        return INFINITY; /* one is inside of the other */
    double ahead = fmod(atan2(y, x) - acos(cosine) - theta, 2 * PI);
    while (ahead < -1e-9)
        ahead += 2 * PI;
    return ahead;
}

static size_t furthest(const struct balls *balls)
{
    size_t best = 0;
    for (size_t i = 1; i < balls->list.num; i++) {
        const struct ball *a = &balls->list.data[i], *b = &balls->list.data[best];
        const double more = a->center.x + a->radius - (b->center.x + b->radius);
        /* Of equals the highest, which is ahead when turning to the left. */
        if (more > 0 || (more == 0 && a->center.y > b->center.y))
            best = i;
    }
    return best;
}

static size_t next_ball(const struct balls *balls, size_t from, double theta, double *ahead)
{
    size_t best = from;
    double best_distance = 0;
    *ahead = INFINITY;
    for (size_t i = 0; i < balls->list.num; i++) {
        const struct ball *a = &balls->list.data[from], *b = &balls->list.data[i];
        const double angle = i == from ? (double)INFINITY : takeover(a, b, theta);
        const double distance = hypot(b->center.x - a->center.x, b->center.y - a->center.y);
        if (angle < *ahead - 1e-12 || (angle < *ahead + 1e-12 && distance > best_distance)) {
            best = i;
            best_distance = distance;
            *ahead = angle;
        }
    }
    return best;
}

static bool add_tangent(struct csg_flat_points *polygon, const struct ball *ball, double theta)
{
    const struct csg_vec2 p = {ball->center.x + ball->radius * cos(theta),
                               ball->center.y + ball->radius * sin(theta)};
    return csg_array_push(&polygon->list, p);
}

/* The polygon of the points where the edges touch; used: the balls that the hull touches. */
static bool wrap_balls(const struct balls *balls, struct csg_flat_points *polygon, bool *used)
{
    const size_t num = balls->list.num;
    size_t at = furthest(balls);
    double theta = 0, ahead;
    used[at] = true;
    for (size_t steps = 0; steps <= 2 * num; steps++) {
        const size_t next = next_ball(balls, at, theta, &ahead);
        if (next == at || theta + ahead > 2 * PI + 1e-9)
            return true;
        theta += fmax(ahead, 0);
        if (!add_tangent(polygon, &balls->list.data[at], theta) ||
            !add_tangent(polygon, &balls->list.data[next], theta))
            return false;
        /* An edge across the direction that it began with is the last one. */
        if (theta >= 2 * PI - 1e-9)
            return true;
        used[next] = true;
        at = next;
    }
    return true;
}

/* ---- the figures -------------------------------------------------------------------------- */

static bool add_disc(struct csg_drawing *drawing, uint32_t figure)
{
    const struct csg_draw_node node = {
        .op = CSG_DRAW_FIGURE, .figure = figure, .end = (uint32_t)drawing->nodes.num + 1};
    return csg_array_push(&drawing->nodes, node);
}

static bool add_union(struct csg_drawing *drawing, const struct balls *balls, uint32_t node,
                      double rounding)
{
    struct csg_flat_points polygon = {0};
    bool *used = calloc(balls->list.num + 1, sizeof *used);
    bool ok = used && wrap_balls(balls, &polygon, used) &&
              csg_drawing_open(drawing, CSG_DRAW_UNION) &&
              csg_flat_points_draw(drawing, &polygon, rounding);
    for (size_t i = 0; i < balls->list.num && ok; i++)
        if (used[i] && balls->list.data[i].radius > 0)
            ok = add_disc(drawing, balls->list.data[i].figure);
    if (ok)
        csg_drawing_close(drawing, node);
    free(polygon.list.data);
    free(used);
    return ok;
}

static bool hull(struct csg_drawing *drawing, uint32_t node)
{
    const uint32_t end = drawing->nodes.data[node].end;
    const double rounding = csg_drawing_rounding(drawing, node, end);
    const bool facetted = csg_drawing_is_facetted(drawing, node, end);
    struct balls balls = {0};
    struct csg_flat_points points = {0};
    bool ok = true;
    for (uint32_t i = node; i < end && ok; i++)
        if (drawing->nodes.data[i].op == CSG_DRAW_FIGURE)
            ok = collect(drawing, drawing->nodes.data[i].figure, &balls, &points);
    csg_drawing_cut(drawing, node);
    ok = ok && csg_flat_points_wrap(&points);
    if (ok && balls.list.num == 0) {
        ok = csg_flat_points_draw(drawing, &points, rounding);
    } else if (ok) {
        for (size_t i = 0; i < points.list.num && ok; i++)
            ok = csg_array_push(&balls.list, ((struct ball){.center = points.list.data[i]}));
        ok = ok && add_union(drawing, &balls, node, rounding);
    }
    if (ok && balls.list.num == 0)
        drawing->figures.data[drawing->figures.num - 1].facetted = facetted;
    free(balls.list.data);
    free(points.list.data);
    return ok;
}

enum csg_sweep_result csg_drawing_hull(struct csg_drawing *drawing, uint32_t node)
{
    enum csg_sweep_result result = CSG_SWEEP_DONE;
    if (!is_union(drawing, node))
        result = csg_drawing_evaluate(drawing, node);
    if (result != CSG_SWEEP_DONE)
        return result;
    return hull(drawing, node) ? CSG_SWEEP_DONE : CSG_SWEEP_NO_MEMORY;
}
