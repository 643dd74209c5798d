/* SPDX-License-Identifier: MIT */
#include "compare/mesh_view.h"

#include <stdlib.h>
#include <string.h>

/*
 * Two neighbours' planes bridge their depths when they meet within the pixel between them. The
 * interval is stretched by this much of itself: a few narrow facets may lie between.
 */
static const double bridge_slack = 0.5;
static const double bridge_floor = 1e-6; /* of the depth: two equal planes */

struct csg_mesh_ray csg_frustum_ray(const struct csgcast_frustum *frustum, int width, int height,
                                    double x, double y)
{
    const double right = frustum->half_width * (2 * x / width - 1);
    const double up = frustum->half_height * (1 - 2 * y / height);
    const struct csg_vec3 eye = csg_vec3_of(frustum->eye);
    const struct csg_vec3 forward = csg_vec3_of(frustum->forward);
    const struct csg_vec3 across = csg_add(csg_scale(right, csg_vec3_of(frustum->right)),
                                           csg_scale(up, csg_vec3_of(frustum->up)));
    if (frustum->orthographic)
        return (struct csg_mesh_ray){.org = csg_add(eye, across), .dir = forward, .tnear = 0};
    return (struct csg_mesh_ray){.org = eye, .dir = csg_add(forward, across), .tnear = 0};
}

static struct csg_mesh_ray pixel_ray(const struct csg_mesh_view *view, int x, int y)
{
    return csg_frustum_ray(&view->frustum, view->width, view->height, x + 0.5, y + 0.5);
}

static size_t pixel_index(const struct csg_mesh_view *view, int x, int y)
{
    return (size_t)y * (size_t)view->width + (size_t)x;
}

bool csg_mesh_view_init(struct csg_mesh_view *view, struct csg_caster *caster,
                        const struct csgcast_frustum *frustum, int width, int height)
{
    const size_t num_pixels = (size_t)width * (size_t)height;
    *view = (struct csg_mesh_view){
        .caster = caster,
        .frustum = *frustum,
        .width = width,
        .height = height,
        .hits = calloc(num_pixels, sizeof *view->hits),
        .edges = calloc(num_pixels, 1),
    };
    if (!view->hits || !view->edges) {
        csg_mesh_view_finish(view);
        return false;
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const struct csg_mesh_ray ray = pixel_ray(view, x, y);
            view->hits[pixel_index(view, x, y)] = csg_caster_trace(caster, &ray);
        }
    }
    return !caster->failed;
}

void csg_mesh_view_finish(struct csg_mesh_view *view)
{
    free(view->hits);
    free(view->edges);
    *view = (struct csg_mesh_view){0};
}

/* The depth at which ray meets the plane of the hit that other sees; infinite when parallel. */
static double plane_depth(const struct csg_mesh_hit *hit, const struct csg_mesh_ray *other,
                          const struct csg_mesh_ray *ray)
{
    const struct csg_vec3 point = csg_add(other->org, csg_scale(hit->t, other->dir));
    const double slope = csg_dot(hit->normal, ray->dir);
    const double t = csg_dot(hit->normal, csg_sub(point, ray->org)) / slope;
    return isfinite(t) && t > 0 ? t : INFINITY;
}

/* The depths from here to there, as seen along the plane of here, with slack on both sides. */
static void depth_interval(double here, double there, double *lo, double *hi)
{
    const double slack = bridge_slack * fabs(there - here) + bridge_floor * fabs(here);
    *lo = fmin(here, there) - slack;
    *hi = fmax(here, there) + slack;
}

bool csg_mesh_view_joins(const struct csg_mesh_hit *a, const struct csg_mesh_ray *ray_a,
                         const struct csg_mesh_hit *b, const struct csg_mesh_ray *ray_b)
{
    double a_lo, a_hi, b_lo, b_hi;
    if (!a->found || !b->found)
        return a->found == b->found;
    depth_interval(a->t, plane_depth(a, ray_a, ray_b), &a_lo, &a_hi);
    depth_interval(b->t, plane_depth(b, ray_b, ray_a), &b_lo, &b_hi);
    return a_lo <= b_hi && b_lo <= a_hi;
}

static bool is_continuous(const struct csg_mesh_view *view, int x0, int y0, int x1, int y1)
{
    const struct csg_mesh_hit *a = &view->hits[pixel_index(view, x0, y0)];
    const struct csg_mesh_hit *b = &view->hits[pixel_index(view, x1, y1)];
    const struct csg_mesh_ray ray_a = pixel_ray(view, x0, y0);
    const struct csg_mesh_ray ray_b = pixel_ray(view, x1, y1);
    return csg_mesh_view_joins(a, &ray_a, b, &ray_b);
}

static void mark_pair(struct csg_mesh_view *view, int x0, int y0, int x1, int y1)
{
    const size_t a = pixel_index(view, x0, y0), b = pixel_index(view, x1, y1);
    if (x1 < 0 || x1 >= view->width || y1 >= view->height)
        return;
    if (!is_continuous(view, x0, y0, x1, y1))
        view->edges[a] = view->edges[b] = 1;
}

/* How many pixels the length spans at the depth of the nearest hit. */
static double pixels_spanned(const struct csg_mesh_view *view, double length)
{
    const struct csgcast_frustum *frustum = &view->frustum;
    double nearest = INFINITY;
    const size_t num_pixels = (size_t)view->width * (size_t)view->height;
    for (size_t i = 0; i < num_pixels; i++)
        if (view->hits[i].found)
            nearest = fmin(nearest, view->hits[i].t);
    const double pixel =
        2 * frustum->half_height / view->height * (frustum->orthographic ? 1 : nearest);
    return length > 0 ? length / pixel : 0;
}

/* Widens the marked area by one pixel in all eight directions. */
static bool dilate(uint8_t *marks, int width, int height)
{
    const size_t num_pixels = (size_t)width * (size_t)height;
    uint8_t *before = malloc(num_pixels);
    if (!before)
        return false;
    memcpy(before, marks, num_pixels);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            for (int v = y > 0 ? y - 1 : 0; v <= y + 1 && v < height; v++)
                for (int u = x > 0 ? x - 1 : 0; u <= x + 1 && u < width; u++)
                    marks[y * width + x] |= before[v * width + u];
    free(before);
    return true;
}

bool csg_mesh_view_mark_edges(struct csg_mesh_view *view, double sagitta)
{
    for (int y = 0; y < view->height; y++) {
        for (int x = 0; x < view->width; x++) {
            mark_pair(view, x, y, x + 1, y);
            mark_pair(view, x, y, x - 1, y + 1);
            mark_pair(view, x, y, x, y + 1);
            mark_pair(view, x, y, x + 1, y + 1);
        }
    }
    /* Where two surfaces meet at an angle the edge moves by more than either of them. */
    const int margin = (int)fmin(ceil(2 * pixels_spanned(view, sagitta)), 16);
    for (int i = 0; i < margin; i++)
        if (!dilate(view->edges, view->width, view->height))
            return false;
    return true;
}
