/* SPDX-License-Identifier: MIT */
/*
 * A plate less a winding row of boxes as convex sets: a point is in one of them where it is in the
 * plate and in none of the boxes, never in two, and there are few sets, each with few corners. So
 * is what a row of wider boxes, which overlap each other, has of that, and a ball of many planes in
 * a box, in both orders, less a part of it. A solid by itself has each of its corners once.
 */
#define DICE_SEED 5

#include <stdlib.h>

#include "check.h"
#include "dice.h"
#include "polyhedra/evaluate.h"

enum {
    num_boxes = 60,
    num_wide_boxes = 300,
    num_points = 4000,
    max_plate_sets = 3 * num_boxes,
    max_sets = 20 * num_boxes,
    num_tangents = 2000
};

static struct csg_shape box_shape(const struct csg_map *map)
{
    struct csg_shape shape = {.frame = csg_map_identity, .convex = true};
    const struct csg_box unit = {{-1, -1, -1}, {1, 1, 1}};
    for (int i = 0; i < 6; i++) {
        const double s = i % 2 ? 1 : -1;
        const struct csg_vec3 n = csg_vec3(i / 2 == 0 ? s : 0, i / 2 == 1 ? s : 0, i > 3 ? s : 0);
        CHECK(csg_shape_add_plane(&shape, n, 1), "memory");
    }
    shape.bounds = shape.written = unit;
    CHECK(csg_shape_map(&shape, map), "memory");
    return shape;
}

static struct csg_map box_map(double along, double width)
{
    const double x = -30 + along, y = 6 * sin(0.15 * along), angle = cos(0.15 * along);
    struct csg_map map = csg_map_identity;
    map.m[0][0] = cos(angle);
    map.m[0][1] = -width * sin(angle);
    map.m[1][0] = sin(angle);
    map.m[1][1] = width * cos(angle);
    map.m[2][2] = 3;
    map.m[0][3] = x;
    map.m[1][3] = y;
    return map;
}

static void add_row(struct csg_part *part, int num, double width, bool negated)
{
    for (int i = 0; i < num; i++) {
        const struct csg_map map = box_map((double)num_boxes * i / num, width);
        struct csg_shape shape = box_shape(&map);
        CHECK(csg_part_add(part, &shape, negated), "memory");
    }
}

static void make_part(struct csg_part *part, bool is_wide)
{
    struct csg_map plate = csg_map_identity;
    plate.m[0][0] = 40;
    plate.m[1][1] = 20;
    struct csg_shape shape = box_shape(&plate);
    CHECK(csg_part_open(part, true) && csg_part_add(part, &shape, false), "memory");
    add_row(part, num_boxes, 1.5, true);
    if (is_wide) {
        CHECK(csg_part_open(part, false), "memory");
        add_row(part, num_wide_boxes, 4, false);
        csg_part_close(part);
    }
    csg_part_close(part);
}

static bool is_in(const struct csg_shape *shape, struct csg_vec3 p)
{
    for (size_t i = 0; i < shape->num_planes; i++)
        if (csg_dot(shape->planes[i].normal, p) > shape->planes[i].offset)
            return false;
    return true;
}

static void fill_sets(const struct csg_clusters *clusters, struct csg_shape *sets)
{
    size_t begin = 0;
    for (size_t i = 0; i < clusters->ends.num; i++) {
        struct csg_points points = {0};
        for (; begin < clusters->ends.data[i]; begin++)
            CHECK(csg_array_push(&points.points, clusters->corners.points.data[begin]), "memory");
        sets[i] = (struct csg_shape){.frame = csg_map_identity};
        CHECK(csg_hull_fill(&sets[i], &points) == CSG_HULL_DONE, "set %zu is flat", i);
        free(points.points.data);
    }
}

static void check_point(const struct csg_part *part, const struct csg_shape *sets, size_t num,
                        struct csg_vec3 p)
{
    bool all = true, any = false, is_wide = false;
    int found = 0;
    for (size_t i = 1; i < part->tree.num; i++) {
        const struct csg_node *leaf = &part->tree.data[i];
        const bool is =
            leaf->op == CSG_LEAF && is_in(&part->shapes.data[leaf->leaf], p) != leaf->negated;
        if (leaf->op == CSG_OR)
            is_wide = true;
        else if (is_wide)
            any = any || is;
        else
            all = all && is;
    }
    const bool expected = all && (any || !is_wide);
    for (size_t i = 0; i < num; i++)
        found += is_in(&sets[i], p);
    CHECK(found == expected, "[%g, %g, %g] is in %d sets", p.x, p.y, p.z, found);
}

/* size: of the box that the points are taken from. */
static void check_part(const struct csg_part *part, struct csg_vec3 size, size_t most,
                       size_t max_corners)
{
    struct csg_clusters clusters = {0};
    static struct csg_shape sets[max_sets];
    CHECK(csg_part_evaluate(part, false, &clusters) == CSG_HULL_DONE, "evaluated");
    const size_t num = clusters.ends.num;
    CHECK(num > 0 && num <= most, "%zu sets", num);
    CHECK(clusters.corners.points.num <= max_corners * num, "%zu corners",
          clusters.corners.points.num);
    if (num <= max_sets)
        fill_sets(&clusters, sets);
    for (int i = 0; i < num_points && num <= max_sets; i++)
        check_point(part, sets, num,
                    csg_vec3(random_between(-size.x, size.x), random_between(-size.y, size.y),
                             random_between(-size.z, size.z)));
    for (size_t i = 0; i < num && num <= max_sets; i++)
        csg_shape_finish(&sets[i]);
    csg_clusters_finish(&clusters);
}

static void check_plate(bool is_wide)
{
    struct csg_part part = {0};
    make_part(&part, is_wide);
    check_part(&part, csg_vec3(41, 21, 1.1), is_wide ? max_sets : max_plate_sets, 10);
    csg_part_finish(&part);
}

/* ---- a ball --------------------------------------------------------------------------------- */

/* Of planes that touch a sphere about center, all over it (a spiral from pole to pole). */
static struct csg_shape ball_shape(struct csg_vec3 center)
{
    struct csg_shape shape = {.frame = csg_map_identity, .convex = true};
    for (int i = 0; i < num_tangents; i++) {
        const double z = (2 * i + 1.0) / num_tangents - 1, r = sqrt(1 - z * z), a = 2.4 * i;
        const struct csg_vec3 n = csg_vec3(r * cos(a), r * sin(a), z);
        CHECK(csg_shape_add_plane(&shape, n, 1 + csg_dot(n, center)), "memory");
    }
    const struct csg_vec3 most = csg_vec3(1.1, 1.1, 1.1);
    shape.bounds = shape.written = (struct csg_box){csg_sub(center, most), csg_add(center, most)};
    return shape;
}

static struct csg_shape placed_box(double x, double y, double z)
{
    struct csg_map map = csg_map_identity;
    map.m[0][3] = x;
    map.m[1][3] = y;
    map.m[2][3] = z;
    return box_shape(&map);
}

static void check_ball(bool is_first)
{
    struct csg_part part = {0};
    struct csg_shape ball = ball_shape(csg_vec3(0.3, -0.2, 0.1)), box = placed_box(0.5, 0.4, 0.9);
    struct csg_shape cutter = placed_box(1.2, 0, 1.3);
    CHECK(csg_part_open(&part, true) && csg_part_add(&part, is_first ? &ball : &box, false) &&
              csg_part_add(&part, is_first ? &box : &ball, false) &&
              csg_part_add(&part, &cutter, true),
          "memory");
    csg_part_close(&part);
    check_part(&part, csg_vec3(1.6, 1.6, 1.6), 2, 2 * num_tangents);
    csg_part_finish(&part);
}

static void check_corners(void)
{
    struct csg_points points = {0};
    for (int i = 0; i < 20; i++) {
        const struct csg_map map = box_map(3.1 * i, 0.5);
        struct csg_shape box = box_shape(&map);
        points.points.num = 0;
        CHECK(csg_shape_corners(&box, &points) == CSG_HULL_DONE, "corners");
        CHECK(points.points.num == 8, "%zu corners of a box", points.points.num);
        csg_shape_finish(&box);
    }
    free(points.points.data);
}

int main(void)
{
    check_corners();
    check_plate(false);
    check_plate(true);
    check_ball(true);
    check_ball(false);
    return num_failed != 0;
}
