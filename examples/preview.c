/* SPDX-License-Identifier: MIT */

/*
 * preview [FILE [IMAGE]]: what the preview of a CAD program does. The camera goes around the scene,
 * a solid is moved from frame to frame, the solid under a pixel is picked, coloured and named, and
 * the point that was hit is found. The last frame becomes IMAGE.
 */

#include <csgcast/csgcast.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { size = 128, num_frames = 12 }; /* pixels a side; frames of a turn */

static const char text[] = "difference() {\n"
                           "    cube([20, 20, 6], center = true);\n"
                           "    cylinder(h = 20, r = 4, center = true);\n"
                           "}\n";

static uint8_t rgba8[size * size * 4];
static float z[size * size], id[size * size];

/* Rows of the matrix, as in multmatrix: the last column moves. */
static bool move(struct csgcast_scene *scene, size_t leaf, const struct csgcast_leaf *first,
                 double x)
{
    double matrix[16];
    memcpy(matrix, first->matrix, sizeof matrix);
    matrix[3] += x;
    return csgcast_scene_set_matrix(scene, leaf, matrix);
}

/* Each frame: an edit, then a picture in bytes, ready for the screen. No program is compiled but
 * for the first one. */
static bool orbit(struct csgcast_renderer *renderer, struct csgcast_scene *scene,
                  struct csgcast_view *view)
{
    const struct csgcast_image image = {.rgba8 = rgba8};
    const size_t last = csgcast_scene_num_leaves(scene) - 1;
    struct csgcast_leaf first;
    bool ok = csgcast_scene_get_leaf(scene, last, &first);
    for (int i = 0; i < num_frames && ok; i++) {
        view->camera.rotate[2] = 360.0 * i / num_frames;
        ok = move(scene, last, &first, 0.25 * i) && csgcast_render(renderer, scene, view, &image);
    }
    return ok;
}

/* The point that the pixel shows: z is measured along the view axis. */
static bool find_point(const struct csgcast_scene *scene, const struct csgcast_view *view, int x,
                       int y, double point[3])
{
    struct csgcast_frustum frustum;
    if (!csgcast_view_resolve(scene, view, &frustum))
        return false;
    const double depth = (double)z[y * size + x], scale = frustum.orthographic ? 1 : depth;
    const double right = (2 * (x + 0.5) / size - 1) * frustum.half_width * scale;
    const double up = (1 - 2 * (y + 0.5) / size) * frustum.half_height * scale;
    for (int i = 0; i < 3; i++)
        point[i] = frustum.eye[i] + depth * frustum.forward[i] + right * frustum.right[i] +
                   up * frustum.up[i];
    return true;
}

/* The channels id and z are asked for only when somebody clicks. */
static bool pick(struct csgcast_renderer *renderer, struct csgcast_scene *scene,
                 const struct csgcast_view *view, int x, int y)
{
    static const float red[4] = {1, 0, 0, 1};
    const struct csgcast_image image = {.z = z, .id = id};
    double point[3];
    struct csgcast_leaf leaf;
    if (!csgcast_render(renderer, scene, view, &image))
        return false;
    if (id[y * size + x] < 0) {
        printf("nothing is there\n");
        return true;
    }
    const size_t picked = (size_t)id[y * size + x];
    if (!find_point(scene, view, x, y, point) || !csgcast_scene_get_leaf(scene, picked, &leaf))
        return false;
    printf("%s(%s), line %u, at %.3f %.3f %.3f\n", leaf.kind, leaf.parameters, leaf.line, point[0],
           point[1], point[2]);
    return csgcast_scene_set_color(scene, picked, red);
}

static bool show(struct csgcast_scene *scene, const char *path)
{
    const struct csgcast_image image = {.rgba8 = rgba8};
    struct csgcast_view view = {.width = size, .height = size};
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    double lo[3], hi[3];
    bool ok = renderer && csgcast_scene_get_bounds(scene, lo, hi);
    view.camera.kind = CSGCAST_CAMERA_GIMBAL;
    view.camera.rotate[0] = 50;
    for (int i = 0; i < 3 && ok; i++)
        view.camera.translate[i] = (lo[i] + hi[i]) / 2;
    view.camera.distance =
        ok ? 3 * sqrt(pow(hi[0] - lo[0], 2) + pow(hi[1] - lo[1], 2) + pow(hi[2] - lo[2], 2)) : 0;
    ok = ok && orbit(renderer, scene, &view) &&
         pick(renderer, scene, &view, size / 2, size / 2 + 12) &&
         csgcast_render(renderer, scene, &view, &image) &&
         (!path || csgcast_image_write(path, size, size, &image, NULL));
    csgcast_renderer_destroy(renderer);
    return ok;
}

int main(int argc, char **argv)
{
    struct csgcast_scene *scene = argc > 1 ? csgcast_scene_load(argv[1], NULL)
                                           : csgcast_scene_parse(text, strlen(text), NULL);
    const bool ok =
        scene && csgcast_scene_num_leaves(scene) > 0 && show(scene, argc > 2 ? argv[2] : NULL);
    csgcast_scene_destroy(scene);
    return !ok;
}
