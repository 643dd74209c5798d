/* SPDX-License-Identifier: MIT */
#include "compare.h"

#include <stdio.h>
#include <stdlib.h>

static const double degree = 3.14159265358979323846 / 180;
static const double thin_offset = 0.02; /* pixels */
static const double sagitta_slack = 1.05;

struct pixel {
    int x, y;
    double z;
    struct csg_vec3 normal;
};

/* Errors of the pixels compared, for maxima and percentiles. */
struct samples {
    double *depths, *normals;
    size_t num_depths, num_normals;
};

/* A NaN is neither a hit nor a miss. */
static bool shows(double z, bool found)
{
    return found ? isfinite(z) : z == INFINITY;
}

static bool depth_agrees(const struct tolerance *tolerance, const struct pixel *pixel,
                         const struct hit *hit, const struct ray *ray)
{
    if (!shows(pixel->z, hit->found))
        return false;
    if (!hit->found)
        return true;
    const double error = fabs(pixel->z - hit->t);
    const double allowed =
        tolerance->absolute > 0 ? tolerance->absolute : tolerance->depth * fabs(hit->t);
    const double slope = fmin(fabs(csg_dot(hit->normal, ray->dir)),
                              fabs(csg_dot(pixel->normal, ray->dir)));
    if (tolerance->sagitta == 0)
        return error <= allowed || error * slope <= tolerance->rounding;
    return error * slope <= tolerance->sagitta * sagitta_slack + allowed;
}

/* Whether the mesh agrees a little aside of the pixel's centre, beyond an edge. */
static bool agrees_aside(const struct reference *reference, const struct tolerance *tolerance,
                         const struct pixel *pixel, const struct hit *center,
                         const struct ray *center_ray)
{
    for (int i = 0; i < 9; i++) {
        const struct ray ray =
            camera_ray(&reference->frustum, reference->width, reference->height,
                       pixel->x + 0.5 + thin_offset * (i % 3 - 1),
                       pixel->y + 0.5 + thin_offset * (i / 3 - 1));
        const struct hit hit = caster_trace(reference->caster, &ray);
        if (depth_agrees(tolerance, pixel, &hit, &ray) &&
            !reference_joins(center, center_ray, &hit, &ray))
            return true;
    }
    return false;
}

static enum verdict judge(const struct reference *reference, const struct tolerance *tolerance,
                          const struct pixel *pixel, size_t i, const struct ray *ray)
{
    const struct hit *hit = &reference->hits[i];
    if (isnan(pixel->z))
        return VERDICT_OFF;
    if (reference->edges[i])
        return shows(pixel->z, hit->found) ? VERDICT_SAME : VERDICT_EDGE;
    if (depth_agrees(tolerance, pixel, hit, ray))
        return VERDICT_SAME;
    if (agrees_aside(reference, tolerance, pixel, hit, ray))
        return VERDICT_THIN;
    return shows(pixel->z, hit->found) ? VERDICT_DEPTH : VERDICT_OFF;
}

/* Degrees. */
static double angle_between(struct csg_vec3 a, struct csg_vec3 b)
{
    return atan2(csg_length(csg_cross(a, b)), csg_dot(a, b)) / degree;
}

/* To the nearest of the 3x3 pixels' normals: the pixel may be just across a crease. */
static double normal_error(const struct reference *reference, const struct pixel *pixel)
{
    double nearest = 180;
    for (int y = pixel->y - 1; y <= pixel->y + 1; y++) {
        for (int x = pixel->x - 1; x <= pixel->x + 1; x++) {
            if (x < 0 || x >= reference->width || y < 0 || y >= reference->height)
                continue;
            const struct hit *hit = &reference->hits[y * reference->width + x];
            if (hit->found)
                nearest = fmin(nearest, angle_between(pixel->normal, hit->normal));
        }
    }
    return nearest;
}

static void add_samples(const struct reference *reference, const struct pixel *pixel, size_t i,
                        const struct ray *ray, struct comparison *result, struct samples *samples)
{
    const struct hit *hit = &reference->hits[i];
    const double error = fabs(pixel->z - hit->t);
    const double offset = error * fabs(csg_dot(hit->normal, ray->dir));
    samples->depths[samples->num_depths++] = error / fabs(hit->t);
    samples->normals[samples->num_normals++] = normal_error(reference, pixel);
    result->max_error = fmax(result->max_error, error);
    result->max_offset = fmax(result->max_offset, offset);
    result->rms_offset += offset * offset;
    result->num_compared++;
}

static void count(enum verdict verdict, struct comparison *result)
{
    result->num_edge_mismatches += verdict == VERDICT_EDGE;
    result->num_thin += verdict == VERDICT_THIN;
    result->num_off += verdict == VERDICT_OFF;
    result->num_depth += verdict == VERDICT_DEPTH;
}

static int compare_doubles(const void *left, const void *right)
{
    const double *a = left, *b = right;
    return (*a > *b) - (*a < *b);
}

/* The largest value, and the one that 99.9 % do not exceed. */
static void summarize(double *values, size_t num, double *max, double *p999)
{
    if (num == 0)
        return;
    qsort(values, num, sizeof *values, compare_doubles);
    *max = values[num - 1];
    *p999 = values[(size_t)((double)(num - 1) * 0.999)];
}

static void compare_pixel(const struct reference *reference, const struct csgcast_image *image,
                          const struct tolerance *tolerance, struct comparison *result,
                          struct samples *samples, size_t i)
{
    const float *n = &image->normal[3 * i];
    const struct pixel pixel = {
        .x = (int)(i % (size_t)reference->width),
        .y = (int)(i / (size_t)reference->width),
        .z = (double)image->z[i],
        .normal = csg_vec3((double)n[0], (double)n[1], (double)n[2]),
    };
    const struct ray ray = camera_ray(&reference->frustum, reference->width, reference->height,
                                      pixel.x + 0.5, pixel.y + 0.5);
    const enum verdict verdict = judge(reference, tolerance, &pixel, i, &ray);
    const bool found = reference->hits[i].found;
    result->verdicts[i] = (uint8_t)verdict;
    result->num_hits += found;
    result->num_edges += reference->edges[i];
    count(verdict, result);
    if (found && isfinite(pixel.z) && !reference->edges[i] && verdict != VERDICT_THIN)
        add_samples(reference, &pixel, i, &ray, result, samples);
}

bool compare(const struct reference *reference, const struct csgcast_image *image,
             const struct tolerance *tolerance, struct comparison *result)
{
    const size_t num_pixels = (size_t)reference->width * (size_t)reference->height;
    struct samples samples = {
        .depths = calloc(num_pixels, sizeof *samples.depths),
        .normals = calloc(num_pixels, sizeof *samples.normals),
    };
    *result = (struct comparison){.verdicts = calloc(num_pixels, 1)};
    const bool ok = samples.depths && samples.normals && result->verdicts;
    if (!ok)
        fprintf(stderr, "referee: out of memory\n");
    for (size_t i = 0; ok && i < num_pixels; i++)
        compare_pixel(reference, image, tolerance, result, &samples, i);
    if (ok && result->num_compared > 0) {
        result->rms_offset = sqrt(result->rms_offset / (double)result->num_compared);
        summarize(samples.depths, samples.num_depths, &result->max_depth, &result->p999_depth);
        summarize(samples.normals, samples.num_normals, &result->max_normal, &result->p999_normal);
    }
    free(samples.depths);
    free(samples.normals);
    return ok;
}
