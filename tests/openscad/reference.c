/* SPDX-License-Identifier: MIT */
#include "compare.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/*
 * Two neighbours' planes bridge their depths when they meet within the pixel between them. The
 * interval is stretched by this much of itself: a few narrow facets may lie between.
 */
static const double bridge_slack = 0.5;
static const double bridge_floor = 1e-6; /* of the depth: two equal planes */

static struct ray pixel_ray(const struct reference *reference, int x, int y)
{
    return camera_ray(&reference->frustum, reference->width, reference->height, x + 0.5, y + 0.5);
}

static size_t pixel_index(const struct reference *reference, int x, int y)
{
    return (size_t)y * (size_t)reference->width + (size_t)x;
}

bool reference_init(struct reference *reference, struct caster *caster,
                    const struct csgcast_frustum *frustum, int width, int height)
{
    const size_t num_pixels = (size_t)width * (size_t)height;
    *reference = (struct reference){
        .caster = caster,
        .frustum = *frustum,
        .width = width,
        .height = height,
        .hits = calloc(num_pixels, sizeof *reference->hits),
        .edges = calloc(num_pixels, 1),
    };
    if (!reference->hits || !reference->edges) {
        fprintf(stderr, "referee: out of memory\n");
        reference_finish(reference);
        return false;
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const struct ray ray = pixel_ray(reference, x, y);
            reference->hits[pixel_index(reference, x, y)] = caster_trace(caster, &ray);
        }
    }
    return true;
}

void reference_finish(struct reference *reference)
{
    free(reference->hits);
    free(reference->edges);
    *reference = (struct reference){0};
}

/* The depth at which ray meets the plane of the hit that other sees; infinite when parallel. */
static double plane_depth(const struct hit *hit, const struct ray *other, const struct ray *ray)
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

bool reference_joins(const struct hit *a, const struct ray *ray_a, const struct hit *b,
                     const struct ray *ray_b)
{
    double a_lo, a_hi, b_lo, b_hi;
    if (!a->found || !b->found)
        return a->found == b->found;
    depth_interval(a->t, plane_depth(a, ray_a, ray_b), &a_lo, &a_hi);
    depth_interval(b->t, plane_depth(b, ray_b, ray_a), &b_lo, &b_hi);
    return a_lo <= b_hi && b_lo <= a_hi;
}

static bool is_continuous(const struct reference *reference, int x0, int y0, int x1, int y1)
{
    const struct hit *a = &reference->hits[pixel_index(reference, x0, y0)];
    const struct hit *b = &reference->hits[pixel_index(reference, x1, y1)];
    const struct ray ray_a = pixel_ray(reference, x0, y0);
    const struct ray ray_b = pixel_ray(reference, x1, y1);
    return reference_joins(a, &ray_a, b, &ray_b);
}

static void mark_pair(struct reference *reference, int x0, int y0, int x1, int y1)
{
    const size_t a = pixel_index(reference, x0, y0), b = pixel_index(reference, x1, y1);
    if (x1 < 0 || x1 >= reference->width || y1 >= reference->height)
        return;
    if (!is_continuous(reference, x0, y0, x1, y1))
        reference->edges[a] = reference->edges[b] = 1;
}

/* How many pixels the length spans at the depth of the nearest hit. */
static double pixels_spanned(const struct reference *reference, double length)
{
    const struct csgcast_frustum *frustum = &reference->frustum;
    double nearest = INFINITY;
    const size_t num_pixels = (size_t)reference->width * (size_t)reference->height;
    for (size_t i = 0; i < num_pixels; i++)
        if (reference->hits[i].found)
            nearest = fmin(nearest, reference->hits[i].t);
    const double pixel = 2 * frustum->half_height / reference->height *
                         (frustum->orthographic ? 1 : nearest);
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

void reference_mark_edges(struct reference *reference, double sagitta)
{
    for (int y = 0; y < reference->height; y++) {
        for (int x = 0; x < reference->width; x++) {
            mark_pair(reference, x, y, x + 1, y);
            mark_pair(reference, x, y, x - 1, y + 1);
            mark_pair(reference, x, y, x, y + 1);
            mark_pair(reference, x, y, x + 1, y + 1);
        }
    }
    /* Where two surfaces meet at an angle the edge moves by more than either of them. */
    const int margin = (int)fmin(ceil(2 * pixels_spanned(reference, sagitta)), 16);
    for (int i = 0; i < margin; i++)
        if (!dilate(reference->edges, reference->width, reference->height))
            fprintf(stderr, "referee: out of memory\n");
}
