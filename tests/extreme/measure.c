/* SPDX-License-Identifier: MIT */
#include "measure.h"

#include <math.h>
#include <stdlib.h>

/* A hit further than this, relative, from where it should be is on another surface. */
#define OTHER_DEPTH 1e-4
#define OTHER_NORMAL 5.0

/* Nearer to a silhouette than this, in pixels, the ray goes through it: a hit is as right as a
 * miss. */
#define TIE 1e-7

static void errors_add(struct errors *errors, double value)
{
    if (errors->num == errors->capacity) {
        errors->capacity = 2 * errors->capacity + 4096;
        errors->data = realloc(errors->data, errors->capacity * sizeof *errors->data);
        if (!errors->data)
            abort();
    }
    errors->data[errors->num++] = value;
    errors->sorted = false;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

double errors_quantile(struct errors *errors, double quantile)
{
    if (errors->num == 0)
        return 0;
    if (!errors->sorted)
        qsort(errors->data, errors->num, sizeof *errors->data, compare);
    errors->sorted = true;
    return errors->data[(size_t)(quantile * (double)(errors->num - 1))];
}

void measure_free(struct measure *measure)
{
    free(measure->depth.data);
    free(measure->normal.data);
    *measure = (struct measure){0};
}

static void note(struct measure *measure, size_t *count, int x, int y)
{
    measure->x = x;
    measure->y = y;
    ++*count;
}

static bool is_broken(const struct picture *picture, size_t i)
{
    const float *n = picture->normal + 3 * i;
    const bool hit = picture->id[i] >= 0;
    return isnan(picture->id[i]) || isnan(picture->z[i]) || isinf(picture->z[i]) == hit ||
           !isfinite(n[0]) || !isfinite(n[1]) || !isfinite(n[2]);
}

static double normal_error(const struct ideal_hit *hit, const float *normal)
{
    const real s = hit->from_inside ? -1 : 1;
    const float expected[3] = {(float)(s * hit->normal.x), (float)(s * hit->normal.y),
                               (float)(s * hit->normal.z)};
    return picture_angle(expected, normal);
}

static void measure_pixel(struct measure *measure, const struct picture *picture,
                          const struct ideal_view *view, double extent, int x, int y)
{
    const int width = view->width, height = view->height;
    const size_t i = (size_t)y * (size_t)width + (size_t)x;
    const struct ideal_hit hit = view->pixels[i].hit;
    measure->rays++;
    if (is_broken(picture, i)) {
        note(measure, &measure->nan, x, y);
        return;
    }
    if (hit.hit != (picture->id[i] >= 0)) {
        const double away = ideal_silhouette(view->scene, view->frustum, width, height, x, y);
        measure->displaced = fmax(measure->displaced, away);
        measure->misses += away > TIE;
        if (!ideal_view_is_edge(view, x, y))
            note(measure, &measure->outside, x, y);
        return;
    }
    if (!hit.hit)
        return;
    const double least = view->frustum->orthographic ? extent : 0;
    const double depth = (double)(fabsl(picture->z[i] - hit.t) / fmaxl(fabsl(hit.t), least));
    const double normal = normal_error(&hit, picture->normal + 3 * i);
    if (depth > OTHER_DEPTH || normal > OTHER_NORMAL) {
        if (!ideal_view_is_edge(view, x, y))
            note(measure, &measure->other, x, y);
        return;
    }
    errors_add(&measure->depth, depth);
    errors_add(&measure->normal, normal);
}

void measure_add(struct measure *measure, const struct picture *picture,
                 const struct ideal_view *view, double extent)
{
    for (int y = 0; y < view->height; y++)
        for (int x = 0; x < view->width; x++)
            measure_pixel(measure, picture, view, extent, x, y);
}
