/* SPDX-License-Identifier: MIT */

/* What is too much for a fragment program is cast by the reference: slower, never wrong. */

#include "reference/reference.h"
#include "render/renderer.h"

/* A strip as the driver keeps it, its lowest row first. */
struct strip {
    const uint32_t *visible; /* two words a pixel */
    const uint8_t *colors;   /* without visible: the picture */
    int width, top;          /* the row of the picture that is its highest */
    int num_rows;
};

static bool is_unfinished(const void *user, int x, int y)
{
    const struct strip *strip = user;
    if (!strip->visible)
        return strip->colors[4 * ((size_t)y * (size_t)strip->width + (size_t)x) + 3] == 0;
    const size_t row = (size_t)(strip->num_rows - 1 - (y - strip->top));
    return strip->visible[2 * (row * (size_t)strip->width + (size_t)x) + 1] == CSG_UNFINISHED;
}

bool csg_unfinished_fill(struct csgcast_renderer *renderer, const struct csg_request *request,
                         const uint32_t *visible, int first_row, int num_rows)
{
    const struct csg_reference_params params = {&request->frustum,        request->width,
                                                request->height,          request->scheme,
                                                request->view->cut_color, renderer->num_threads};
    const struct strip strip = {visible, request->image->rgba8, request->width,
                                request->height - first_row - num_rows, num_rows};
    const struct csg_reference_part part = {strip.top, num_rows, is_unfinished, &strip, true};
    size_t num = 0;
    for (int y = strip.top; y < strip.top + num_rows; y++)
        for (int x = 0; x < request->width; x++)
            num += is_unfinished(&strip, x, y);
    renderer->stats.unfinished_pixels += num;
    return num == 0 || csg_reference_render(request->scene, &params, &part, request->image) ||
           csg_log_memory(&renderer->log);
}
