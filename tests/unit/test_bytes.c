/* SPDX-License-Identifier: MIT */

/*
 * Colours as bytes are the rounded floats, whichever way they are drawn, and files of 8 bits are
 * the same from both.
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "csgcast/csgcast.h"

struct example {
    const char *name, *text;
    int width, height;
    const char *variant;
};

static const struct example examples[] = {
    {"nothing", "sphere(r = 0);", 40, 30, NULL},
    {"one sphere", "sphere(r = 3, $fn = 0);", 203, 150, NULL},
    {"several strips", "difference() { cube([9, 9, 9]); sphere(r = 6); }", 2503, 2100, NULL},
    {"a difference", "difference() { cube([9, 9, 9]); sphere(r = 6); }", 300, 201, NULL},
    {"a difference in the loop", "difference() { cube([9, 9, 9]); sphere(r = 6); }", 300, 201,
     "loop"},
    {"in double", "difference() { cube([9, 9, 9]); sphere(r = 6); }", 100, 101, "double"},
    {"colours",
     "color([0.1, 0.9, 0.3, 1]) cube([1, 2, 3]); color([1, 0.5, 0.2, 1]) multmatrix([[1, 0, 0, 4], "
     "[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) cylinder(h = 3, r1 = 2, r2 = 0);",
     256, 256, NULL},
    {"an extrusion, in tiles",
     "difference() { cube([40, 40, 2]); linear_extrude(height = 9) "
     "polygon(points = [[1, 1], [9, 2], [8, 4], [12, 9], [5, 11], [3, 7]], paths = undef); "
     "sphere(r = 3); multmatrix([[1, 0, 0, 20], [0, 1, 0, 9], [0, 0, 1, 0], [0, 0, 0, 1]]) "
     "cylinder(h = 9, r1 = 3, r2 = 5); }",
     300, 300, NULL},
    {"overlapping, one face in common",
     "color([1, 0, 0, 1]) cube([4, 4, 4]); color([0, 1, 0, 1]) cube([2, 6, 4]); sphere(r = 2);",
     200, 200, NULL},
    {"translucent",
     "color([1, 0.2, 0.1, 0.4]) cube([4, 4, 4]); color([0, 0, 1, 1]) cube([2, 6, 2]);", 200, 200,
     NULL},
    {"modifiers", "cube([4, 4, 4]); #sphere(r = 3); %cube([6, 1, 9]);", 200, 200, NULL},
};

static int num_failures;

static void check(bool ok, const char *what, const char *name)
{
    printf("%s %s: %s\n", ok ? "ok" : "FAIL", name, what);
    num_failures += !ok;
}

static size_t num_wrong(const float *rgba, const uint8_t *bytes, size_t num)
{
    size_t wrong = 0;
    for (size_t i = 0; i < num; i++)
        wrong += bytes[i] != (uint8_t)floorf(fminf(fmaxf(rgba[i], 0), 1) * 255 + 0.5f);
    return wrong;
}

static bool has_two_colors(const uint8_t *bytes, size_t num)
{
    for (size_t i = 4; i < num; i += 4)
        if (memcmp(bytes, bytes + i, 4) != 0)
            return true;
    return false;
}

static void check_example(struct csgcast_renderer *renderer, const struct example *example)
{
    const size_t num = 4 * (size_t)example->width * (size_t)example->height;
    struct csgcast_view view = {
        .width = example->width, .height = example->height, .variant = example->variant};
    struct csgcast_scene *scene = csgcast_scene_parse(example->text, strlen(example->text), NULL);
    float *rgba = calloc(num, sizeof *rgba), *z = calloc(num / 4, sizeof *z);
    uint8_t *both = malloc(num), *alone = malloc(num), *deep = malloc(num);
    const struct csgcast_image floats = {.rgba = rgba, .rgba8 = both}, bytes = {.rgba8 = alone},
                               depths = {.rgba8 = deep, .z = z};
    const bool ok = scene && rgba && z && both && alone && deep &&
                    csgcast_render(renderer, scene, &view, &bytes) &&
                    csgcast_render(renderer, scene, &view, &floats) &&
                    csgcast_render(renderer, scene, &view, &depths);
    check(ok, "rendered", example->name);
    if (ok) {
        check(num_wrong(rgba, both, num) == 0, "bytes beside floats", example->name);
        check(num_wrong(rgba, alone, num) == 0, "bytes alone", example->name);
        check(memcmp(alone, deep, num) == 0, "bytes beside depths", example->name);
        check(has_two_colors(alone, num) != (example == examples), "a picture", example->name);
    }
    free(rgba);
    free(z);
    free(both);
    free(alone);
    free(deep);
    csgcast_scene_destroy(scene);
}

static void check_backend(enum csgcast_backend backend)
{
    const struct csgcast_renderer_params params = {.backend = backend};
    struct csgcast_renderer *renderer = csgcast_renderer_create(&params);
    check(renderer != NULL, "a renderer", "backend");
    for (size_t i = 0; renderer && i < sizeof examples / sizeof *examples; i++)
        if (backend != CSGCAST_BACKEND_REFERENCE || examples[i].width <= 300)
            check_example(renderer, &examples[i]);
    csgcast_renderer_destroy(renderer);
}

/* ---- strips ---- */

/* Above four million pixels each strip draws those tiles only that show in it: the picture is that
 * of the object as a whole. */
static void check_strips(void)
{
    static const char text[] =
        "difference() { cube([20, 20, 20]); sphere(r = 13); cylinder(h = 30, r1 = 6, r2 = 6); "
        "multmatrix([[0, 0, 1, 0], [0, 1, 0, 9], [-1, 0, 0, 12], [0, 0, 0, 1]]) "
        "cylinder(h = 30, r1 = 4, r2 = 6); }";
    const size_t num = 4 * 4000 * 1500;
    struct csgcast_view view = {.width = 4000, .height = 1500};
    uint8_t *tiles = malloc(num), *whole = malloc(num);
    const struct csgcast_image in_tiles = {.rgba8 = tiles}, as_whole = {.rgba8 = whole};
    struct csgcast_scene *scene = csgcast_scene_parse(text, sizeof text - 1, NULL);
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    struct csgcast_stats stats = {.tiles_mixed = 0};
    view.variant = "shared";
    bool ok = tiles && whole && csgcast_render(renderer, scene, &view, &in_tiles);
    csgcast_renderer_get_stats(renderer, &stats);
    view.variant = "straight";
    ok = ok && csgcast_render(renderer, scene, &view, &as_whole);
    check(ok && stats.tiles_mixed > 100, "drawn in tiles", "strips");
    check(ok && memcmp(tiles, whole, num) == 0 && has_two_colors(whole, num),
          "the picture of the whole object", "strips");
    csgcast_renderer_destroy(renderer);
    csgcast_scene_destroy(scene);
    free(tiles);
    free(whole);
}

/* ---- files ---- */

static size_t read_file(const char *path, char *content, size_t size)
{
    FILE *file = fopen(path, "rb");
    const size_t num = file ? fread(content, 1, size, file) : 0;
    if (file)
        fclose(file);
    return num;
}

enum { SIZE = 64, NUM = SIZE * SIZE * 4, MAX_FILE = 1 << 17 };

static void check_same_file(const struct csgcast_image *floats, const struct csgcast_image *eight,
                            struct csgcast_write_params params, const char *name)
{
    static char a[MAX_FILE], b[MAX_FILE];
    char path[] = "/tmp/csgcast-bytes-XXXXXX";
    const int file = mkstemp(path);
    const bool first = csgcast_image_write(path, SIZE, SIZE, floats, &params);
    const size_t num_a = read_file(path, a, sizeof a);
    const bool second = csgcast_image_write(path, SIZE, SIZE, eight, &params);
    const size_t num_b = read_file(path, b, sizeof b);
    check(file >= 0 && first && second && num_a && num_a == num_b && !memcmp(a, b, num_a),
          "the same file from floats and from bytes", name);
    close(file);
    remove(path);
}

/* All values of a byte, and floats that round to each from both sides. */
static void check_files(void)
{
    static float rgba[NUM];
    static uint8_t bytes[NUM];
    static const char *const formats[] = {"png", "tif", "bmp"};
    for (int i = 0; i < NUM; i++) {
        bytes[i] = (uint8_t)(i % 4 == 3 ? 255 : i / 4 % 256);
        const float shift = 0.49f * (float)(i / 1024 % 3 - 1);
        rgba[i] = i % 4 == 3 ? 1 : fminf(fmaxf(((float)bytes[i] + shift) / 255, 0), 1);
    }
    const struct csgcast_image floats = {.rgba = rgba}, eight = {.rgba8 = bytes};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        check_same_file(&floats, &eight, (struct csgcast_write_params){.format = formats[i]},
                        formats[i]);
}

/* With alpha, and with more bits than a byte has. */
static void check_deep_files(void)
{
    static float rgba[NUM];
    static uint8_t bytes[NUM];
    for (int i = 0; i < NUM; i++) {
        bytes[i] = (uint8_t)(i * 7 + i / 256);
        rgba[i] = (float)bytes[i] / 255;
    }
    const struct csgcast_image floats = {.rgba = rgba}, eight = {.rgba8 = bytes};
    check_same_file(&floats, &eight, (struct csgcast_write_params){.format = "png"}, "png, alpha");
    check_same_file(&floats, &eight, (struct csgcast_write_params){.format = "png", .bits = 16},
                    "png, 16 bits");
    check_same_file(&floats, &eight, (struct csgcast_write_params){.format = "exr"}, "exr");
}

int main(void)
{
    check_backend(CSGCAST_BACKEND_AUTO);
    check_backend(CSGCAST_BACKEND_REFERENCE);
    check_strips();
    check_files();
    check_deep_files();
    return num_failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
