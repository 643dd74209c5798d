/* SPDX-License-Identifier: MIT */
/*
 * An eye within a turned profile, or a surface of triangles, on its flat end or hardly below or
 * above: rays that go up leave it right there, those that go down on the other side.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "csgcast/csgcast.h"

enum { SIZE = 32 };

#define MAX_DEPTH_ERROR 1e-5 /* relative */

/* Heights about which rounding decides, ray by ray, whether an end is the eye's own (csg_eye_near).
 */
#define OWN_FROM 1e-12
#define OWN_TO 1e-9

/* Enough rings for a stack. */
static const char rings[] =
    "rotate_extrude($fn = 128) polygon([[0, 0], [19.5, 0], [19.5, 3], [19.5, 8.38], [22, 10.76],"
    " [22, 11], [19, 11], [16.5, 8.62], [16.5, 5], [16.5, 3], [8, 3], [4, 2.5], [0, 2]]);";

static const char surface[] =
    "linear_extrude(height = 11, twist = 20, slices = 20) square(60, center = true);";

/* Nothing is around the eye here: above the end there was nothing to cut away. */
static const char cut[] =
    "difference() {"
    " linear_extrude(height = 11, twist = 20, slices = 20) square(60, center = true);"
    " multmatrix([[1, 0, 0, -11], [0, 1, 0, 17], [0, 0, 1, 11]]) cube(10, center = true); }";

static struct csgcast_scene *parse(const char *text)
{
    return csgcast_scene_parse(text, strlen(text), NULL);
}

static struct csgcast_renderer *create(enum csgcast_backend backend)
{
    return csgcast_renderer_create(&(struct csgcast_renderer_params){.backend = backend});
}

static void check_height(const struct csgcast_scene *scene, struct csgcast_renderer *renderers[2],
                         double below, double up)
{
    static float depths[2][SIZE * SIZE];
    const struct csgcast_view view = {.width = SIZE,
                                      .height = SIZE,
                                      .camera = {.kind = CSGCAST_CAMERA_VECTOR,
                                                 .eye = {-11, 17, 11 - below},
                                                 .center = {-11.2, 17.9, 11 - below + up},
                                                 .fov = 60}};
    for (int i = 0; i < 2; i++)
        CHECK(csgcast_render(renderers[i], scene, &view, &(struct csgcast_image){.z = depths[i]}),
              "no picture");
    size_t wrong = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        wrong += !(fabsf(depths[1][i] - depths[0][i]) <= MAX_DEPTH_ERROR * depths[0][i]) &&
                 depths[0][i] != depths[1][i];
    CHECK(wrong == 0, "%g below the end, %g up: %zu pixels differ", below, up, wrong);
}

static void check_both_ways(const struct csgcast_scene *scene,
                            struct csgcast_renderer *renderers[2], double below)
{
    check_height(scene, renderers, below, 0.4);
    check_height(scene, renderers, below, -0.4);
}

static void check_heights(const struct csgcast_scene *scene, struct csgcast_renderer *renderers[2])
{
    check_both_ways(scene, renderers, 0);
    for (double height = 1e-15; height < 0.1 && num_failed == 0; height *= 10) {
        if (height > OWN_FROM && height < OWN_TO)
            continue;
        check_both_ways(scene, renderers, height);
        if (height < OWN_TO)
            check_both_ways(scene, renderers, -height);
    }
}

int main(void)
{
    struct csgcast_scene *scenes[] = {parse(rings), parse(surface), parse(cut)};
    struct csgcast_renderer *renderers[] = {create(CSGCAST_BACKEND_REFERENCE),
                                            create(CSGCAST_BACKEND_AUTO)};
    CHECK(scenes[0] && scenes[1] && scenes[2] && renderers[0] && renderers[1],
          "nothing to draw with");
    for (int i = 0; i < 3; i++)
        check_heights(scenes[i], renderers);
    for (int i = 0; i < 3; i++)
        csgcast_scene_destroy(scenes[i]);
    for (int i = 0; i < 2; i++)
        csgcast_renderer_destroy(renderers[i]);
    return num_failed != 0;
}
