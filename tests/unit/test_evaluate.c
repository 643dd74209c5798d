/* SPDX-License-Identifier: MIT */
/*
 * A plate less a winding row of boxes as convex sets: a point is in one of them where it is in the
 * plate and in none of the boxes, never in two, and there are few sets, each with few corners.
 */
#define DICE_SEED 5

#include <stdlib.h>

#include "check.h"
#include "dice.h"
#include "polyhedra/evaluate.h"

enum { num_boxes = 60, num_points = 4000, max_sets = 6 * num_boxes };

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

static struct csg_map box_map(int i)
{
    const double x = -30.0 + i, y = 6 * sin(0.15 * i), angle = cos(0.15 * i);
    struct csg_map map = csg_map_identity;
    map.m[0][0] = cos(angle);
    map.m[0][1] = -1.5 * sin(angle);
    map.m[1][0] = sin(angle);
    map.m[1][1] = 1.5 * cos(angle);
    map.m[2][2] = 3;
    map.m[0][3] = x;
    map.m[1][3] = y;
    return map;
}

static void make_part(struct csg_part *part)
{
    struct csg_map plate = csg_map_identity;
    plate.m[0][0] = 40;
    plate.m[1][1] = 20;
    struct csg_shape shape = box_shape(&plate);
    CHECK(csg_part_open(part, true) && csg_part_add(part, &shape, false), "memory");
    for (int i = 0; i < num_boxes; i++) {
        const struct csg_map map = box_map(i);
        shape = box_shape(&map);
        CHECK(csg_part_add(part, &shape, true), "memory");
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
    bool expected = is_in(&part->shapes.data[0], p);
    int found = 0;
    for (size_t i = 1; i < part->shapes.num; i++)
        expected = expected && !is_in(&part->shapes.data[i], p);
    for (size_t i = 0; i < num; i++)
        found += is_in(&sets[i], p);
    CHECK(found == expected, "[%g, %g, %g] is in %d sets", p.x, p.y, p.z, found);
}

int main(void)
{
    struct csg_part part = {0};
    struct csg_clusters clusters = {0};
    static struct csg_shape sets[max_sets];
    make_part(&part);
    CHECK(csg_part_evaluate(&part, false, &clusters) == CSG_HULL_DONE, "evaluated");
    const size_t num = clusters.ends.num;
    CHECK(num <= max_sets, "%zu sets", num);
    CHECK(clusters.corners.points.num <= 12 * num, "%zu corners", clusters.corners.points.num);
    if (num > max_sets)
        return 1;
    fill_sets(&clusters, sets);
    for (int i = 0; i < num_points; i++)
        check_point(
            &part, sets, clusters.ends.num,
            csg_vec3(random_between(-41, 41), random_between(-21, 21), random_between(-1.1, 1.1)));
    for (size_t i = 0; i < num; i++)
        csg_shape_finish(&sets[i]);
    csg_clusters_finish(&clusters);
    csg_part_finish(&part);
    return num_failed != 0;
}
