/* SPDX-License-Identifier: MIT */
#include "metamorphic.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const formula = "difference() { union() { A B } C }";

/* The middle of the second picture, which is twice as large, takes its place. */
static void crop(struct picture *picture, int size)
{
    for (int y = 0; y < size; y++)
        for (int x = 0; x < size; x++) {
            const int to = y * size + x;
            const int from = (y + size / 2) * 2 * size + x + size / 2;
            picture->z[to] = picture->z[from];
            picture->id[to] = picture->id[from];
            memmove(picture->normal + 3 * to, picture->normal + 3 * from,
                    3 * sizeof *picture->normal);
        }
}

/* A picture, and the same as the middle of one twice as wide and high. */
static bool check_crop(struct run *run, const struct csgcast_scene *scene, struct csgcast_view view,
                       const char *name)
{
    char full[120];
    const int size = run->size / 2;
    snprintf(full, sizeof full, "%s crop", name);
    view.width = view.height = 2 * size;
    bool drawn = picture_render(run->renderer, scene, &view, &run->second);
    crop(&run->second, size);
    view.width = view.height = size;
    view.camera.fov =
        2 * atan(0.5 * tan(0.5 * view.camera.fov / 57.29577951308232)) * 57.29577951308232;
    drawn = drawn && picture_render(run->renderer, scene, &view, &run->first);
    return drawn && judge(run, full, size, false);
}

/* Everything in tiles of other sizes: the same crossings, to the bit. */
static bool check_tiles(struct run *run, const struct csgcast_scene *scene,
                        const struct csgcast_view *view, const char *name)
{
    static const char *const sizes[] = {"1", "5", "8", "32", "1000"};
    bool ok = picture_render(run->renderer, scene, view, &run->first);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes && ok; i++) {
        char full[120];
        snprintf(full, sizeof full, "%s tiles of %s", name, sizes[i]);
        setenv("CSGCAST_TILE_SIZE", sizes[i], 1);
        struct csgcast_renderer *renderer =
            csgcast_renderer_create(&(struct csgcast_renderer_params){.backend = run->backend});
        unsetenv("CSGCAST_TILE_SIZE");
        ok = renderer && picture_render(renderer, scene, view, &run->second) &&
             judge(run, full, run->size, true);
        csgcast_renderer_destroy(renderer);
    }
    return ok;
}

/* p -> p + (s - 1) f (f.p): s times as long along the view axis f. */
static void put_stretch(struct text *text, const double f[3], double s)
{
    text_put(text, "multmatrix([");
    for (int i = 0; i < 3; i++)
        text_put(text, "[%.17g, %.17g, %.17g, 0], ", (i == 0) + (s - 1) * f[i] * f[0],
                 (i == 1) + (s - 1) * f[i] * f[1], (i == 2) + (s - 1) * f[i] * f[2]);
    text_put(text, "[0, 0, 0, 1]])\n");
}

/* Distances are s times as large; normals go by the inverse, transposed. */
static void undo_stretch(struct picture *picture, int num, const double f[3], double s)
{
    for (int i = 0; i < num; i++) {
        float *n = picture->normal + 3 * i;
        double m[3], along = 0, length = 0;
        picture->z[i] /= (float)s;
        for (int j = 0; j < 3; j++)
            along += f[j] * (double)n[j];
        for (int j = 0; j < 3; j++) {
            m[j] = (double)n[j] + (s - 1) * along * f[j];
            length += m[j] * m[j];
        }
        for (int j = 0; j < 3; j++)
            n[j] = length > 0 ? (float)(m[j] / sqrt(length)) : 0;
    }
}

/* Space stretched along the view axis, the eye with it: the same rays for a narrower view. */
static bool check_stretch(struct run *run, const struct csgcast_scene *scene,
                          struct csgcast_view view, const struct operands *operands, double s,
                          const char *name)
{
    char full[120];
    struct csgcast_frustum frustum;
    struct text text = {0};
    snprintf(full, sizeof full, "%s stretched by %g", name, s);
    if (!csgcast_view_resolve(scene, &view, &frustum))
        return false;
    put_stretch(&text, frustum.forward, s);
    put_formula(&text, formula, operands);
    struct csgcast_scene *stretched = parse(&text, full);
    bool ok = stretched && picture_render(run->renderer, scene, &view, &run->first);
    view.camera.distance *= s;
    view.camera.fov =
        2 * atan(tan(0.5 * view.camera.fov / 57.29577951308232) / s) * 57.29577951308232;
    ok = ok && picture_render(run->renderer, stretched, &view, &run->second);
    undo_stretch(&run->second, run->size * run->size, frustum.forward, s);
    ok = ok && judge(run, full, run->size, false);
    if (!ok)
        save(full, "stretched", &text);
    csgcast_scene_destroy(stretched);
    text_free(&text);
    return ok;
}

void check_windows(struct run *run, const struct operands *operands, struct dice *dice,
                   const char *name)
{
    struct text text = {0};
    put_formula(&text, formula, operands);
    struct csgcast_scene *scene = parse(&text, name);
    const struct csgcast_view view = random_view(dice, run->size);
    const double s = dice_pick(dice, 2) ? dice_between(dice, 0.1, 0.9) : dice_between(dice, 1.2, 9);
    const int failed = run->failed;
    bool ok = scene && check_crop(run, scene, view, name);
    if (ok && run->backend != CSGCAST_BACKEND_REFERENCE)
        ok = check_tiles(run, scene, &view, name);
    ok = ok && check_stretch(run, scene, view, operands, s, name);
    run->failed += !ok && run->failed == failed; /* not drawn */
    if (!ok)
        save(name, "window", &text);
    csgcast_scene_destroy(scene);
    text_free(&text);
}
