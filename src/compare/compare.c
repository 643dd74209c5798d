/* SPDX-License-Identifier: MIT */
#include "compare/compare.h"

#include <stdlib.h>

static const double degree = 3.14159265358979323846 / 180;
static const double thin_offset = 0.02; /* pixels */
static const double sagitta_slack = 1.05;

struct pixel {
    int x, y;
    double z;
    struct csg_vec3 normal;
};

/* Errors of the pixels compared, for means, maxima and percentiles. */
struct sample {
    double value;
    size_t pixel;
};

enum { DEPTH, RELATIVE, OFFSET, NORMAL, NUM_ERRORS };

struct samples {
    struct sample *data[NUM_ERRORS];
    size_t num;
};

/* A NaN is neither a hit nor a miss. */
static bool shows(double z, bool found)
{
    return found ? isfinite(z) : z == INFINITY;
}

static bool depth_agrees(const struct csg_compare_tolerance *tolerance, const struct pixel *pixel,
                         const struct csg_mesh_hit *hit, const struct csg_mesh_ray *ray)
{
    if (!shows(pixel->z, hit->found))
        return false;
    if (!hit->found)
        return true;
    const double error = fabs(pixel->z - hit->t);
    const double allowed =
        tolerance->absolute > 0 ? tolerance->absolute : tolerance->depth * fabs(hit->t);
    const double slope =
        fmin(fabs(csg_dot(hit->normal, ray->dir)), fabs(csg_dot(pixel->normal, ray->dir)));
    if (tolerance->sagitta == 0)
        return error <= allowed || error * slope <= tolerance->rounding;
    return error * slope <= tolerance->sagitta * sagitta_slack + allowed;
}

/* Whether the mesh agrees a little aside of the pixel's centre, beyond an edge. */
static bool agrees_aside(const struct csg_mesh_view *view,
                         const struct csg_compare_tolerance *tolerance, const struct pixel *pixel,
                         const struct csg_mesh_hit *center, const struct csg_mesh_ray *center_ray)
{
    for (int i = 0; i < 9; i++) {
        const struct csg_mesh_ray ray = csg_frustum_ray(&view->frustum, view->width, view->height,
                                                        pixel->x + 0.5 + thin_offset * (i % 3 - 1),
                                                        pixel->y + 0.5 + thin_offset * (i / 3 - 1));
        const struct csg_mesh_hit hit = csg_caster_trace(view->caster, &ray);
        if (depth_agrees(tolerance, pixel, &hit, &ray) &&
            !csg_mesh_view_joins(center, center_ray, &hit, &ray))
            return true;
    }
    return false;
}

/* Of two faces that lie upon each other a mesh may have what is meant and what rounding left. */
static bool shows_skin(const struct csg_compare_tolerance *tolerance, const struct pixel *pixel,
                       const struct csg_mesh_hit *hit)
{
    const double allowed =
        tolerance->absolute > 0 ? tolerance->absolute : tolerance->depth * fabs(hit->skin);
    return isfinite(pixel->z) && isfinite(hit->skin) && fabs(pixel->z - hit->skin) <= allowed;
}

static enum csg_verdict judge(const struct csg_mesh_view *view,
                              const struct csg_compare_tolerance *tolerance,
                              const struct pixel *pixel, size_t i, const struct csg_mesh_ray *ray)
{
    const struct csg_mesh_hit *hit = &view->hits[i];
    if (isnan(pixel->z))
        return CSG_VERDICT_OFF;
    if (view->edges[i])
        return shows(pixel->z, hit->found) ? CSG_VERDICT_SAME : CSG_VERDICT_EDGE;
    if (depth_agrees(tolerance, pixel, hit, ray))
        return CSG_VERDICT_SAME;
    if (shows_skin(tolerance, pixel, hit))
        return CSG_VERDICT_SKIN;
    if (agrees_aside(view, tolerance, pixel, hit, ray))
        return CSG_VERDICT_THIN;
    return shows(pixel->z, hit->found) ? CSG_VERDICT_DEPTH : CSG_VERDICT_OFF;
}

/* Degrees. */
static double angle_between(struct csg_vec3 a, struct csg_vec3 b)
{
    return atan2(csg_length(csg_cross(a, b)), csg_dot(a, b)) / degree;
}

/* To the nearest of the 3x3 pixels' normals: the pixel may be just across a crease. */
static double normal_error(const struct csg_mesh_view *view, const struct pixel *pixel)
{
    double nearest = 180;
    for (int y = pixel->y - 1; y <= pixel->y + 1; y++) {
        for (int x = pixel->x - 1; x <= pixel->x + 1; x++) {
            if (x < 0 || x >= view->width || y < 0 || y >= view->height)
                continue;
            const struct csg_mesh_hit *hit = &view->hits[y * view->width + x];
            if (hit->found)
                nearest = fmin(nearest, angle_between(pixel->normal, hit->normal));
        }
    }
    return nearest;
}

static void add_samples(const struct csg_mesh_view *view, const struct pixel *pixel, size_t i,
                        const struct csg_mesh_ray *ray, struct csg_comparison *result,
                        struct samples *samples)
{
    const struct csg_mesh_hit *hit = &view->hits[i];
    const double error = fabs(pixel->z - hit->t);
    const double offset = error * fabs(csg_dot(hit->normal, ray->dir));
    const double errors[NUM_ERRORS] = {error, error / fabs(hit->t), offset,
                                       normal_error(view, pixel)};
    for (int k = 0; k < NUM_ERRORS; k++)
        samples->data[k][samples->num] = (struct sample){errors[k], i};
    samples->num++;
    result->rms_offset += offset * offset;
    result->num_compared++;
}

static void count(enum csg_verdict verdict, struct csg_comparison *result)
{
    result->num_edge_mismatches += verdict == CSG_VERDICT_EDGE;
    result->num_thin += verdict == CSG_VERDICT_THIN;
    result->num_off += verdict == CSG_VERDICT_OFF;
    result->num_depth += verdict == CSG_VERDICT_DEPTH;
}

static int compare_samples(const void *left, const void *right)
{
    const struct sample *a = left, *b = right;
    return (a->value > b->value) - (a->value < b->value);
}

static struct csg_errors summarize(struct sample *samples, size_t num, int width)
{
    double sum = 0;
    if (num == 0)
        return (struct csg_errors){0};
    qsort(samples, num, sizeof *samples, compare_samples);
    for (size_t i = 0; i < num; i++)
        sum += samples[i].value;
    return (struct csg_errors){
        .mean = sum / (double)num,
        .p99 = samples[(size_t)((double)(num - 1) * 0.99)].value,
        .p999 = samples[(size_t)((double)(num - 1) * 0.999)].value,
        .max = samples[num - 1].value,
        .x = (int)(samples[num - 1].pixel % (size_t)width),
        .y = (int)(samples[num - 1].pixel / (size_t)width),
    };
}

static void summarize_all(struct samples *samples, int width, struct csg_comparison *result)
{
    struct csg_errors *const errors[NUM_ERRORS] = {&result->depth, &result->relative,
                                                   &result->offset, &result->normal};
    for (int k = 0; k < NUM_ERRORS; k++)
        *errors[k] = summarize(samples->data[k], samples->num, width);
    if (result->num_compared > 0)
        result->rms_offset = sqrt(result->rms_offset / (double)result->num_compared);
}

static void compare_pixel(const struct csg_mesh_view *view, const struct csgcast_image *image,
                          const struct csg_compare_tolerance *tolerance,
                          struct csg_comparison *result, struct samples *samples, size_t i)
{
    const float *n = &image->normal[3 * i];
    const struct pixel pixel = {
        .x = (int)(i % (size_t)view->width),
        .y = (int)(i / (size_t)view->width),
        .z = (double)image->z[i],
        .normal = csg_vec3((double)n[0], (double)n[1], (double)n[2]),
    };
    const struct csg_mesh_ray ray =
        csg_frustum_ray(&view->frustum, view->width, view->height, pixel.x + 0.5, pixel.y + 0.5);
    const enum csg_verdict verdict = judge(view, tolerance, &pixel, i, &ray);
    const bool found = view->hits[i].found || verdict == CSG_VERDICT_SKIN;
    result->verdicts[i] = (uint8_t)verdict;
    result->num_hits += found;
    result->num_missing += found && !isfinite(pixel.z);
    result->num_extra += !found && isfinite(pixel.z);
    result->num_edges += view->edges[i];
    count(verdict, result);
    if (found && isfinite(pixel.z) && !view->edges[i] && verdict != CSG_VERDICT_THIN &&
        verdict != CSG_VERDICT_SKIN)
        add_samples(view, &pixel, i, &ray, result, samples);
}

double csg_comparison_iou(const struct csg_comparison *comparison)
{
    const size_t either = comparison->num_hits + comparison->num_extra;
    return either ? (double)(comparison->num_hits - comparison->num_missing) / (double)either : 1;
}

bool csg_compare(const struct csg_mesh_view *view, const struct csgcast_image *image,
                 const struct csg_compare_tolerance *tolerance, struct csg_comparison *result)
{
    const size_t num_pixels = (size_t)view->width * (size_t)view->height;
    struct samples samples = {.num = 0};
    *result = (struct csg_comparison){.verdicts = calloc(num_pixels, 1)};
    bool ok = result->verdicts != NULL;
    for (int k = 0; k < NUM_ERRORS; k++) {
        samples.data[k] = calloc(num_pixels, sizeof *samples.data[k]);
        ok = ok && samples.data[k];
    }
    for (size_t i = 0; ok && i < num_pixels; i++)
        compare_pixel(view, image, tolerance, result, &samples, i);
    if (ok)
        summarize_all(&samples, view->width, result);
    for (int k = 0; k < NUM_ERRORS; k++)
        free(samples.data[k]);
    return ok && !view->caster->failed;
}
