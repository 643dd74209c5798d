/* SPDX-License-Identifier: MIT */

/*
 * picture IMAGE: renders a cube with a hole from memory, looks at two pixels and writes the image.
 */

#include <csgcast/csgcast.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SIZE 16 /* pixels */

static const char text[] = "difference() {\n"
                           "    cube(10, center = true);\n"
                           "    cylinder(h = 20, r = 3, center = true);\n"
                           "}\n";

/* Looks down the z axis: through the hole in the middle, at the top face, 95 away, beside it. */
static int check_pixels(const float *z, const float *id)
{
    const int middle = SIZE / 2 * SIZE + SIZE / 2, beside = SIZE / 2 * SIZE + 2;
    if (!isinf(z[middle]) || id[middle] != -1) {
        printf("the hole is not open: z %g, id %g\n", (double)z[middle], (double)id[middle]);
        return 1;
    }
    if (fabsf(z[beside] - 95) > 1e-4f || id[beside] != 0) {
        printf("no top face: z %g, id %g\n", (double)z[beside], (double)id[beside]);
        return 1;
    }
    return 0;
}

int main(int argc, char **argv)
{
    static float rgba[SIZE * SIZE * 4], z[SIZE * SIZE], id[SIZE * SIZE];
    const struct csgcast_image image = {.rgba = rgba, .z = z, .id = id};
    struct csgcast_view view = {.width = SIZE, .height = SIZE};
    view.camera.kind = CSGCAST_CAMERA_VECTOR;
    view.camera.eye[2] = 100;
    view.camera.fov = 6; /* sees 4.98 to either side of the axis at the top face */
    int result = 1;
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    if (scene && renderer && csgcast_render(renderer, scene, &view, &image))
        result = check_pixels(z, id);
    if (!result && argc > 1 && !csgcast_image_write(argv[1], SIZE, SIZE, &image, NULL))
        result = 1;
    csgcast_renderer_destroy(renderer);
    csgcast_scene_destroy(scene);
    return result;
}
