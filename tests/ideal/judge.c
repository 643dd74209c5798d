/* SPDX-License-Identifier: MIT */
#include "judge.h"

#include <math.h>
#include <stdlib.h>

#define DEGREE (3.14159265358979323846 / 180)

struct picture picture_create(int width, int height)
{
    const size_t num = (size_t)width * (size_t)height;
    struct picture picture = {width, height, malloc(num * sizeof(float)),
                              malloc(3 * num * sizeof(float)), malloc(num * sizeof(float))};
    if (!picture.z || !picture.normal || !picture.id)
        abort();
    return picture;
}

void picture_free(struct picture *picture)
{
    free(picture->z);
    free(picture->normal);
    free(picture->id);
}

bool picture_render(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                    const struct csgcast_view *view, struct picture *picture)
{
    const struct csgcast_image image = {
        .z = picture->z, .normal = picture->normal, .id = picture->id};
    return csgcast_render(renderer, scene, view, &image);
}

double picture_angle(const float *a, const float *b)
{
    const double x = (double)a[1] * b[2] - (double)a[2] * b[1],
                 y = (double)a[2] * b[0] - (double)a[0] * b[2],
                 z = (double)a[0] * b[1] - (double)a[1] * b[0];
    const double dot = (double)a[0] * b[0] + (double)a[1] * b[1] + (double)a[2] * b[2];
    return atan2(sqrt(x * x + y * y + z * z), dot) / DEGREE;
}

bool picture_is_edge(const struct picture *p, int x, int y, double degrees)
{
    const int here = y * p->width + x;
    for (int v = y > 0 ? y - 1 : 0; v <= y + 1 && v < p->height; v++)
        for (int u = x > 0 ? x - 1 : 0; u <= x + 1 && u < p->width; u++) {
            const int there = v * p->width + u;
            if ((p->id[there] < 0) != (p->id[here] < 0))
                return true;
            if (p->id[here] >= 0 &&
                (picture_angle(p->normal + 3 * there, p->normal + 3 * here) > degrees ||
                 fabsf(p->z[there] - p->z[here]) > 0.01f * fabsf(p->z[here])))
                return true;
        }
    return false;
}

struct ideal_view ideal_view_create(const struct ideal_scene *scene,
                                    const struct csgcast_frustum *frustum, int width, int height)
{
    struct ideal_view view = {scene, frustum, width, height, NULL};
    view.pixels = malloc((size_t)width * (size_t)height * sizeof *view.pixels);
    if (!view.pixels)
        abort();
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            struct ideal_pixel *pixel = &view.pixels[(size_t)y * (size_t)width + (size_t)x];
            pixel->ray = ideal_ray(scene, frustum, width, height, x + 0.5L, y + 0.5L);
            pixel->hit = ideal_trace(scene, &pixel->ray);
        }
    return view;
}

void ideal_view_free(struct ideal_view *view)
{
    free(view->pixels);
}

bool ideal_view_is_edge(const struct ideal_view *view, int x, int y)
{
    return ideal_is_edge(view->scene, view->frustum, view->width, view->height, x, y);
}

static bool is_right(const struct picture *picture, size_t i, const struct ideal_view *view,
                     const struct tolerance *tolerance)
{
    const struct ideal_scene *ideal = view->scene;
    const struct ideal_ray *ray = &view->pixels[i].ray;
    const struct ideal_hit hit = view->pixels[i].hit;
    const real z = picture->z[i];
    if (!hit.hit || isinf(z))
        return !hit.hit && isinf(z) && picture->id[i] < 0;
    if (!isfinite(z) || picture->id[i] < 0)
        return false;
    const struct ideal_vec point = ideal_add(ray->org, ideal_scale(z, ray->dir));
    if (ideal_form_distance(hit.form, point) > (real)tolerance->surface * ideal->size)
        return false;
    const struct ideal_vec away =
        ideal_add(ideal_to_world(ideal, hit.normal), ideal_scale(-1, ideal->move));
    const float expected[3] = {(float)away.x, (float)away.y, (float)away.z};
    const double angle = picture_angle(expected, picture->normal + 3 * i);
    return (hit.from_inside ? 180 - angle : angle) <= tolerance->normal;
}

void judge_picture(const struct picture *picture, const struct ideal_view *view,
                   const struct tolerance *tolerance, struct verdict *verdict)
{
    for (int y = 0; y < view->height; y++)
        for (int x = 0; x < view->width; x++) {
            const size_t i = (size_t)y * (size_t)view->width + (size_t)x;
            verdict->rays++;
            if (is_right(picture, i, view, tolerance))
                continue;
            if (ideal_view_is_edge(view, x, y)) {
                verdict->edge++;
                continue;
            }
            if (!verdict->wrong++) {
                verdict->x = x;
                verdict->y = y;
            }
        }
}
