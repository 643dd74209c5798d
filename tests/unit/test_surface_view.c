/* SPDX-License-Identifier: MIT */
/*
 * Surfaces as the screen sees them: what the rays of a picture's pixels meet must be in the list of
 * its triangles and between the keys, wherever the surface is: as small as some pixels, partly
 * beside the picture, around the eye.
 */
#define DICE_SEED 11

#include <stdlib.h>

#include "carrier/own_faces.h"
#include "check.h"
#include "dice.h"
#include "pack/surface.h"
#include "polyhedra/mesh.h"
#include "solids/shape.h"

enum { size = 24 };

struct picture {
    struct csgcast_frustum frustum;
    struct csg_screen screen;
    struct csg_pixel at;
};

/* A torus of n by m corners, thin where it is not turned, so that boxes are far larger than it. */
static void fill_torus(struct csg_shape *shape, uint32_t n, uint32_t m)
{
    struct csg_mesh mesh = {0};
    struct csg_mesh_gaps gaps;
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = 0; j < m; j++) {
            const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / m;
            const double r = 2 + 0.7 * cos(b);
            csg_mesh_add_point(&mesh, csg_vec3(r * cos(a), r * sin(a), 0.7 * sin(b)));
        }
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = 0; j < m; j++) {
            const uint32_t k = (i + 1) % n, l = (j + 1) % m;
            const uint32_t quad[4] = {i * m + j, k * m + j, k * m + l, i * m + l};
            for (int c = 0; c < 4; c++)
                csg_array_push(&mesh.corners, quad[c]);
            csg_mesh_close_face(&mesh);
        }
    CHECK(csg_mesh_clean(&mesh, NULL) && csg_mesh_orient(&mesh, &gaps), "memory");
    CHECK(csg_mesh_to_shape(&mesh, false, shape) && csg_surface_build(shape->surface), "memory");
    csg_mesh_finish(&mesh);
}

static struct csg_map random_place(void)
{
    struct csg_map place;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            place.m[i][j] = random_between(-0.5, 0.5) + (i == j);
    return place;
}

static struct picture picture_of(const struct csg_shape *shape, double distance, double half,
                                 bool orthographic)
{
    const struct csg_box box = csg_box_map(&shape->frame, &shape->surface->nodes.data[0].box);
    struct picture picture = {.frustum = {.eye = {random_between(-1, 1), -distance, 0.3},
                                          .right = {1, 0, 0},
                                          .up = {0, 0, 1},
                                          .forward = {0, 1, 0},
                                          .half_width = half,
                                          .half_height = half,
                                          .orthographic = orthographic}};
    csg_screen_init(&picture.screen, &picture.frustum, size, size, &box, true);
    picture.at = csg_screen_pixel(&picture.screen, csg_vec3(0, 0, 0));
    return picture;
}

/* The ray through a pixel's centre, by the test's own projection; t is along the view axis. */
static void ray_of(const struct picture *picture, int x, int y, struct csg_vec3 *org,
                   struct csg_vec3 *dir)
{
    const struct csgcast_frustum *frustum = &picture->frustum;
    const double across = frustum->half_width * ((2 * x + 1.0) / size - 1);
    const double up = frustum->half_height * ((2 * y + 1.0) / size - 1);
    const double s = frustum->orthographic ? 0 : 1;
    *org = csg_vec3(frustum->eye[0] + (1 - s) * across, frustum->eye[1],
                    frustum->eye[2] + (1 - s) * up);
    *dir = csg_vec3(s * across, 1, s * up);
}

static bool is_listed(const struct csg_view_list *list, uint32_t triangle)
{
    for (size_t i = 0; i < list->num; i++)
        if (list->data[i] == triangle)
            return true;
    return false;
}

/* Where the line meets the triangle's plane. */
static double place_on(const struct csg_surface_view *view, uint32_t triangle, struct csg_vec3 org,
                       struct csg_vec3 dir)
{
    const uint32_t face = view->surface->triangles.data[triangle].plane;
    const struct csg_plane plane = csg_own_plane(view->surface, face, &view->inverse);
    return (plane.offset - csg_dot(plane.normal, org)) / csg_dot(plane.normal, dir);
}

/* Returns how many triangles the pixel's ray meets. */
static size_t check_pixel(const struct picture *picture, const struct csg_surface_view *view,
                          const struct csg_view_list *list, const double keys[2], int x, int y)
{
    struct csg_vec3 org, dir;
    struct csg_meetings meetings = {0};
    size_t num = 0;
    ray_of(picture, x, y, &org, &dir);
    CHECK(csg_surface_meet(view->surface, &view->place, org, dir, &meetings), "memory");
    for (size_t i = 0; i < meetings.num; i++) {
        const uint32_t triangle = meetings.data[i].triangle;
        const double t = place_on(view, triangle, org, dir);
        const double key = csg_screen_key(&picture->screen, t);
        if (!picture->frustum.orthographic && !(t > 1e-3))
            continue;
        num++;
        CHECK(is_listed(list, triangle), "pixel %d %d: triangle %u is not listed", x, y, triangle);
        CHECK(keys[0] <= key && key <= keys[1], "pixel %d %d: key %g is not in %g to %g", x, y, key,
              keys[0], keys[1]);
    }
    free(meetings.data);
    return num;
}

static double least(double a, double b, double c)
{
    return fmin(a, fmin(b, c));
}

/* A listed triangle has a pixel's centre in the rectangle around it, but for a margin, or a corner
 * behind the eye. */
static void check_wanted(const struct csg_surface_view *view, uint32_t triangle)
{
    const double margin = 2e-3;
    const uint32_t *corners = view->surface->triangles.data[triangle].points;
    const struct csg_view_point *a = &view->points[corners[0]], *b = &view->points[corners[1]],
                                *c = &view->points[corners[2]];
    if (isnan(a->key + b->key + c->key))
        return;
    const double lo[2] = {least(a->x, b->x, c->x), least(a->y, b->y, c->y)};
    const double hi[2] = {-least(-a->x, -b->x, -c->x), -least(-a->y, -b->y, -c->y)};
    for (int i = 0; i < 2; i++)
        CHECK(floor(hi[i] + margin - 0.5) >= lo[i] - margin - 0.5,
              "triangle %u has no pixel between %g and %g", triangle, lo[i], hi[i]);
}

static size_t check_picture(const struct csg_shape *shape, const struct picture *picture)
{
    struct csg_surface_views views = {0};
    struct csg_surface_view view;
    struct csg_view_list list = {0};
    double keys[2];
    size_t num = 0;
    const struct csg_view_rect rect = {{0.5 - picture->at.x, 0.5 - picture->at.y},
                                       {size - 0.5 - picture->at.x, size - 0.5 - picture->at.y}};
    csg_surface_view_init(&view, shape, 0, false);
    CHECK(csg_array_push(&views, view), "memory");
    CHECK(csg_surface_views_project(&views, &picture->screen, picture->at, 1), "memory");
    csg_surface_view_range(&views.data[0], &rect, keys);
    CHECK(csg_surface_view_list(&views.data[0], &rect, &list), "memory");
    for (int i = 0; i < size * size; i++)
        num += check_pixel(picture, &views.data[0], &list, keys, i % size, i / size);
    for (size_t i = 0; i < list.num; i++)
        check_wanted(&views.data[0], list.data[i]);
    csg_surface_views_clear(&views);
    free(views.data);
    free(list.data);
    return num;
}

/* Distances and half the pictures' sides at distance 1, or in parallel: the surface over the whole
 * picture, some pixels of it, most of it beside the picture, and around the eye. */
static void check_views(uint32_t n, uint32_t m)
{
    static const double views[][2] = {{12, 0.3}, {60, 0.9}, {900, 1}, {7, 0.05}, {1, 0.8}};
    struct csg_shape shape;
    fill_torus(&shape, n, m);
    for (int i = 0; i < 5 * 8; i++) {
        const double *view = views[i % 5];
        shape.frame = random_place();
        const bool orthographic = i >= 5 * 6;
        const struct picture picture =
            picture_of(&shape, view[0], orthographic ? view[0] * view[1] : view[1], orthographic);
        const size_t num = check_picture(&shape, &picture);
        CHECK(num > 0 || i % 5 != 0, "view %d shows nothing", i);
    }
    csg_shape_finish(&shape);
}

int main(void)
{
    check_views(12, 8);
    check_views(120, 60);
    return num_failed > 0;
}
