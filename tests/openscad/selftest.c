/* SPDX-License-Identifier: MIT */

/*
 * The referee's own test, without csgcast: rays at a prism against clipping by its planes, rays
 * aimed exactly at corners and edges, and whether csg_compare() notices what is wrong in a picture.
 */

#include "camera.h"
#include "compare/compare.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { num_sides = 7, num_triangles = 4 * num_sides, width = 96, height = 64 };

static const double pi = 3.14159265358979323846;
static int num_failures;

static void expect(bool ok, const char *what)
{
    if (!ok) {
        printf("FAIL %s\n", what);
        num_failures++;
    }
}

static struct csg_vec3 prism_corner(int side, double z)
{
    const double angle = 2 * pi * (side % num_sides) / num_sides;
    return csg_vec3(100 + 5 * cos(angle), 3 * sin(angle), z);
}

/* An oblique prism around (100, 0, 4). */
static void make_prism(struct csg_triangle *triangles)
{
    const struct csg_vec3 bottom = csg_vec3(100, 0, 0), top = csg_vec3(100, 0, 8);
    for (int i = 0; i < num_sides; i++) {
        const struct csg_vec3 a = prism_corner(i, 0), b = prism_corner(i + 1, 0);
        const struct csg_vec3 c = prism_corner(i, 8), d = prism_corner(i + 1, 8);
        triangles[4 * i] = (struct csg_triangle){{a, b, d}};
        triangles[4 * i + 1] = (struct csg_triangle){{a, d, c}};
        triangles[4 * i + 2] = (struct csg_triangle){{bottom, b, a}};
        triangles[4 * i + 3] = (struct csg_triangle){{top, c, d}};
    }
}

/* The interval of the ray inside all planes of a convex mesh. */
static bool clip(const struct csg_soup *mesh, const struct csg_mesh_ray *ray, double *tnear,
                 double *tfar)
{
    *tnear = -INFINITY;
    *tfar = INFINITY;
    for (size_t i = 0; i < mesh->num_triangles; i++) {
        const struct csg_vec3 *p = mesh->triangles[i].corner;
        const struct csg_vec3 normal = csg_cross(csg_sub(p[1], p[0]), csg_sub(p[2], p[0]));
        const double slope = csg_dot(normal, ray->dir);
        const double t = csg_dot(normal, csg_sub(p[0], ray->org)) / slope;
        if (slope < 0)
            *tnear = fmax(*tnear, t);
        else if (slope > 0)
            *tfar = fmin(*tfar, t);
    }
    return *tnear < *tfar;
}

static void test_clipping(const struct csg_soup *mesh, struct csg_caster *caster)
{
    const struct csgcast_view view = {.width = width, .height = height};
    size_t num_wrong = 0;
    for (unsigned seed = 0; seed < 20; seed++) {
        struct csgcast_view random = view;
        random.camera = camera_random(seed, &mesh->bounds);
        const struct csgcast_frustum frustum = camera_frustum(&random, &mesh->bounds);
        for (int i = 0; i < width * height; i++) {
            double tnear, tfar;
            const struct csg_mesh_ray ray =
                csg_frustum_ray(&frustum, width, height, i % width + 0.5, i / width + 0.5);
            const bool found = clip(mesh, &ray, &tnear, &tfar);
            const struct csg_mesh_hit hit = csg_caster_trace(caster, &ray);
            num_wrong += hit.found != found || (found && fabs(hit.t / tnear - 1) > 1e-12);
        }
    }
    expect(num_wrong == 0, "rays against clipping by the prism's planes");
}

static void test_edges(const struct csg_soup *mesh, struct csg_caster *caster)
{
    size_t num_lost = 0;
    for (int i = 0; i < num_triangles * 3; i++) {
        const struct csg_vec3 *corners = mesh->triangles[i / 3].corner;
        const struct csg_vec3 corner = corners[i % 3], next = corners[(i + 1) % 3];
        const struct csg_vec3 inside = csg_vec3(100, 0, 4);
        const struct csg_vec3 targets[2] = {corner, csg_scale(0.5, csg_add(corner, next))};
        for (int k = 0; k < 2; k++) {
            const struct csg_vec3 out = csg_sub(targets[k], inside);
            const struct csg_mesh_ray ray = {.org = csg_add(inside, csg_scale(9, out)),
                                             .dir = csg_scale(-1, out)};
            const struct csg_mesh_hit hit = csg_caster_trace(caster, &ray);
            num_lost += !hit.found || fabs(hit.t - 8) > 1e-9;
        }
    }
    expect(num_lost == 0, "rays aimed at corners and edges");
}

static void test_inside(struct csg_caster *caster)
{
    const struct csg_mesh_ray ray = {.org = csg_vec3(100, 0, 4), .dir = csg_vec3(0, 0, 2)};
    const struct csg_mesh_hit hit = csg_caster_trace(caster, &ray);
    expect(hit.found && fabs(hit.t - 2) < 1e-12 && hit.normal.z > 0.999, "a ray from inside");
}

struct picture {
    float z[width * height], normal[width * height * 3];
};

static void copy_hits(const struct csg_mesh_view *reference, struct picture *picture)
{
    for (int i = 0; i < width * height; i++) {
        const struct csg_mesh_hit *hit = &reference->hits[i];
        picture->z[i] = hit->found ? (float)hit->t : INFINITY;
        picture->normal[3 * i] = (float)hit->normal.x;
        picture->normal[3 * i + 1] = (float)hit->normal.y;
        picture->normal[3 * i + 2] = (float)hit->normal.z;
    }
}

static struct csg_comparison judge(const struct csg_mesh_view *reference, struct picture *picture)
{
    const struct csgcast_image image = {.z = picture->z, .normal = picture->normal};
    const struct csg_compare_tolerance tolerance = {.depth = 1e-5};
    struct csg_comparison result;
    expect(csg_compare(reference, &image, &tolerance, &result), "compare");
    free(result.verdicts);
    return result;
}

static void test_compare(const struct csg_soup *mesh, struct csg_caster *caster)
{
    static struct picture picture;
    const struct csgcast_view view = {.width = width, .height = height};
    const struct csgcast_frustum frustum = camera_frustum(&view, &mesh->bounds);
    const int middle = height / 2 * width + width / 2;
    struct csg_mesh_view reference;
    if (!csg_mesh_view_init(&reference, caster, &frustum, width, height))
        exit(1);
    expect(csg_mesh_view_mark_edges(&reference, 0), "edges");

    copy_hits(&reference, &picture);
    struct csg_comparison result = judge(&reference, &picture);
    expect(result.num_hits > 500 && result.num_compared > 300, "the prism is in view");
    expect(result.num_off + result.num_depth + result.num_edge_mismatches + result.num_thin == 0,
           "a perfect picture");
    picture.z[middle] = INFINITY;
    picture.z[0] = 10;
    expect(judge(&reference, &picture).num_off == 2, "a hole and a speck");
    copy_hits(&reference, &picture);
    picture.z[middle] = picture.z[0] = NAN;
    expect(judge(&reference, &picture).num_off == 2, "not a number");
    copy_hits(&reference, &picture);
    picture.z[middle] *= 1.00002F;
    expect(judge(&reference, &picture).num_depth == 1, "a wrong depth");
    copy_hits(&reference, &picture);
    for (int i = 0; i < 3; i++)
        picture.normal[3 * middle + i] *= -1;
    expect(judge(&reference, &picture).normal.max > 90, "a normal into the solid");
    csg_mesh_view_finish(&reference);
}

int main(void)
{
    struct csg_triangle triangles[num_triangles];
    struct csg_soup mesh = {
        .triangles = triangles, .num_triangles = num_triangles, .bounds = csg_box_empty};
    make_prism(triangles);
    for (int i = 0; i < num_triangles * 3; i++)
        csg_box_extend(&mesh.bounds, triangles[i / 3].corner[i % 3]);
    struct csg_caster *caster = csg_caster_create(&mesh, &(struct csg_log){0});
    if (!caster)
        return 1;
    test_clipping(&mesh, caster);
    test_edges(&mesh, caster);
    test_inside(caster);
    test_compare(&mesh, caster);
    csg_caster_destroy(caster);
    printf("%s\n", num_failures ? "FAIL" : "ok");
    return num_failures > 0;
}
