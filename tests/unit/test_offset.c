/* SPDX-License-Identifier: MIT */
/*
 * Offsets: what they cover must be what the distance from the outline says, for random polygons
 * that cross themselves; and outlines have no corners that are none, however many levels cut their
 * edges.
 */
#define DICE_SEED 7

#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "dice.h"
#include "figure.h"
#include "plane/offset.h"
#include "plane/outline.h"
#include "solids/facets.h"

enum { num_polygons = 300, num_points = 200, num_facets = 64, num_teeth = 300 };

static void add_point(struct csg_drawing *drawing, double x, double y)
{
    if (!csg_drawing_add_point(drawing, x, y))
        abort();
}

static void add_contour(struct csg_drawing *drawing)
{
    if (!csg_drawing_add_contour(drawing))
        abort();
}

static void add_random(struct csg_drawing *drawing)
{
    if (!csg_drawing_add_figure(drawing, 0))
        abort();
    for (int contours = random_between(0, 1) < 0.5 ? 1 : 2; contours > 0; contours--) {
        add_contour(drawing);
        for (int i = (int)random_between(3, 9); i > 0; i--)
            add_point(drawing, random_between(-10, 10), random_between(-10, 10));
    }
}

static double segment_distance(struct csg_vec2 a, struct csg_vec2 b, double x, double y)
{
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double t = ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy);
    const double s = fmin(fmax(t, 0), 1);
    return hypot(x - a.x - s * dx, y - a.y - s * dy);
}

/* From the figure's outline: negative inside. */
static double distance(const struct csg_drawing *drawing, double x, double y)
{
    const struct csg_figure *figure =
        &drawing->figures.data[drawing->nodes.data[drawing->nodes.num - 1].figure];
    double least = INFINITY;
    for (uint32_t c = figure->begin; c < figure->end; c++) {
        const struct csg_contour contour = drawing->contours.data[c];
        for (uint32_t i = contour.begin; i < contour.end; i++) {
            const struct csg_vec2 a = drawing->points.data[i];
            const struct csg_vec2 b =
                drawing->points.data[i + 1 < contour.end ? i + 1 : contour.begin];
            least = fmin(least, segment_distance(a, b, x, y));
        }
    }
    return in_figure(drawing, figure, x, y) ? -least : least;
}

/* Arcs have facets, one of them up to half as long again: so far inside of the circle, at most. */
static double sagitta(double size)
{
    return size * (1 - cos(1.5 * 3.14159265358979323846 / num_facets));
}

static void check_offset(int seed)
{
    const struct csg_offset offset = {
        .distance = random_between(-1.5, 3), .join = CSG_JOIN_ROUND, .num = num_facets};
    struct csg_drawing before = {0}, after = {0};
    add_random(&before);
    const unsigned long long kept = dice;
    CHECK(csg_drawing_evaluate(&before, 0) == CSG_SWEEP_DONE, "polygon %d", seed);
    if (!csg_drawing_append_figure(&after, &before, &before.figures.data[0]))
        abort();
    CHECK(csg_drawing_offset(&after, 0, &offset) == CSG_SWEEP_DONE, "polygon %d", seed);
    dice = kept;
    const double slack = sagitta(fabs(offset.distance)) + 1e-9;
    for (int i = 0; i < num_points; i++) {
        const double x = random_between(-14, 14), y = random_between(-14, 14);
        const double d = distance(&before, x, y) - offset.distance;
        if (fabs(d) > slack)
            CHECK((d < 0) == (distance(&after, x, y) < 0),
                  "polygon %d by %g: (%g, %g) is off by %g", seed, offset.distance, x, y, d);
    }
    csg_drawing_finish(&before);
    csg_drawing_finish(&after);
}

/* A slender askew rectangle beside many teeth, whose corners are all levels. */
static void check_corners(double degrees)
{
    const double c = csg_cos_degrees(degrees), s = csg_sin_degrees(degrees);
    struct csg_drawing drawing = {0};
    if (!csg_drawing_add_figure(&drawing, 0))
        abort();
    add_contour(&drawing);
    for (int i = 0; i < 4; i++) {
        const double x = i == 1 || i == 2 ? 1000 : 0, y = i > 1 ? 3 : 0;
        add_point(&drawing, c * x - s * y, s * x + c * y);
    }
    add_contour(&drawing);
    add_point(&drawing, -2000, 0);
    for (int i = 0; i < num_teeth; i++)
        add_point(&drawing, i % 2 ? -1990 : -1989, 700.0 * (i + random_between(0, 1)) / num_teeth);
    add_point(&drawing, -2000, 700);
    CHECK(csg_drawing_evaluate(&drawing, 0) == CSG_SWEEP_DONE, "teeth");
    CHECK(drawing.points.num == 4 + num_teeth + 2, "%zu corners at %g degrees", drawing.points.num,
          degrees);
    csg_drawing_finish(&drawing);
}

static size_t count_corners(const struct csg_drawing *drawing)
{
    const struct csg_figure *figure = &drawing->figures.data[drawing->nodes.data[0].figure];
    size_t num = 0;
    for (uint32_t i = figure->begin; i < figure->end; i++)
        num += drawing->contours.data[i].end - drawing->contours.data[i].begin;
    return num;
}

/* Discs that make corners round are no corners of what is moved next. */
static void check_discs(void)
{
    static const double distances[] = {-2, 3, -1, 0.5};
    struct csg_drawing exact = {0}, facetted = {0};
    struct csg_drawing *drawings[] = {&exact, &facetted};
    for (int i = 0; i < 2; i++) {
        if (!csg_drawing_add_figure(drawings[i], 0))
            abort();
        add_contour(drawings[i]);
        for (int k = 0; k < 8; k++)
            add_point(drawings[i], (k % 2 ? 10 : 30) * csg_cos_degrees(45 * k + 10),
                      (k % 2 ? 10 : 30) * csg_sin_degrees(45 * k + 10));
        for (int k = 0; k < 4; k++) {
            const struct csg_offset offset = {
                .distance = distances[k], .join = CSG_JOIN_ROUND, .num = 48, .exact = i == 0};
            CHECK(csg_drawing_offset(drawings[i], 0, &offset) == CSG_SWEEP_DONE, "step %d", k);
        }
        CHECK(csg_drawing_evaluate(drawings[i], 0) == CSG_SWEEP_DONE, "%d", i);
    }
    CHECK(count_corners(&exact) == count_corners(&facetted), "%zu and %zu corners",
          count_corners(&exact), count_corners(&facetted));
    csg_drawing_finish(&exact);
    csg_drawing_finish(&facetted);
}

int main(void)
{
    check_discs();
    for (int i = 0; i < num_polygons; i++)
        check_offset(i);
    for (double degrees = 1; degrees < 89; degrees += 1.7)
        check_corners(degrees);
    if (num_failed)
        fprintf(stderr, "%d checks failed\n", num_failed);
    return num_failed != 0;
}
