/* SPDX-License-Identifier: MIT */
/*
 * Surfaces: what lines meet through the hierarchy must be what they meet without it, and the turns
 * over a closed surface must cancel on every line, also on those that go exactly through edges and
 * corners; meshes must come out closed and turned outwards however their faces were written.
 */
#define DICE_SEED 7

#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "dice.h"
#include "mesh/surface.h"
#include "polyhedra/mesh.h"

/* Coordinates on a coarse grid now and then, so that corners line up. */
static struct csg_vec3 random_point(bool grid)
{
    struct csg_vec3 p = {random_between(-3, 3), random_between(-3, 3), random_between(-3, 3)};
    return grid ? csg_vec3(floor(p.x), floor(p.y), floor(p.z)) : p;
}

/* A torus of n by m corners; on a grid its corners are rounded, which folds and flattens faces. */
static void fill_torus(struct csg_mesh *mesh, uint32_t n, uint32_t m, bool grid)
{
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = 0; j < m; j++) {
            const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / m;
            const double r = 2 + cos(b);
            struct csg_vec3 p = {r * cos(a), r * sin(a), sin(b)};
            if (grid)
                p = csg_vec3(floor(2 * p.x) / 2, floor(2 * p.y) / 2, floor(2 * p.z) / 2);
            csg_mesh_add_point(mesh, p);
        }
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = 0; j < m; j++) {
            const uint32_t k = (i + 1) % n, l = (j + 1) % m;
            const uint32_t quad[4] = {i * m + j, k * m + j, k * m + l, i * m + l};
            for (int c = 0; c < 4; c++)
                csg_array_push(&mesh->corners, quad[c]);
            csg_mesh_close_face(mesh);
        }
}

static void turn_some(struct csg_mesh *mesh, double share)
{
    for (size_t i = 0; i < mesh->faces.num; i++) {
        const struct csg_mesh_face face = mesh->faces.data[i];
        if (random_unit() >= share)
            continue;
        for (uint32_t a = face.begin, b = face.end - 1; a < b; a++, b--) {
            const uint32_t corner = mesh->corners.data[a];
            mesh->corners.data[a] = mesh->corners.data[b];
            mesh->corners.data[b] = corner;
        }
    }
}

static struct csg_surface *build(struct csg_mesh *mesh, struct csg_shape *shape, size_t num_gaps)
{
    struct csg_mesh_gaps gaps;
    CHECK(csg_mesh_clean(mesh, NULL) && csg_mesh_orient(mesh, &gaps), "memory");
    CHECK(gaps.num == num_gaps, "%zu gaps, not %zu", gaps.num, num_gaps);
    CHECK(csg_mesh_to_shape(mesh, gaps.num > 0, shape), "memory");
    CHECK(csg_surface_build(shape->surface), "memory");
    return shape->surface;
}

/* The same without the boxes. */
static size_t meet_all(const struct csg_surface *surface, struct csg_vec3 org, struct csg_vec3 dir)
{
    struct csg_surface flat = *surface;
    struct csg_box_node all = {csg_surface_box(surface), 1, 0, (uint32_t)surface->triangles.num};
    struct csg_meetings meetings = {0};
    flat.nodes.data = &all;
    flat.nodes.num = 1;
    CHECK(csg_surface_meet(&flat, &csg_map_identity, org, dir, &meetings), "memory");
    const size_t num = meetings.num;
    free(meetings.data);
    return num;
}

static int check_line(const struct csg_surface *surface, struct csg_vec3 org, struct csg_vec3 dir)
{
    struct csg_meetings meetings = {0};
    int turns = 0;
    CHECK(csg_surface_meet(surface, &csg_map_identity, org, dir, &meetings), "memory");
    for (size_t i = 0; i < meetings.num; i++)
        turns += meetings.data[i].turns;
    CHECK(meetings.num == meet_all(surface, org, dir), "%zu meetings", meetings.num);
    free(meetings.data);
    return turns;
}

/* Any two of corners, points on edges and random points, and directions along the axes. */
static void check_lines(const struct csg_surface *surface, int num, bool grid)
{
    for (int i = 0; i < num; i++) {
        struct csg_vec3 ends[2];
        for (int j = 0; j < 2; j++) {
            const struct csg_triangle *triangle =
                &surface->triangles.data[(size_t)(random_unit() * (double)surface->triangles.num)];
            const struct csg_vec3 a = surface->points.data[triangle->points[0]];
            const struct csg_vec3 b = surface->points.data[triangle->points[1]];
            const double kind = random_unit();
            ends[j] = kind < 0.3   ? a
                      : kind < 0.6 ? csg_scale(0.5, csg_add(a, b))
                                   : random_point(grid);
        }
        struct csg_vec3 dir = csg_sub(ends[1], ends[0]);
        if (random_unit() < 0.3)
            dir = csg_vec3(i % 3 == 0, i % 3 == 1, i % 3 == 2);
        if (csg_length(dir) > 0)
            CHECK(check_line(surface, ends[0], dir) == 0, "the turns do not cancel");
    }
}

static void check_torus(bool grid, double turned)
{
    struct csg_mesh mesh = {0};
    struct csg_shape shape;
    fill_torus(&mesh, 24, 16, grid);
    turn_some(&mesh, turned);
    const struct csg_surface *surface = build(&mesh, &shape, 0);
    check_lines(surface, 2000, grid);
    for (int i = 0; i < 500 && !grid; i++) {
        const struct csg_vec3 p = random_point(false);
        const double across = sqrt(p.x * p.x + p.y * p.y) - 2,
                     r = sqrt(across * across + p.z * p.z);
        if (fabs(r - 1) > 0.05)
            CHECK(csg_surface_winding(surface, &csg_map_identity, p) == (r < 1), "at %g %g %g", p.x,
                  p.y, p.z);
    }
    csg_shape_finish(&shape);
    csg_mesh_finish(&mesh);
}

/* Mirrored, moved far away and copied it is still the same, and still turned outwards. */
static void check_map(void)
{
    const struct csg_map map = {{{-2, 0.5, 0, 1e4}, {0, 1, 0.25, -3e3}, {0, 0, 1, 7}}};
    struct csg_mesh mesh = {0};
    struct csg_shape shape, copy;
    fill_torus(&mesh, 24, 16, false);
    build(&mesh, &shape, 0);
    CHECK(csg_shape_copy(&copy, &shape) && csg_shape_map(&copy, &map), "memory");
    CHECK(copy.surface == shape.surface, "the copy has a surface of its own");
    struct csg_surface *placed = csg_surface_placed(copy.surface, &copy.frame);
    CHECK(placed && csg_surface_build(placed), "memory");
    check_lines(placed, 500, false);
    for (int i = 0; i < 300; i++) {
        const struct csg_vec3 p = random_point(false), q = csg_map_point(&map, p);
        const int before = csg_surface_winding(shape.surface, &shape.frame, p);
        CHECK(before == csg_surface_winding(copy.surface, &copy.frame, q), "at %g %g %g", p.x, p.y,
              p.z);
        CHECK(before == csg_surface_winding(placed, &csg_map_identity, q), "at %g %g %g", p.x, p.y,
              p.z);
        CHECK(before == csg_shape_contains(&shape, p), "at %g %g %g", p.x, p.y, p.z);
    }
    for (size_t i = 0; i < placed->triangles.num; i++) {
        const struct csg_triangle *triangle = &placed->triangles.data[i];
        const struct csg_plane *plane = &placed->planes.data[triangle->plane];
        for (int j = 0; j < 3; j++) {
            const struct csg_vec3 p = placed->points.data[triangle->points[j]];
            CHECK(fabs(csg_dot(plane->normal, p) - plane->offset) < 1e-8, "off its plane");
        }
    }
    csg_surface_destroy(placed);
    csg_shape_finish(&copy);
    csg_shape_finish(&shape);
    csg_mesh_finish(&mesh);
}

/* Without one face there are four edges too many, and lines through the gap do not cancel. */
static void check_open(void)
{
    struct csg_mesh mesh = {0};
    struct csg_shape shape;
    fill_torus(&mesh, 24, 16, false);
    mesh.faces.num--;
    mesh.corners.num -= 4;
    const struct csg_surface *surface = build(&mesh, &shape, 4);
    CHECK(surface->open, "not open");
    csg_shape_finish(&shape);
    csg_mesh_finish(&mesh);
}

static void drop_faces(struct csg_mesh *mesh, double share)
{
    size_t kept = 0;
    for (size_t i = 0; i < mesh->faces.num; i++)
        if (random_unit() >= share)
            mesh->faces.data[kept++] = mesh->faces.data[i];
    mesh->faces.num = kept;
}

/* With its gaps filled nothing passes through any more, and the surface that is shared stays. */
static void check_closed(bool grid, double share)
{
    struct csg_mesh mesh = {0};
    struct csg_shape shape;
    struct csg_mesh_gaps gaps;
    fill_torus(&mesh, 24, 16, grid);
    drop_faces(&mesh, share);
    CHECK(csg_mesh_clean(&mesh, NULL) && csg_mesh_orient(&mesh, &gaps), "memory");
    CHECK(gaps.num > 0 && csg_mesh_to_shape(&mesh, true, &shape), "memory");
    const size_t num = shape.surface->triangles.num;
    struct csg_surface *closed = csg_surface_closed(shape.surface);
    CHECK(closed && csg_surface_build(closed), "memory");
    CHECK(!closed->open && shape.surface->open && shape.surface->triangles.num == num, "open");
    CHECK(csg_surface_closed(closed) == closed, "closed once more");
    check_lines(closed, 1000, grid);
    for (int i = 0; i < 200 && !grid; i++) {
        const struct csg_vec3 p = random_point(false);
        const double across = sqrt(p.x * p.x + p.y * p.y) - 2, r = hypot(across, p.z);
        if (fabs(r - 0.8) > 0.4)
            CHECK(csg_surface_winding(closed, &csg_map_identity, p) == (r < 1), "at %g %g %g", p.x,
                  p.y, p.z);
    }
    csg_surface_destroy(closed);
    csg_surface_destroy(closed);
    csg_shape_finish(&shape);
    csg_mesh_finish(&mesh);
}

/* A single face would vanish: it stays what it is. */
static void check_sheet(void)
{
    struct csg_mesh mesh = {0};
    struct csg_shape shape;
    fill_torus(&mesh, 24, 16, false);
    mesh.faces.num = 1;
    build(&mesh, &shape, 4);
    struct csg_surface *closed = csg_surface_closed(shape.surface);
    CHECK(closed && closed->open, "memory");
    CHECK(closed->triangles.num == shape.surface->triangles.num, "a sheet was filled");
    csg_surface_destroy(closed);
    csg_shape_finish(&shape);
    csg_mesh_finish(&mesh);
}

/* Everything at one point, on one line, in one plane, and far away. */
static void check_degenerate(void)
{
    static const double sizes[3] = {0, 1e-300, 1e150};
    for (int i = 0; i < 3; i++) {
        struct csg_mesh mesh = {0};
        struct csg_shape shape;
        struct csg_mesh_gaps gaps;
        fill_torus(&mesh, 6, 6, false);
        for (size_t j = 0; j < mesh.points.num; j++)
            mesh.points.data[j] = csg_scale(sizes[i], mesh.points.data[j]);
        mesh.size = 3 * sizes[i];
        CHECK(csg_mesh_clean(&mesh, NULL) && csg_mesh_orient(&mesh, &gaps), "memory");
        if (mesh.faces.num > 0) {
            CHECK(csg_mesh_to_shape(&mesh, false, &shape), "memory");
            CHECK(csg_surface_build(shape.surface), "memory");
            CHECK(check_line(shape.surface, csg_vec3(0.1, 0.2, 0.3), csg_vec3(1, 0.5, 0.25)) == 0,
                  "the turns do not cancel");
            csg_shape_finish(&shape);
        }
        csg_mesh_finish(&mesh);
    }
}

int main(void)
{
    check_torus(false, 0);
    check_torus(false, 0.3);
    check_torus(false, 1);
    check_torus(true, 0);
    check_map();
    check_open();
    check_closed(false, 0.02);
    check_closed(false, 0.2);
    check_closed(true, 0.2);
    check_sheet();
    check_degenerate();
    return num_failed > 0;
}
