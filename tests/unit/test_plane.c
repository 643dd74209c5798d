/* SPDX-License-Identifier: MIT */
/*
 * Drawings: what the sweep, the convex pieces and the outline cover must be what point membership
 * and the shoelace formula say. Random polygons cross and touch themselves, have corners twice and
 * edges upon each other.
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "check.h"
#include "dice.h"
#include "figure.h"
#include "plane/convex.h"
#include "plane/hull.h"
#include "plane/offset.h"
#include "plane/outline.h"
#include "plane/piece.h"
#include "plane/triangulate.h"

static int random_int(int end)
{
    return (int)(random_unit() * end);
}

/* ---- the rule ----------------------------------------------------------------------------- */

/* Trees here are a few levels deep. */
static bool in_node(const struct csg_drawing *drawing, uint32_t node, double x, double y)
{
    const struct csg_draw_node *at = &drawing->nodes.data[node];
    if (at->op == CSG_DRAW_FIGURE)
        return in_figure(drawing, &drawing->figures.data[at->figure], x, y);
    bool any = false, all = at->end > node + 1, first = false, others = false;
    for (uint32_t child = node + 1; child < at->end; child = drawing->nodes.data[child].end) {
        const bool inside = in_node(drawing, child, x, y);
        any |= inside;
        all &= inside;
        if (child == node + 1)
            first = inside;
        else
            others |= inside;
    }
    if (at->op == CSG_DRAW_UNION)
        return any;
    return at->op == CSG_DRAW_INTERSECTION ? all : first && !others;
}

static int count_pieces(const struct csg_pieces *pieces, double x, double y)
{
    int num = 0;
    for (size_t i = 0; i < pieces->pieces.num; i++) {
        const struct csg_piece *piece = &pieces->pieces.data[i];
        bool inside = true;
        for (uint32_t k = 0; k < piece->num_lines; k++) {
            const struct csg_line *line = &pieces->lines.data[piece->first_line + k];
            inside &= line->normal.x * x + line->normal.y * y <= line->offset;
        }
        num += inside;
    }
    return num;
}

static double outline_area(const struct csg_drawing *drawing)
{
    const struct csg_figure *figure = &drawing->figures.data[drawing->nodes.data[0].figure];
    double sum = 0;
    for (uint32_t c = figure->begin; c < figure->end; c++) {
        const struct csg_contour contour = drawing->contours.data[c];
        for (uint32_t i = contour.begin; i < contour.end; i++) {
            const struct csg_vec2 a = drawing->points.data[i];
            const struct csg_vec2 b =
                drawing->points.data[i + 1 < contour.end ? i + 1 : contour.begin];
            sum += 0.5 * (a.x * b.y - a.y * b.x);
        }
    }
    return sum;
}

/* ---- drawings ----------------------------------------------------------------------------- */

static void add_polygon(struct csg_drawing *drawing, int num, bool on_grid)
{
    if (!csg_drawing_add_figure(drawing, 0))
        abort();
    for (int contours = 1 + random_int(3); contours > 0; contours--) {
        if (!csg_drawing_add_contour(drawing))
            abort();
        for (int i = 0; i < num; i++) {
            const double x = 20 * random_unit() - 10, y = 20 * random_unit() - 10;
            if (!csg_drawing_add_point(drawing, on_grid ? floor(x) : x, on_grid ? floor(y) : y))
                abort();
        }
    }
}

static void add_random(struct csg_drawing *drawing, int depth, bool on_grid)
{
    const uint32_t node = (uint32_t)drawing->nodes.num;
    if (depth == 0 || random_int(3) == 0) {
        add_polygon(drawing, 3 + random_int(9), on_grid);
        return;
    }
    if (!csg_drawing_open(drawing, (enum csg_draw_op)random_int(3)))
        abort();
    for (int i = random_int(4); i >= 0; i--)
        add_random(drawing, depth - 1, on_grid);
    csg_drawing_close(drawing, node);
}

/* least: twice the area of the smallest. */
static double area_of(const struct csg_drawing *drawing, const struct csg_triangles *triangles,
                      double *least)
{
    double sum = 0;
    *least = 0;
    for (size_t i = 0; i < triangles->corners.num; i += 3) {
        const struct csg_vec2 a = drawing->points.data[triangles->corners.data[i]];
        const struct csg_vec2 b = drawing->points.data[triangles->corners.data[i + 1]];
        const struct csg_vec2 c = drawing->points.data[triangles->corners.data[i + 2]];
        const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        sum += 0.5 * twice;
        *least = fmin(*least, twice);
    }
    return sum;
}

/* Together they are as large as the outline; none looks down, unless the outline touches itself. */
static void check_triangles(const struct csg_drawing *drawing, double area, int seed)
{
    struct csg_triangles triangles = {0};
    const struct csg_figure *figure = &drawing->figures.data[drawing->nodes.data[0].figure];
    double least;
    if (drawing->points.num > 4000)
        return;
    CHECK(csg_figure_triangulate(drawing, figure, &triangles), "seed %d", seed);
    const double sum = area_of(drawing, &triangles, &least);
    const bool on_grid = seed % 2 == 0;
    CHECK((least > -1e-9 || on_grid) && fabs(sum - area) < 1e-9,
          "seed %d: triangles of %g, outline %g; %g", seed, sum, area, least);
    free(triangles.corners.data);
}

/* Every point off the edges is in exactly one piece, or in none. */
static void check_drawing(struct csg_drawing *drawing, int seed)
{
    struct csg_pieces pieces = {0};
    int num_inside = 0, num_wrong = 0;
    const int num = 400;
    CHECK(csg_pieces_cut(&pieces, drawing, 0) == CSG_SWEEP_DONE, "seed %d", seed);
    double xs[400], ys[400];
    bool inside[400];
    for (int i = 0; i < num; i++) {
        xs[i] = 22 * random_unit() - 11;
        ys[i] = 22 * random_unit() - 11;
        inside[i] = in_node(drawing, 0, xs[i], ys[i]);
        num_inside += inside[i];
        num_wrong += count_pieces(&pieces, xs[i], ys[i]) != (inside[i] ? 1 : 0);
    }
    CHECK(num_wrong == 0, "seed %d: %d of %d points", seed, num_wrong, num);
    csg_pieces_finish(&pieces);
    CHECK(csg_drawing_evaluate(drawing, 0) == CSG_SWEEP_DONE, "seed %d", seed);
    CHECK(drawing->nodes.num == 1, "seed %d", seed);
    for (int i = 0; i < num; i++)
        num_wrong += in_node(drawing, 0, xs[i], ys[i]) != inside[i];
    CHECK(num_wrong == 0, "seed %d: the outline misses %d of %d points", seed, num_wrong, num);
    /* 400 samples are good to about a tenth of the square: the orientation must be right. */
    const double area = outline_area(drawing), sampled = 22.0 * 22.0 * num_inside / num;
    CHECK(fabs(area - sampled) < 0.1 * 22 * 22, "seed %d: area %g, sampled %g", seed, area,
          sampled);
    check_triangles(drawing, area, seed);
}

static void test_random(void)
{
    for (int seed = 0; seed < 120; seed++) {
        struct csg_drawing drawing = {0};
        dice = 1000 + (unsigned long long)seed;
        add_random(&drawing, 3, seed % 2 == 0);
        check_drawing(&drawing, seed);
        csg_drawing_finish(&drawing);
    }
}

/* ---- convex polygons --------------------------------------------------------------------- */

/* A regular polygon, in either direction; on a grid a rectangle, in a union of its own. */
static void add_convex(struct csg_drawing *drawing, bool on_grid)
{
    const uint32_t node = (uint32_t)drawing->nodes.num;
    const double x = 6 * random_unit() - 3, y = 6 * random_unit() - 3, r = 4 + 6 * random_unit();
    const double first = random_unit(), sign = random_int(2) ? 1 : -1;
    const int num = on_grid ? 4 : 3 + random_int(30);
    if ((on_grid && !csg_drawing_open(drawing, CSG_DRAW_UNION)) ||
        !csg_drawing_add_figure(drawing, 0) || !csg_drawing_add_contour(drawing))
        abort();
    for (int i = 0; i < num; i++) {
        const double angle = sign * (6.283185307179586 * i / num + first);
        const bool ok =
            on_grid ? csg_drawing_add_point(drawing, floor(i % 3 ? x + r : x - r),
                                            floor(i > 1 ? y + r : y - r))
                    : csg_drawing_add_point(drawing, x + r * cos(angle), y + r * sin(angle));
        if (!ok)
            abort();
    }
    if (on_grid)
        csg_drawing_close(drawing, node);
}

/* One polygon in the place of several covers what is in all of them; mixed: one of them is none. */
static void check_intersection(int seed, bool on_grid, bool mixed)
{
    struct csg_drawing drawing = {0};
    int num_wrong = 0;
    double xs[400], ys[400];
    bool inside[400];
    if (!csg_drawing_open(&drawing, CSG_DRAW_INTERSECTION))
        abort();
    for (int i = 2 + random_int(20); i > 0; i--)
        add_convex(&drawing, on_grid);
    if (mixed)
        add_polygon(&drawing, 7, on_grid);
    csg_drawing_close(&drawing, 0);
    for (int i = 0; i < 400; i++) {
        xs[i] = 10 * random_unit() - 5;
        ys[i] = 10 * random_unit() - 5;
        inside[i] = in_node(&drawing, 0, xs[i], ys[i]);
    }
    CHECK(csg_drawing_intersect(&drawing, 0), "memory");
    CHECK((drawing.nodes.num == 1) == !mixed, "seed %d: %zu nodes", seed, drawing.nodes.num);
    for (int i = 0; i < 400; i++)
        num_wrong += in_node(&drawing, 0, xs[i], ys[i]) != inside[i];
    CHECK(num_wrong == 0, "seed %d: %d of 400 points", seed, num_wrong);
    csg_drawing_finish(&drawing);
}

static void test_intersection(void)
{
    for (int seed = 0; seed < 200; seed++) {
        dice = 5000 + (unsigned long long)seed;
        check_intersection(seed, seed % 2 == 0, seed % 10 == 9);
    }
}

/* ---- shapes with known answers ------------------------------------------------------------ */

static void add_winding(struct csg_drawing *drawing, int num, int i, double inwards)
{
    const double angle = 0.02 * i;
    const double radius = 10 + angle - inwards;
    if (!csg_drawing_add_point(drawing, radius * cos(angle), radius * sin(angle)) || i >= num)
        abort();
}

/* Processor time, the least of three, as other programs of the machine only add to it. */
static double seconds_of(const struct csg_drawing *drawing)
{
    double seconds = INFINITY;
    for (int i = 0; i < 3; i++) {
        struct csg_triangles triangles = {0};
        const clock_t start = clock();
        CHECK(csg_figure_triangulate(drawing, drawing->figures.data, &triangles), "no memory");
        seconds = fmin(seconds, (double)(clock() - start) / CLOCKS_PER_SEC);
        free(triangles.corners.data);
    }
    return seconds;
}

/* No triangle looks down, and together they are as large as the figure, which has so many holes. */
static double seconds_of_triangles(const struct csg_drawing *drawing, size_t num_holes, double area)
{
    struct csg_triangles triangles = {0};
    CHECK(csg_figure_triangulate(drawing, drawing->figures.data, &triangles), "no memory");
    CHECK(triangles.corners.num == 3 * (drawing->points.num + 2 * num_holes - 2), "%zu corners",
          triangles.corners.num);
    double least;
    const double sum = area_of(drawing, &triangles, &least);
    CHECK(least == 0 && fabs(sum - area) < 1e-9 * area, "triangles of %g, figure %g; %g", sum, area,
          least);
    free(triangles.corners.data);
    return seconds_of(drawing);
}

static double seconds_of_winding(int num)
{
    struct csg_drawing drawing = {0};
    if (!csg_drawing_add_figure(&drawing, 0) || !csg_drawing_add_contour(&drawing))
        abort();
    for (int i = 0; i < num; i++)
        add_winding(&drawing, num, i, 0);
    for (int i = num; i-- > 0;)
        add_winding(&drawing, num, i, 3);
    const double area = 0.5 * csg_contour_twice_area(&drawing, drawing.contours.data);
    const double seconds = seconds_of_triangles(&drawing, 0, area);
    csg_drawing_finish(&drawing);
    return seconds;
}

/* A strip that winds about 640 times: of 400,000 corners those that are ears are soon cut, and then
 * only the strip's ends are. A round for each of them would take hundreds of times as long. Neither
 * it nor a quarter of it fits the processor's caches. */
static void test_winding(void)
{
    const double part = seconds_of_winding(50000), all = seconds_of_winding(200000);
    CHECK(all < 10 * part, "%g s, a quarter %g s", all, part);
}

static void add_points(struct csg_drawing *drawing, const double (*points)[2], int num)
{
    if (drawing->figures.num == 0 && !csg_drawing_add_figure(drawing, 0))
        abort();
    if (!csg_drawing_add_contour(drawing))
        abort();
    for (int i = 0; i < num; i++)
        if (!csg_drawing_add_point(drawing, points[i][0], points[i][1]))
            abort();
}

/* Columns and rows of six-cornered holes, each 6 wide and 10 from the next; or diamonds that touch
 * their neighbours. */
static double seconds_of_holes(int columns, int rows, bool touching)
{
    struct csg_drawing drawing = {0};
    const double width = 10 * columns, height = 10 * rows;
    const double plate[4][2] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    const double hexagon[6][2] = {{2, 5}, {3.5, 7.5}, {6.5, 7.5}, {8, 5}, {6.5, 2.5}, {3.5, 2.5}};
    const double diamond[4][2] = {{0, 5}, {5, 10}, {10, 5}, {5, 0}};
    const int num = touching ? 4 : 6;
    double hole[6][2];
    add_points(&drawing, plate, 4);
    for (int i = 0; i < columns * rows; i++) {
        for (int k = 0; k < num; k++) {
            const double *p = touching ? diamond[k] : hexagon[k];
            hole[k][0] = p[0] + 10 * (i % columns);
            hole[k][1] = p[1] + 10 * (i / columns);
        }
        add_points(&drawing, (const double(*)[2])hole, num);
    }
    double area = 0;
    for (uint32_t i = 0; i < drawing.contours.num; i++)
        area += 0.5 * csg_contour_twice_area(&drawing, &drawing.contours.data[i]);
    const size_t num_holes = (size_t)(columns * rows);
    const double seconds = seconds_of_triangles(&drawing, num_holes, area);
    csg_drawing_finish(&drawing);
    return seconds;
}

/* Each hole is joined to a near one, in whatever way they lie. Looking at all corners for each of
 * them would take 16 times as long for four times as many. */
static void test_holes(void)
{
    seconds_of_holes(13, 17, false);
    seconds_of_holes(1, 1, true);
    seconds_of_holes(3, 5, true);
    for (int i = 0; i < 2; i++) {
        const int num = 2500, all = 4 * num;
        const double part = i ? seconds_of_holes(num, 1, false) : seconds_of_holes(1, num, false);
        const double whole = i ? seconds_of_holes(all, 1, false) : seconds_of_holes(1, all, false);
        CHECK(whole < 10 * part, "%g s, a quarter %g s", whole, part);
    }
}

static void check_pieces(const double (*points)[2], int num, size_t num_pieces, const char *name)
{
    struct csg_drawing drawing = {0};
    struct csg_pieces pieces = {0};
    add_points(&drawing, points, num);
    CHECK(csg_pieces_cut(&pieces, &drawing, 0) == CSG_SWEEP_DONE, "%s", name);
    CHECK(pieces.pieces.num == num_pieces, "%s: %zu pieces", name, pieces.pieces.num);
    csg_pieces_finish(&pieces);
    csg_drawing_finish(&drawing);
}

static void test_pieces(void)
{
    static const double square[][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    static const double collinear[][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 1},
                                          {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    static const double flat[][2] = {{0, 0}, {1, 1}, {2, 2}};
    static const double spike[][2] = {{0, 0}, {2, 0}, {2, 2}, {5, 5}, {2, 2}, {0, 2}};
    static const double bow[][2] = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    static const double corner[][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    double round[90][2];
    for (int i = 0; i < 90; i++) {
        round[i][0] = 3 * cos(i * 0.069813170079773184);
        round[i][1] = 3 * sin(i * 0.069813170079773184);
    }
    check_pieces(square, 4, 1, "square");
    check_pieces(collinear, 9, 1, "collinear corners");
    check_pieces(flat, 3, 0, "flat");
    check_pieces(spike, 6, 1, "spike");
    check_pieces(bow, 4, 2, "bow");
    check_pieces(corner, 6, 2, "corner");
    check_pieces((const double(*)[2])round, 90, 1, "round");
}

static double offset_area(double distance, enum csg_join join)
{
    static const double square[][2] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    static const double hole[][2] = {{3, 3}, {7, 3}, {7, 7}, {3, 7}};
    struct csg_drawing drawing = {0};
    const struct csg_offset offset = {.distance = distance, .join = join, .num = 4000};
    add_points(&drawing, square, 4);
    add_points(&drawing, hole, 4);
    CHECK(csg_drawing_offset(&drawing, 0, &offset) == CSG_SWEEP_DONE, "%g", distance);
    const double area = outline_area(&drawing);
    csg_drawing_finish(&drawing);
    return area;
}

static void check_offset(double distance, enum csg_join join, double expected)
{
    const double area = offset_area(distance, join);
    CHECK(fabs(area - expected) < 1e-4, "offset %g, join %d: area %.9g, not %.9g", distance,
          (int)join, area, expected);
}

/* A square of 10 with a square hole of 4. */
static void test_offset(void)
{
    const double pi = 3.14159265358979323846;
    check_offset(0, CSG_JOIN_ROUND, 84);
    check_offset(1, CSG_JOIN_MITER, 144 - 4);
    check_offset(1, CSG_JOIN_ROUND, 140 - (4 - pi));
    check_offset(1, CSG_JOIN_SQUARE, 140 - 4 * (3 - 2 * sqrt(2.0)));
    check_offset(2, CSG_JOIN_MITER, 196);
    check_offset(-1, CSG_JOIN_MITER, 64 - 36);
    check_offset(-1, CSG_JOIN_ROUND, 64 - 36 + (4 - pi));
    check_offset(-5, CSG_JOIN_ROUND, 0);
}

static void test_hull(void)
{
    static const double points[][2] = {{0, 0}, {4, 0}, {2, 1}, {4, 4}, {0, 4}, {1, 3}, {2, 0}};
    struct csg_drawing drawing = {0};
    add_points(&drawing, points, 7);
    CHECK(csg_drawing_hull(&drawing, 0) == CSG_SWEEP_DONE, "hull");
    CHECK(fabs(outline_area(&drawing) - 16) < 1e-12, "hull: area %g", outline_area(&drawing));
    csg_drawing_finish(&drawing);
}

int main(void)
{
    test_random();
    test_intersection();
    test_winding();
    test_holes();
    test_pieces();
    test_offset();
    test_hull();
    if (num_failed)
        fprintf(stderr, "%d checks failed\n", num_failed);
    return num_failed != 0;
}
