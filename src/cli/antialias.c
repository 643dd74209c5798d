/* SPDX-License-Identifier: MIT */
#include "antialias.h"

#include <stddef.h>

#include "messages.h"
#include "view_options.h"

enum { NUM_CHANNELS = 4 };

bool csg_antialias_view(const struct csgcast_view *view, int n, struct csgcast_view *fine)
{
    const int longer = view->width > view->height ? view->width : view->height;
    *fine = *view;
    if (longer > CSG_MAX_IMAGE_SIZE / n) {
        csg_cli_error("--antialias=%d of %d pixels takes more than %d rays in a row: the largest "
                      "--imgsize with it is %d",
                      n, longer, CSG_MAX_IMAGE_SIZE, CSG_MAX_IMAGE_SIZE / n);
        return false;
    }
    fine->width *= n;
    fine->height *= n;
    return true;
}

static void reduce_bytes(uint8_t *pixel, const uint8_t *rays, size_t stride, unsigned n)
{
    for (size_t channel = 0; channel < NUM_CHANNELS; channel++) {
        unsigned sum = n * n / 2; /* rounds */
        for (size_t y = 0; y < n; y++)
            for (size_t x = 0; x < n; x++)
                sum += rays[y * stride + NUM_CHANNELS * x + channel];
        pixel[channel] = (uint8_t)(sum / (n * n));
    }
}

static void reduce_floats(float *pixel, const float *rays, size_t stride, unsigned n)
{
    for (size_t channel = 0; channel < NUM_CHANNELS; channel++) {
        double sum = 0;
        for (size_t y = 0; y < n; y++)
            for (size_t x = 0; x < n; x++)
                sum += (double)rays[y * stride + NUM_CHANNELS * x + channel];
        pixel[channel] = (float)(sum / (n * n));
    }
}

/* Each pixel is written before what is still to be read. */
void csg_antialias_reduce(const struct csgcast_image *image, int width, int height, int n)
{
    const size_t columns = (size_t)width, step = (size_t)n, stride = NUM_CHANNELS * columns * step;
    for (size_t y = 0; n > 1 && y < (size_t)height; y++)
        for (size_t x = 0; x < columns; x++) {
            const size_t pixel = NUM_CHANNELS * (y * columns + x);
            const size_t rays = y * step * stride + NUM_CHANNELS * x * step;
            if (image->rgba8)
                reduce_bytes(image->rgba8 + pixel, image->rgba8 + rays, stride, (unsigned)n);
            if (image->rgba)
                reduce_floats(image->rgba + pixel, image->rgba + rays, stride, (unsigned)n);
        }
}
