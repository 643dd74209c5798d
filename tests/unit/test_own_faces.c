/* SPDX-License-Identifier: MIT */
/*
 * Of a surface of many faces nearly all lie upon no other one, and those that do are found all the
 * same: a relief of random heights with a plateau, whose corners are as level as arithmetic leaves
 * them, and a lid on a part of it. Level neighbours of the lid, and level faces that meet in an
 * edge or a corner, lie upon nothing.
 */
#define DICE_SEED 3

#include <stdio.h>
#include <stdlib.h>

#include "carrier/own_faces.h"
#include "check.h"
#include "dice.h"

enum { SIDE = 120, PLATEAU_BEGIN = 40, PLATEAU_END = 70, LID_END = 60 };

static void add_points(struct csg_surface *surface)
{
    for (uint32_t i = 0; i <= SIDE; i++)
        for (uint32_t j = 0; j <= SIDE; j++) {
            const bool level =
                i >= PLATEAU_BEGIN && i <= PLATEAU_END && j >= PLATEAU_BEGIN && j <= PLATEAU_END;
            const double z = level ? 7 + random_between(-1e-14, 1e-14) : random_between(0, 5);
            csg_array_push(&surface->points, csg_vec3(i, j, z));
        }
}

static void add_triangle(struct csg_surface *surface, uint32_t a, uint32_t b, uint32_t c)
{
    const struct csg_vec3 *points = surface->points.data;
    const struct csg_vec3 across =
        csg_cross(csg_sub(points[b], points[a]), csg_sub(points[c], points[a]));
    const struct csg_vec3 normal = csg_scale(1 / csg_length(across), across);
    const struct csg_triangle triangle = {{a, b, c}, (uint32_t)surface->planes.num};
    csg_array_push(&surface->triangles, triangle);
    csg_array_push(&surface->planes, ((struct csg_plane){normal, csg_dot(normal, points[a])}));
}

static void add_triangles(struct csg_surface *surface)
{
    for (uint32_t i = 0; i < SIDE; i++)
        for (uint32_t j = 0; j < SIDE; j++) {
            const uint32_t a = i * (SIDE + 1) + j, b = a + SIDE + 1;
            add_triangle(surface, a, b, b + 1);
            add_triangle(surface, a, b + 1, a + 1);
        }
}

/* The other way round, and cut along the other diagonals. */
static void add_lid(struct csg_surface *surface)
{
    for (uint32_t i = PLATEAU_BEGIN; i < LID_END; i++)
        for (uint32_t j = PLATEAU_BEGIN; j < LID_END; j++) {
            const uint32_t a = i * (SIDE + 1) + j, b = a + SIDE + 1;
            add_triangle(surface, a, a + 1, b);
            add_triangle(surface, b, a + 1, b + 1);
        }
}

static bool is_under_lid(uint32_t i)
{
    return i >= PLATEAU_BEGIN && i < LID_END;
}

static bool is_same_plane(const struct csg_surface *surface, uint32_t i, uint32_t j)
{
    const struct csg_plane *p = &surface->planes.data[i], *q = &surface->planes.data[j];
    return p->normal.x == q->normal.x && p->normal.y == q->normal.y && p->normal.z == q->normal.z &&
           p->offset == q->offset;
}

/* The lid's and those below it are on one plane, the others each on its own. */
static void check_faces(const struct csg_surface *surface)
{
    const uint32_t first = 2 * (PLATEAU_BEGIN * SIDE + PLATEAU_BEGIN), num_below = 2 * SIDE * SIDE;
    size_t num_apart = 0, num_turned = 0, num_joined = 0;
    for (uint32_t i = 0; i < surface->planes.num; i++) {
        const struct csg_own_face *own = &surface->own[i], *like = &surface->own[first];
        const bool is_lid = i >= num_below;
        if (is_lid || (is_under_lid(i / 2 / SIDE) && is_under_lid(i / 2 % SIDE))) {
            num_apart += own->plane != like->plane;
            num_turned += (own->flipped != like->flipped) != is_lid;
        } else {
            num_joined += own->plane != i && !is_same_plane(surface, own->plane, i);
        }
    }
    CHECK(num_apart == 0, "%zu faces of lid and plateau are not on its plane", num_apart);
    CHECK(num_turned == 0, "%zu faces of lid and plateau look the wrong way", num_turned);
    CHECK(num_joined == 0, "%zu other faces are on another one's plane", num_joined);
}

/* As csg_surfaces_build does. */
static bool find_faces(struct csg_surface *surface)
{
    csg_surface_measure(surface);
    const struct csg_box box = csg_surface_box(surface);
    surface->extents = csg_surface_extents(surface, &csg_map_identity);
    const bool found =
        surface->extents && csg_surface_build(surface) && csg_own_faces_find(surface, &box, 2);
    CHECK(found, "out of memory");
    return found;
}

/* So many sheets upon each other that nobody compares them: all are on one plane. */
static void check_stack(void)
{
    enum { NUM_SHEETS = 2000 };
    struct csg_surface *surface = calloc(1, sizeof *surface);
    if (!surface)
        return;
    for (uint32_t i = 0; i < NUM_SHEETS; i++) {
        for (int j = 0; j < 3; j++)
            csg_array_push(&surface->points, csg_vec3(j == 1, j == 2, random_between(0, 1e-14)));
        add_triangle(surface, 3 * i, 3 * i + 1, 3 * i + 2);
    }
    const bool found = find_faces(surface);
    CHECK(!found || surface->num_own == 1, "a stack of sheets has %zu planes", surface->num_own);
    csg_surface_destroy(surface);
}

int main(void)
{
    struct csg_surface *surface = calloc(1, sizeof *surface);
    if (!surface)
        return 1;
    add_points(surface);
    add_triangles(surface);
    add_lid(surface);
    const bool found = find_faces(surface);
    if (found)
        check_faces(surface);
    csg_surface_destroy(surface);
    check_stack();
    return num_failed != 0;
}
