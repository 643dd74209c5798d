/* SPDX-License-Identifier: MIT */
#include "evidence.h"

#include <stdio.h>
#include <stdlib.h>

static const int max_printed = 3;

void evidence_print(const struct csg_mesh_view *reference, const struct csgcast_image *image,
                    const struct csg_comparison *comparison)
{
    int num_printed = 0;
    const size_t num_pixels = (size_t)reference->width * (size_t)reference->height;
    for (size_t i = 0; i < num_pixels && num_printed < max_printed; i++) {
        const struct csg_mesh_hit *hit = &reference->hits[i];
        const float *n = &image->normal[3 * i];
        if (comparison->verdicts[i] != CSG_VERDICT_OFF &&
            comparison->verdicts[i] != CSG_VERDICT_DEPTH)
            continue;
        printf("    pixel %zu,%zu: z %.9g n %.3f %.3f %.3f, mesh z %.9g n %.3f %.3f %.3f\n",
               i % (size_t)reference->width, i / (size_t)reference->width, (double)image->z[i],
               (double)n[0], (double)n[1], (double)n[2], hit->found ? hit->t : INFINITY,
               hit->normal.x, hit->normal.y, hit->normal.z);
        num_printed++;
    }
}

static void set_color(float *rgba, double r, double g, double b)
{
    rgba[0] = (float)r;
    rgba[1] = (float)g;
    rgba[2] = (float)b;
    rgba[3] = 1;
}

/* A normal as a colour; a miss is black. */
static void set_normal(float *rgba, bool found, double x, double y, double z)
{
    if (found)
        set_color(rgba, 0.5 + 0.5 * x, 0.5 + 0.5 * y, 0.5 + 0.5 * z);
    else
        set_color(rgba, 0, 0, 0);
}

static void set_verdict(float *rgba, const struct csg_comparison *comparison, bool found, size_t i)
{
    const double gray = found ? 0.6 : 0.2;
    switch ((enum csg_verdict)comparison->verdicts[i]) {
    case CSG_VERDICT_EDGE:
        set_color(rgba, 1, 1, 0);
        break;
    case CSG_VERDICT_THIN:
        set_color(rgba, 0.2, 0.2, 1);
        break;
    case CSG_VERDICT_OFF:
        set_color(rgba, 1, 0, 0);
        break;
    case CSG_VERDICT_DEPTH:
        set_color(rgba, 1, 0, 1);
        break;
    default:
        set_color(rgba, gray, gray, gray);
    }
}

static void write_picture(const char *stem, const char *kind, const struct csg_mesh_view *reference,
                          float *rgba)
{
    char path[512];
    const struct csgcast_image image = {.rgba = rgba};
    snprintf(path, sizeof path, "%s.%s.png", stem, kind);
    if (csgcast_image_write(path, reference->width, reference->height, &image, NULL))
        printf("    see %s\n", path);
}

void evidence_write(const char *stem, const struct csg_mesh_view *reference,
                    const struct csgcast_image *image, const struct csg_comparison *comparison)
{
    const size_t num_pixels = (size_t)reference->width * (size_t)reference->height;
    float *rgba = calloc(num_pixels * 4, sizeof *rgba);
    if (!rgba)
        return;
    for (size_t i = 0; i < num_pixels; i++) {
        const float *n = &image->normal[3 * i];
        set_normal(&rgba[4 * i], isfinite((double)image->z[i]), (double)n[0], (double)n[1],
                   (double)n[2]);
    }
    write_picture(stem, "out", reference, rgba);
    for (size_t i = 0; i < num_pixels; i++) {
        const struct csg_mesh_hit *hit = &reference->hits[i];
        set_normal(&rgba[4 * i], hit->found, hit->normal.x, hit->normal.y, hit->normal.z);
    }
    write_picture(stem, "ref", reference, rgba);
    for (size_t i = 0; i < num_pixels; i++)
        set_verdict(&rgba[4 * i], comparison, reference->hits[i].found, i);
    write_picture(stem, "diff", reference, rgba);
    free(rgba);
}
