/* SPDX-License-Identifier: MIT */
/*
 * Faces that are not plane: the triangles of a cut must be a triangulation of the face, with angles
 * nearly as Delaunay's, the same whether the face is seen from the front or mirrored from behind,
 * and those that OpenSCAD 2021.01 was seen to make, also of faces that cross themselves.
 */
#define DICE_SEED 11

#include <stdlib.h>

#include "check.h"
#include "dice.h"
#include "polyhedra/cut.h"

enum { max_corners = 12, num_faces = 3000 };

/* A star around the z axis that is not plane; on a grid every other time. */
static uint32_t random_face(struct csg_vec3 *points, int round)
{
    const uint32_t num = 4 + (uint32_t)random_between(0, max_corners - 4 + 0.99);
    for (uint32_t i = 0; i < num; i++) {
        const double angle = 6.283185307179586 * (i + random_between(0, 0.3)) / num;
        const double radius = random_between(20, 40);
        points[i] = csg_vec3(radius * cos(angle), radius * sin(angle), random_between(-9, 9));
        if (round % 2)
            points[i] = csg_vec3(floor(points[i].x), floor(points[i].y), floor(points[i].z));
    }
    return num;
}

static double area_of(const struct csg_vec3 *points, const uint32_t *corners, uint32_t num)
{
    double area = 0;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_vec3 a = points[corners[i]], b = points[corners[(i + 1) % num]];
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

static void check_face(struct csg_cutter *cutter, const struct csg_vec3 *points, uint32_t num)
{
    uint32_t face[max_corners];
    double sum = 0;
    for (uint32_t i = 0; i < num; i++)
        face[i] = i;
    CHECK(csg_cutter_cut(cutter, points, face, num), "memory");
    CHECK(cutter->num_triangles == num - 2, "%zu triangles of %u corners", cutter->num_triangles,
          (unsigned)num);
    for (size_t i = 0; i < cutter->num_triangles; i++) {
        const double area = area_of(points, cutter->triangles[i], 3);
        CHECK(area > -1e-3, "a triangle looks the other way: %g", area);
        sum += area;
    }
    CHECK(fabs(sum - area_of(points, face, num)) < 1e-3, "the triangles are not the face");
}

/* The edge from corner 0 to 2 or from 1 to 3. */
static bool cuts_first(const struct csg_cutter *cutter)
{
    bool has[2][4] = {{false}};
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            has[i][cutter->triangles[i][k]] = true;
    return has[0][0] && has[0][2] && has[1][0] && has[1][2];
}

static void check_diagonal(const struct csg_cut_space *space, const struct csg_vec3 *points,
                           bool first)
{
    static const uint32_t face[4] = {0, 1, 2, 3};
    struct csg_cutter cutter = {.space = space};
    CHECK(csg_cutter_cut(&cutter, points, face, 4) && cutter.num_triangles == 2, "two triangles");
    CHECK(cuts_first(&cutter) == first, "the other diagonal");
    csg_cutter_finish(&cutter);
}

/* Diagonals of one length: the sweep decides, by where the corners are. The folded one is projected
 * to a triangle. */
static void check_squares(void)
{
    const struct csg_vec3 square[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
    const struct csg_vec3 turned[4] = {{1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}, {0, 0, 0}};
    const struct csg_vec3 folded[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
    const struct csg_cut_space behind = {.map = csg_map_identity, .reversed = true};
    struct csg_cut_space mirrored = behind;
    mirrored.map.m[0][0] = -1;
    check_diagonal(NULL, square, false);
    check_diagonal(NULL, turned, true);
    check_diagonal(NULL, folded, false);
    check_diagonal(&behind, square, true);
    check_diagonal(&mirrored, square, false);
}

/* As OpenSCAD 2021.01 was seen to cut flat faces that cross themselves, by the numbers of their
 * corners: whether between the second and the fourth. */
static void check_crossed(void)
{
    static const struct {
        uint32_t numbers[4];
        bool second;
    } faces[] = {
        {{26, 61, 2, 70}, true},   {{46, 17, 67, 70}, true},  {{36, 35, 8, 21}, true},
        {{23, 11, 46, 59}, true},  {{58, 70, 77, 76}, true},  {{50, 27, 73, 7}, true},
        {{39, 77, 26, 54}, false}, {{39, 38, 31, 0}, false},  {{14, 9, 40, 3}, false},
        {{29, 72, 53, 55}, false}, {{74, 44, 27, 35}, false}, {{42, 75, 14, 29}, false},
    };
    for (size_t i = 0; i < sizeof faces / sizeof *faces; i++)
        CHECK((csg_crossed_corner(faces[i].numbers) % 2 == 0) == faces[i].second, "face %zu", i);
}

int main(void)
{
    struct csg_cutter cutter = {0};
    for (int i = 0; i < num_faces; i++) {
        struct csg_vec3 points[max_corners];
        check_face(&cutter, points, random_face(points, i));
    }
    CHECK(cutter.module != NULL && cutter.num_guessed == 0, "csgcast-tess.so was not used: %zu",
          cutter.num_guessed);
    csg_cutter_finish(&cutter);
    check_squares();
    check_crossed();
    return num_failed > 0;
}
