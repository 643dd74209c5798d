/* SPDX-License-Identifier: MIT */

/* The pictures of `csgcast compare`. */

#include "canvas.h"
#include "compare.h"
#include "messages.h"

#include <math.h>
#include <string.h>

enum { MARGIN = 8, LABEL = 20, LEGEND = 44, MAX_COLUMNS = 3 };

/* Differences are drawn from this part of the scene's radius on, over so many decades. */
#define LEAST_DIFFERENCE 1e-6
#define NUM_DECADES 5

static const struct csg_color white = {1, 1, 1}, ink = {0.1F, 0.1F, 0.15F};
static const struct csg_color nothing = {0.93F, 0.93F, 0.91F};
static const struct csg_color only_ours = {0.0F, 0.65F, 0.75F}, only_mesh = {0.85F, 0.2F, 0.75F};
static const struct csg_color unexplained = {0.95F, 0.05F, 0.05F};

static struct csg_color mix(struct csg_color a, struct csg_color b, double t)
{
    const float s = (float)t;
    return (struct csg_color){a.r + s * (b.r - a.r), a.g + s * (b.g - a.g), a.b + s * (b.b - a.b)};
}

/* 0 to 1: from dark blue over green and yellow to orange, ever lighter but at the end. */
static struct csg_color heat(double value)
{
    static const struct csg_color ramp[] = {
        {0.16F, 0.16F, 0.3F}, {0.15F, 0.33F, 0.55F}, {0.12F, 0.53F, 0.55F}, {0.3F, 0.72F, 0.45F},
        {0.75F, 0.85F, 0.3F}, {1.0F, 0.85F, 0.25F},  {1.0F, 0.6F, 0.15F}};
    const int last = (int)(sizeof ramp / sizeof *ramp) - 1;
    const double place = fmin(fmax(value, 0), 1) * last;
    const int i = place < last ? (int)place : last - 1;
    return mix(ramp[i], ramp[i + 1], place - i);
}

/* OpenSCAD's light on one colour. */
static struct csg_color shade(const struct csgcast_frustum *frustum, double x, double y, double z)
{
    static const double light[3] = {-0.57735, 0.57735, 0.57735}; /* right, up, to the eye */
    double towards = 0;
    const double n[3] = {x, y, z};
    for (int i = 0; i < 3; i++)
        towards += n[i] * (light[0] * frustum->right[i] + light[1] * frustum->up[i] -
                           light[2] * frustum->forward[i]);
    const float s = (float)fmin(0.2 + fabs(towards), 1.2);
    return (struct csg_color){fminf(0.82F * s, 1), fminf(0.78F * s, 1), fminf(0.62F * s, 1)};
}

static struct csg_color color_of(const struct csg_compared *compared,
                                 const struct csg_compared_view *view, unsigned column, size_t i)
{
    const struct csg_mesh_hit *hit = &view->mesh.hits[i];
    const float *n = view->normal + 3 * i;
    const bool ours = isfinite(view->z[i]);
    if (column == 0)
        return ours ? shade(&view->mesh.frustum, (double)n[0], (double)n[1], (double)n[2]) : white;
    if (column == 1)
        return hit->found ? shade(&view->mesh.frustum, hit->normal.x, hit->normal.y, hit->normal.z)
                          : white;
    if (view->wrong[i])
        return unexplained;
    if (ours != hit->found)
        return ours ? only_ours : only_mesh;
    if (!ours)
        return nothing;
    const double error = fabs((double)view->z[i] - hit->t) / compared->radius;
    return heat(log10(fmax(error, LEAST_DIFFERENCE) / LEAST_DIFFERENCE) / NUM_DECADES);
}

static void draw_cell(struct csg_canvas *canvas, const struct csg_compared *compared,
                      const struct csg_compared_view *view, unsigned column, int x, int y)
{
    for (int v = 0; v < view->mesh.height; v++)
        for (int u = 0; u < view->mesh.width; u++)
            csg_canvas_set(
                canvas, x + u, y + v,
                color_of(compared, view, column, (size_t)v * (size_t)view->mesh.width + (size_t)u));
}

static void print_label(const struct csg_compared *compared, const struct csg_compared_view *view,
                        unsigned column, char text[96])
{
    const struct csg_comparison *r = &view->result;
    if (column == 0)
        snprintf(text, 96, "csgcast, %s, facets %s", view->label, compared->options->facets);
    else if (column == 1)
        snprintf(text, 96, "mesh, %zu triangles", compared->num_triangles);
    else
        snprintf(text, 96, "IoU %.6f  99%%: %.2g  max %.2g", csg_comparison_iou(r), r->depth.p99,
                 r->depth.max);
    const int room = view->mesh.width / CSG_CANVAS_CHARACTER;
    text[room < 95 ? room : 95] = 0; /* not into the next column */
}

static int draw_key(struct csg_canvas *canvas, int x, int y, struct csg_color color,
                    const char *text)
{
    csg_canvas_fill(canvas, x, y, 10, 10, color);
    csg_canvas_text(canvas, x + 14, y + 2, ink, text);
    return x + 14 + CSG_CANVAS_CHARACTER * ((int)strlen(text) + 1);
}

/* The scale of differences, and what the other colours mean. */
static void draw_legend(struct csg_canvas *canvas, const struct csg_compared *compared, int x,
                        int y, int width)
{
    char text[32];
    for (int u = 0; u < width; u++)
        csg_canvas_fill(canvas, x + u, y, 1, 10, heat((double)u / (width - 1)));
    for (int i = 0, end = x; i <= NUM_DECADES; i++) {
        snprintf(text, sizeof text, "%.1g", LEAST_DIFFERENCE * pow(10, i) * compared->radius);
        const int length = CSG_CANVAS_CHARACTER * (int)strlen(text);
        const int at = x + i * (width - 1) / NUM_DECADES;
        const int begin = i == 0 ? at : i == NUM_DECADES ? at - length : at - length / 2;
        if (begin < end)
            continue; /* a narrow picture has room for some of them only */
        csg_canvas_text(canvas, begin, y + 13, ink, text);
        end = begin + length + CSG_CANVAS_CHARACTER;
    }
    x = draw_key(canvas, MARGIN, y + 26, only_ours, "only csgcast");
    x = draw_key(canvas, x, y + 26, only_mesh, "only mesh");
    draw_key(canvas, x, y + 26, unexplained, "wrong");
}

static int columns_of(unsigned sheet, unsigned columns[MAX_COLUMNS])
{
    int num = 0;
    if (sheet & CSG_SHEET_SIDE_BY_SIDE) {
        columns[num++] = 0;
        columns[num++] = 1;
    }
    if (sheet & CSG_SHEET_DIFFERENCE)
        columns[num++] = 2;
    return num;
}

static void draw_sheet(struct csg_canvas *canvas, const struct csg_compared *compared,
                       unsigned sheet)
{
    unsigned columns[MAX_COLUMNS];
    const int num = columns_of(sheet, columns);
    const int width = compared->views[0].mesh.width, height = compared->views[0].mesh.height;
    for (int row = 0; row < compared->num_views; row++)
        for (int i = 0; i < num; i++) {
            const int x = MARGIN + i * (width + MARGIN), y = row * (height + LABEL);
            char text[96];
            print_label(compared, &compared->views[row], columns[i], text);
            csg_canvas_text(canvas, x, y + 8, ink, text);
            draw_cell(canvas, compared, &compared->views[row], columns[i], x, y + LABEL);
        }
    if (sheet & CSG_SHEET_DIFFERENCE)
        draw_legend(canvas, compared, MARGIN + (num - 1) * (width + MARGIN),
                    compared->num_views * (height + LABEL) + MARGIN, width);
}

bool csg_compare_write_sheet(const struct csg_compared *compared, unsigned sheet, const char *path)
{
    unsigned columns[MAX_COLUMNS];
    const int num = columns_of(sheet, columns);
    const int width = compared->views[0].mesh.width, height = compared->views[0].mesh.height;
    const int legend = sheet & CSG_SHEET_DIFFERENCE ? LEGEND : 0;
    struct csg_canvas canvas;
    if (!csg_canvas_init(&canvas, MARGIN + num * (width + MARGIN),
                         compared->num_views * (height + LABEL) + MARGIN + legend, white)) {
        csg_cli_error("out of memory for the picture %s", path);
        return false;
    }
    draw_sheet(&canvas, compared, sheet);
    const struct csgcast_image image = {.rgba = canvas.rgba};
    struct csgcast_write_params params = compared->options->write;
    params.write_z = params.write_normal = params.write_id = false;
    const bool written = csgcast_image_write(path, canvas.width, canvas.height, &image, &params);
    csg_canvas_finish(&canvas);
    return written;
}
