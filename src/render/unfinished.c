/* SPDX-License-Identifier: MIT */

/* What is too much for a fragment program is cast by the reference: slower, never wrong. */

#include "reference/reference.h"
#include "render/renderer.h"

bool csg_unfinished_fill(struct csgcast_renderer *renderer, const struct csg_request *request,
                         const uint32_t *visible, int first_row, int num_rows)
{
    const struct csg_reference_params params = {&request->frustum, request->width, request->height,
                                                request->scheme, request->view->cut_color};
    struct csg_ray_scratch *scratch = csg_ray_scratch_create();
    bool ok = scratch != NULL;
    for (int row = 0; row < num_rows && ok; row++) {
        const uint32_t *pixels = visible + 2 * (size_t)row * (size_t)request->width;
        for (int x = 0; x < request->width && ok; x++) {
            if (pixels[2 * x + 1] != CSG_UNFINISHED)
                continue;
            renderer->stats.unfinished_pixels++;
            ok = csg_reference_pixel(request->scene, &params, request->image, x,
                                     request->height - 1 - first_row - row, scratch);
        }
    }
    csg_ray_scratch_destroy(scratch);
    return ok || csg_log_memory(&renderer->log);
}
