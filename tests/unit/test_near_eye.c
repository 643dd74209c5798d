/* SPDX-License-Identifier: MIT */
/*
 * An eye within a turned profile, or a surface of triangles, hardly below its flat end: rays leave it
 * right before the eye, at the reference's depths.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "csgcast/csgcast.h"

enum { SIZE = 32 };

#define MAX_DEPTH_ERROR 1e-5 /* relative */

/* Enough rings for a stack. */
static const char rings[] =
    "rotate_extrude($fn = 128) polygon([[0, 0], [19.5, 0], [19.5, 3], [19.5, 8.38], [22, 10.76],"
    " [22, 11], [19, 11], [16.5, 8.62], [16.5, 5], [16.5, 3], [8, 3], [4, 2.5], [0, 2]]);";

static const char surface[] =
    "linear_extrude(height = 11, twist = 20, slices = 20) square(60, center = true);";

static struct csgcast_renderer *create(enum csgcast_backend backend)
{
    return csgcast_renderer_create(&(struct csgcast_renderer_params){.backend = backend});
}

static void check_height(const struct csgcast_scene *scene, struct csgcast_renderer *renderers[2],
                         double below)
{
    static float depths[2][SIZE * SIZE];
    const struct csgcast_view view = {.width = SIZE,
                                      .height = SIZE,
                                      .camera = {.kind = CSGCAST_CAMERA_VECTOR,
                                                 .eye = {-11, 17, 11 - below},
                                                 .center = {-11.2, 17.9, 11.4},
                                                 .fov = 60}};
    for (int i = 0; i < 2; i++)
        CHECK(csgcast_render(renderers[i], scene, &view, &(struct csgcast_image){.z = depths[i]}),
              "no picture");
    size_t wrong = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        wrong += !(fabsf(depths[1][i] - depths[0][i]) <= MAX_DEPTH_ERROR * depths[0][i]) &&
                 depths[0][i] != depths[1][i];
    CHECK(wrong == 0, "%g below the end: %zu pixels differ", below, wrong);
}

int main(void)
{
    struct csgcast_scene *scenes[] = {csgcast_scene_parse(rings, strlen(rings), NULL),
                                      csgcast_scene_parse(surface, strlen(surface), NULL)};
    struct csgcast_renderer *renderers[] = {create(CSGCAST_BACKEND_REFERENCE),
                                            create(CSGCAST_BACKEND_AUTO)};
    CHECK(scenes[0] && scenes[1] && renderers[0] && renderers[1], "nothing to draw with");
    for (double below = 1e-8; below < 0.1 && num_failed == 0; below *= 10)
        for (int i = 0; i < 2; i++)
            check_height(scenes[i], renderers, below);
    for (int i = 0; i < 2; i++) {
        csgcast_renderer_destroy(renderers[i]);
        csgcast_scene_destroy(scenes[i]);
    }
    return num_failed != 0;
}
