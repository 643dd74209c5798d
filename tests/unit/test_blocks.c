/* SPDX-License-Identifier: MIT */
/*
 * Surfaces of triangles in pictures whose sides are no multiples of the blocks of pixels that
 * drivers run programs for: the pixels beside the picture must not spoil those in it.
 */
#include <math.h>
#include <string.h>

#include "check.h"
#include "csgcast/csgcast.h"

enum { FIRST = 33, LAST = 44 };

#define MAX_DEPTH_ERROR 1e-4 /* relative */

/* The eye is right below the cube's top. */
static const char text[] =
    "cube([165, 100, 9]);"
    "multmatrix([[-0.07, -0.42, 0.9, 101], [-0.99, 0.11, -0.02, -23], [-0.1, -0.9, -0.43, 12]])"
    " linear_extrude(height = 79.6, twist = 68, slices = 20) square([91.5, 90.5], center = true);"
    "multmatrix([[0.55, 0.38, -0.74, 147], [0.22, 0.78, 0.57, 95], [0.8, -0.48, 0.35, 7]])"
    " linear_extrude(height = 32.6, twist = 25, slices = 20) square([22, 22], center = true);";

static struct csgcast_renderer *create(enum csgcast_backend backend)
{
    return csgcast_renderer_create(&(struct csgcast_renderer_params){.backend = backend});
}

static size_t num_wrong(const struct csgcast_scene *scene, struct csgcast_renderer *renderers[2],
                        int width, int height, double below)
{
    static float depths[2][LAST * LAST];
    const struct csgcast_view view = {.width = width,
                                      .height = height,
                                      .camera = {.kind = CSGCAST_CAMERA_VECTOR,
                                                 .eye = {159.7, 90.35, 9 - below},
                                                 .center = {159.85, 89.9, 8.7},
                                                 .fov = 82}};
    size_t wrong = 0;
    for (int i = 0; i < 2; i++)
        CHECK(csgcast_render(renderers[i], scene, &view, &(struct csgcast_image){.z = depths[i]}),
              "no picture");
    for (int i = 0; i < width * height; i++)
        wrong += !(fabsf(depths[1][i] - depths[0][i]) <= MAX_DEPTH_ERROR * depths[0][i]) &&
                 depths[0][i] != depths[1][i];
    return wrong;
}

int main(void)
{
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    struct csgcast_renderer *renderers[] = {create(CSGCAST_BACKEND_REFERENCE),
                                            create(CSGCAST_BACKEND_AUTO)};
    CHECK(scene && renderers[0] && renderers[1], "nothing to draw with");
    for (double below = 1e-6; below < 0.1; below *= 10)
        for (int i = FIRST; i <= LAST; i++) {
            const int width = i, height = FIRST + LAST - i;
            const size_t wrong = num_wrong(scene, renderers, width, height, below);
            CHECK(wrong == 0, "%d x %d, %g below: %zu pixels differ", width, height, below, wrong);
        }
    for (int i = 0; i < 2; i++)
        csgcast_renderer_destroy(renderers[i]);
    csgcast_scene_destroy(scene);
    return num_failed != 0;
}
