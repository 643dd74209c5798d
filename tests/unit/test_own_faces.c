/* SPDX-License-Identifier: MIT */
/*
 * Of a surface of many faces nearly all lie on no other one's plane, and those that do are found
 * all the same: a relief of random heights with a plateau, whose corners are as level as arithmetic
 * leaves them.
 */
#define DICE_SEED 3

#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "csg/own_faces.h"
#include "dice.h"

enum { SIDE = 120, PLATEAU_BEGIN = 40, PLATEAU_END = 70 };

static bool is_level(uint32_t i)
{
    return i >= PLATEAU_BEGIN && i < PLATEAU_END;
}

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

/* Those of the plateau are one plane's, the others each its own. */
static void check_faces(const struct csg_surface *surface)
{
    const uint32_t first = 2 * (PLATEAU_BEGIN * SIDE + PLATEAU_BEGIN);
    size_t num_apart = 0, num_joined = 0;
    for (uint32_t i = 0; i < surface->planes.num; i++) {
        const uint32_t own = surface->own[i].plane;
        if (is_level(i / 2 / SIDE) && is_level(i / 2 % SIDE))
            num_apart += own != surface->own[first].plane;
        else
            num_joined += own != i;
    }
    CHECK(num_apart == 0, "%zu faces of the plateau are not on its plane", num_apart);
    CHECK(num_joined == 0, "%zu faces of the slopes are on another one's plane", num_joined);
}

int main(void)
{
    struct csg_surface *surface = calloc(1, sizeof *surface);
    if (!surface)
        return 1;
    add_points(surface);
    add_triangles(surface);
    csg_surface_measure(surface);
    const struct csg_box box = csg_surface_box(surface);
    surface->extents = csg_surface_extents(surface, &csg_map_identity);
    const bool found = surface->extents && csg_own_faces_find(surface, &box);
    CHECK(found, "out of memory");
    if (found)
        check_faces(surface);
    csg_surface_destroy(surface);
    return num_failed != 0;
}
