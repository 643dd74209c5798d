/* SPDX-License-Identifier: MIT */
#include "report/errors.h"

#include <math.h>
#include <stdlib.h>

#include "common/order.h"

static const double degrees = 180 / 3.14159265358979323846;

struct samples {
    double *depths, *normals;
    size_t num;
};

static bool is_nan(const struct csgcast_image *picture, size_t i)
{
    const float *n = picture->normal + 3 * i;
    return isnan(picture->z[i]) || isnan(n[0]) || isnan(n[1]) || isnan(n[2]);
}

static double angle(const float *a, const float *b)
{
    const double x = (double)a[1] * (double)b[2] - (double)a[2] * (double)b[1];
    const double y = (double)a[2] * (double)b[0] - (double)a[0] * (double)b[2];
    const double z = (double)a[0] * (double)b[1] - (double)a[1] * (double)b[0];
    const double dot =
        (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
    return atan2(sqrt(x * x + y * y + z * z), dot) * degrees;
}

static void add_pixel(const struct csgcast_image *picture, const struct csgcast_image *reference,
                      double scale, size_t i, struct csg_picture_errors *errors,
                      struct samples *samples)
{
    const bool expected = isfinite(reference->z[i]), got = isfinite(picture->z[i]);
    errors->covered += expected;
    if (is_nan(picture, i)) {
        errors->nan++;
        return;
    }
    errors->silhouette += expected != got;
    errors->extra += got && !expected;
    if (!expected || !got)
        return;
    const double z = (double)reference->z[i];
    const double depth = fabs((double)picture->z[i] - z) / (scale > 0 ? scale : fabs(z));
    const bool ids = picture->id && reference->id;
    if (ids ? (int)picture->id[i] != (int)reference->id[i] : depth > CSG_OTHER_SURFACE) {
        errors->other++;
        return;
    }
    samples->depths[samples->num] = depth;
    samples->normals[samples->num++] = angle(picture->normal + 3 * i, reference->normal + 3 * i);
}

static double quantile(const double *sorted, size_t num, double share)
{
    return num ? sorted[(size_t)(share * (double)(num - 1))] : 0;
}

static void summarize(const struct samples *samples, struct csg_picture_errors *errors)
{
    const size_t num = samples->num;
    qsort(samples->depths, num, sizeof *samples->depths, csg_compare_doubles);
    qsort(samples->normals, num, sizeof *samples->normals, csg_compare_doubles);
    double sum = 0;
    for (size_t i = 0; i < num; i++)
        sum += samples->depths[i];
    errors->depth_mean = num ? sum / (double)num : 0;
    errors->depth_p99 = quantile(samples->depths, num, 0.99);
    errors->depth_p999 = quantile(samples->depths, num, 0.999);
    errors->depth_max = quantile(samples->depths, num, 1);
    errors->normal_p99 = quantile(samples->normals, num, 0.99);
    errors->normal_p999 = quantile(samples->normals, num, 0.999);
}

bool csg_picture_errors(const struct csgcast_image *picture, const struct csgcast_image *reference,
                        size_t num_pixels, double scale, struct csg_picture_errors *errors)
{
    struct samples samples = {
        .depths = calloc(num_pixels + 1, sizeof *samples.depths),
        .normals = calloc(num_pixels + 1, sizeof *samples.normals),
    };
    const bool ok = samples.depths && samples.normals;
    *errors = (struct csg_picture_errors){.pixels = num_pixels};
    for (size_t i = 0; ok && i < num_pixels; i++)
        add_pixel(picture, reference, scale, i, errors, &samples);
    if (ok)
        summarize(&samples, errors);
    free(samples.depths);
    free(samples.normals);
    return ok;
}

double csg_picture_errors_wrong(const struct csg_picture_errors *errors)
{
    const size_t wrong = errors->silhouette + errors->other + errors->nan;
    const size_t either = errors->covered + errors->extra;
    return either ? (double)wrong / (double)either : wrong > 0;
}

void csg_picture_errors_add(struct csg_picture_errors *sum, const struct csg_picture_errors *more)
{
    const double num = (double)(sum->covered + more->covered);
    sum->depth_mean =
        num > 0
            ? (sum->depth_mean * (double)sum->covered + more->depth_mean * (double)more->covered) /
                  num
            : 0;
    sum->pixels += more->pixels;
    sum->covered += more->covered;
    sum->silhouette += more->silhouette;
    sum->extra += more->extra;
    sum->other += more->other;
    sum->nan += more->nan;
    sum->depth_p99 = fmax(sum->depth_p99, more->depth_p99);
    sum->depth_p999 = fmax(sum->depth_p999, more->depth_p999);
    sum->depth_max = fmax(sum->depth_max, more->depth_max);
    sum->normal_p99 = fmax(sum->normal_p99, more->normal_p99);
    sum->normal_p999 = fmax(sum->normal_p999, more->normal_p999);
}
