/* SPDX-License-Identifier: MIT */

/* How tiles are drawn: by which programs, and the same as the reference has it. */

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "csgcast/csgcast.h"

struct example {
    const char *name, *solid; /* what is cut out of a plate, 16 x 16 times, in cells of 4 units */
    int size;
    int max_loops; /* tiles that are left to the loop, of a thousand and more */
};

static const struct example examples[] = {
    {"square holes",
     "multmatrix([[1, 0, 0, 0.8], [0, 1, 0, 0.8], [0, 0, 1, 0], [0, 0, 0, 1]]) "
     "cube([2.4, 2.4, 6]);",
     512, 10},
    {"holes of eight sides",
     "multmatrix([[1, 0, 0, 2], [0, 1, 0, 2], [0, 0, 1, 0], [0, 0, 0, 1]]) "
     "cylinder($fn = 8, h = 6, r1 = 1.4, r2 = 1.4);",
     512, 20},
    {"round holes",
     "multmatrix([[1, 0, 0, 2], [0, 1, 0, 2], [0, 0, 1, 0], [0, 0, 0, 1]]) "
     "cylinder(h = 6, r1 = 1.4, r2 = 1.4);",
     512, 20},
    {"unions of complements",
     "multmatrix([[1, 0, 0, 2], [0, 1, 0, 2], [0, 0, 1, 5], "
     "[0, 0, 0, 1]]) intersection() { sphere(r = 1.6); "
     "cube([3, 3, 3], center = true); }",
     512, 60},
    {"intersections with a union",
     "multmatrix([[1, 0, 0, 2], [0, 1, 0, 2], [0, 0, 1, 5], "
     "[0, 0, 0, 1]]) difference() { sphere(r = 1.6); "
     "cylinder(h = 3, r1 = 0.5, r2 = 0.5, center = true); }",
     512, 60},
};

static char *plate(const char *solid)
{
    const size_t room = 256 * (strlen(solid) + 100) + 100;
    char *text = malloc(room);
    size_t num = 0;
    if (!text)
        return NULL;
    num += (size_t)snprintf(text, room,
                            "difference() { multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1], "
                            "[0, 0, 0, 1]]) cube([64, 64, 4]);\n");
    for (int i = 0; i < 256; i++)
        num += (size_t)snprintf(
            text + num, room - num,
            "multmatrix([[1, 0, 0, %d], [0, 1, 0, %d], [0, 0, 1, 0], [0, 0, 0, 1]]) %s\n",
            4 * (i % 16), 4 * (i / 16), solid);
    snprintf(text + num, room - num, "}\n");
    return text;
}

static int count_of(const struct csgcast_stats *stats, const char *variant)
{
    const char *at = strstr(stats->variants, variant);
    return at ? atoi(at + strlen(variant)) : 0;
}

struct picture {
    float *z;
    float *id;
};

static bool draw_with(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                      int size, struct picture *picture, struct csgcast_stats *stats)
{
    const struct csgcast_view view = {.width = size, .height = size};
    const size_t num = (size_t)size * (size_t)size;
    picture->z = malloc(num * sizeof *picture->z);
    picture->id = malloc(num * sizeof *picture->id);
    const struct csgcast_image image = {.z = picture->z, .id = picture->id};
    const bool ok = picture->z && picture->id && csgcast_render(renderer, scene, &view, &image);
    csgcast_renderer_get_stats(renderer, stats);
    return ok;
}

static bool draw(enum csgcast_backend backend, const struct csgcast_scene *scene, int size,
                 struct picture *picture, struct csgcast_stats *stats)
{
    const struct csgcast_renderer_params params = {.backend = backend};
    struct csgcast_renderer *renderer = csgcast_renderer_create(&params);
    const bool ok = draw_with(renderer, scene, size, picture, stats);
    csgcast_renderer_destroy(renderer);
    return ok;
}

static void drop(struct picture *picture)
{
    free(picture->z);
    free(picture->id);
}

/* Pixels at whose edges float and double differ. */
#define MAX_WRONG_SHARE 2e-5

static void compare(const struct example *example, const struct picture *a, const struct picture *b)
{
    const size_t num = (size_t)example->size * (size_t)example->size;
    size_t wrong = 0, hits = 0;
    for (size_t i = 0; i < num; i++) {
        hits += a->id[i] >= 0;
        wrong += a->id[i] != b->id[i] ||
                 (a->id[i] >= 0 && !(fabsf(a->z[i] - b->z[i]) <= 1e-4F * fabsf(b->z[i])));
    }
    CHECK(hits > num / 8, "%s: %zu pixels", example->name, hits);
    CHECK((double)wrong <= MAX_WRONG_SHARE * (double)num, "%s: %zu pixels", example->name, wrong);
}

/* In tiles, of which not many may be for the loop, beside the reference. */
static void check_text(const struct example *example, const char *text)
{
    struct csgcast_scene *scene = text ? csgcast_scene_parse(text, strlen(text), NULL) : NULL;
    struct picture tiles = {NULL, NULL}, reference = {NULL, NULL};
    struct csgcast_stats stats, none;
    const bool ok = scene && draw(CSGCAST_BACKEND_AUTO, scene, example->size, &tiles, &stats) &&
                    draw(CSGCAST_BACKEND_REFERENCE, scene, example->size, &reference, &none);
    CHECK(ok, "%s", example->name);
    if (ok) {
        CHECK(stats.tiles_mixed + stats.tiles_opaque > 1000, "%s: %s", example->name,
              stats.variants);
        CHECK(count_of(&stats, "loop ") <= example->max_loops, "%s: %s", example->name,
              stats.variants);
        compare(example, &tiles, &reference);
    }
    csgcast_scene_destroy(scene);
    drop(&tiles);
    drop(&reference);
}

static void check_example(const struct example *example)
{
    char *text = plate(example->solid);
    check_text(example, text);
    free(text);
}

/* What a renderer keeps of a frame, of the same scene in another size, is not seen in the next. */
static void check_kept(const struct example *example)
{
    enum { FIRST, LARGER, LAST, NUM };
    const int size = example->size, sizes[NUM] = {size, 2 * size, size};
    const struct csgcast_renderer_params params = {0};
    char *text = plate(example->solid);
    struct csgcast_scene *scene = text ? csgcast_scene_parse(text, strlen(text), NULL) : NULL;
    struct csgcast_renderer *renderer = csgcast_renderer_create(&params);
    struct picture pictures[NUM] = {{NULL, NULL}};
    struct csgcast_stats stats[NUM];
    const size_t bytes = (size_t)size * (size_t)size * sizeof(float);
    bool ok = scene && renderer;
    for (int i = 0; i < NUM && ok; i++)
        ok = draw_with(renderer, scene, sizes[i], &pictures[i], &stats[i]);
    CHECK(ok, "%s", example->name);
    if (ok) {
        CHECK(stats[LARGER].texture_bytes > stats[FIRST].texture_bytes, "%s", example->name);
        CHECK(stats[LAST].texture_bytes == stats[FIRST].texture_bytes &&
                  stats[LAST].tiles_mixed == stats[FIRST].tiles_mixed &&
                  stats[LAST].solid_tests == stats[FIRST].solid_tests,
              "%s: %zu bytes, then %zu", example->name, stats[FIRST].texture_bytes,
              stats[LAST].texture_bytes);
        CHECK(memcmp(pictures[LAST].z, pictures[FIRST].z, bytes) == 0, "%s", example->name);
        CHECK(memcmp(pictures[LAST].id, pictures[FIRST].id, bytes) == 0, "%s", example->name);
    }
    for (int i = 0; i < NUM; i++)
        drop(&pictures[i]);
    csgcast_renderer_destroy(renderer);
    csgcast_scene_destroy(scene);
    free(text);
}

/* Colours as programs write them or, with z, as the shading pass does. */
static bool draw_colors(struct csgcast_renderer *renderer, const char *text, int size,
                        uint8_t *colors, float *z)
{
    const struct csgcast_scene_params fixed = {.fixed = true};
    const struct csgcast_view view = {.width = size, .height = size};
    const struct csgcast_image image = {.rgba8 = colors, .z = z};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &fixed);
    const bool ok = renderer && scene && csgcast_render(renderer, scene, &view, &image);
    csgcast_scene_destroy(scene);
    return ok;
}

/* The last of some pictures: only one that compiles nothing is drawn by what suits it best. */
static bool draw_settled(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                         const struct csgcast_view *view, uint8_t *colors,
                         struct csgcast_stats *stats)
{
    const struct csgcast_image image = {.rgba8 = colors};
    size_t before;
    bool ok;
    *stats = (struct csgcast_stats){0};
    do {
        before = stats->programs;
        ok = csgcast_render(renderer, scene, view, &image);
        csgcast_renderer_get_stats(renderer, stats);
    } while (ok && stats->programs > before);
    return ok;
}

/* A picture by a variant is that of the loop. resolvers: what the statistics begin with, up to the
 * first count; more: others follow. */
static void check_variant(const char *text, int size, const char *variant, const char *resolvers,
                          bool more)
{
    const size_t bytes = 4 * (size_t)size * (size_t)size;
    const struct csgcast_scene_params fixed = {.fixed = true};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &fixed);
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    struct csgcast_view view = {.width = size, .height = size, .variant = variant};
    struct csgcast_stats stats;
    uint8_t *got = malloc(bytes), *loop = malloc(bytes);
    bool ok = scene && renderer && got && loop && draw_settled(renderer, scene, &view, got, &stats);
    CHECK(ok, "no picture");
    if (ok) {
        const size_t length = strlen(resolvers);
        CHECK(strncmp(stats.variants, resolvers, length) == 0 &&
                  !strchr(stats.variants + length, ',') == !more,
              "%s instead of %s", stats.variants, resolvers);
        view.variant = "loop";
        ok = csgcast_render(renderer, scene, &view, &(struct csgcast_image){.rgba8 = loop});
        CHECK(ok && memcmp(got, loop, bytes) == 0, "pictures differ");
    }
    free(loop);
    free(got);
    csgcast_renderer_destroy(renderer);
    csgcast_scene_destroy(scene);
}

/* A picture alone, of few programs. */
static void check_alone(const char *text, const char *resolvers)
{
    check_variant(text, 256, "shared", resolvers, false);
}

static const char five[] =
    "difference() { cube(size = [20, 20, 20], center = true); sphere(r = 13);"
    "cylinder(h = 30, r1 = 6, r2 = 6, center = true);"
    "multmatrix([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])"
    "cylinder(h = 30, r1 = 6, r2 = 6, center = true);"
    "multmatrix([[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]])"
    "cylinder(h = 30, r1 = 6, r2 = 6, center = true); }";

/* Holes of which a tile sees several, or that are several solids: programs for four and five in a
 * row, which have the colours at hand. */
static void check_rows(void)
{
    static const char *const holes[] = {
        "multmatrix([[1, 0, 0, 2], [0, 1, 0, 2], [0, 0, 1, 2], [0, 0, 0, 1]])"
        "cylinder(h = 6, r1 = 1.9, r2 = 1.9);",
        "multmatrix([[1, 0, 0, 2], [0, 1, 0, 2], [0, 0, 1, 2], [0, 0, 0, 1]]) group() {"
        "multmatrix([[1, 0, 0, -0.8], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])"
        "color([1, 0, 0]) cylinder(h = 6, r1 = 0.9, r2 = 0.9);"
        "multmatrix([[1, 0, 0, 0.8], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])"
        "color([0, 1, 0]) cylinder(h = 6, r1 = 0.9, r2 = 0.9);"
        "multmatrix([[1, 0, 0, -0.8], [0, 1, 0, -0.9], [0, 0, 1, 0], [0, 0, 0, 1]])"
        "cube([1.6, 1.8, 6]); }"};
    for (size_t i = 0; i < sizeof holes / sizeof *holes; i++) {
        char *text = plate(holes[i]);
        CHECK(text, "out of memory");
        if (text)
            check_variant(text, 512, "auto", "chain ", i == 0);
        free(text);
    }
}

/* A part of few solids is worth tiles where it covers many pixels. */
static void check_few_solids(void)
{
    check_variant(five, 128, "auto", "straight 1", false);
    check_variant(five, 512, "auto", "chain ", false);
}

/* Rays along a cylinder make its quadric stiff: tiles without it are chains all the same. The
 * cylinder points at the default camera. */
static void check_stiff(void)
{
    check_variant("difference() { cube(size = [40, 40, 20], center = true);"
                  "multmatrix([[0.906308, -0.242404, 0.346189, -8],"
                  " [0.422618, 0.519836, -0.742404, 0], [0, 0.819152, 0.573576, 0], [0, 0, 0, 1]])"
                  "cylinder(h = 60, r1 = 3, r2 = 3, center = true);"
                  "multmatrix([[1, 0, 0, 10], [0, 1, 0, 5], [0, 0, 1, 0], [0, 0, 0, 1]])"
                  "cylinder(h = 30, r1 = 3, r2 = 3, center = true); }",
                  512, "auto", "chain ", true);
}

/* Three intersections that cross each other, taken from a cube: seven literals in four clauses. */
static void check_clauses(void)
{
    static const char *const bites =
        "multmatrix([[1, 0, 0, %d], [0, 0, -1, %d], [0, 1, 0, 10], [0, 0, 0, 1]])"
        "intersection() { sphere(r = %g); cylinder(h = 20, r1 = 3, r2 = 3, center = true); }";
    char text[1024] = "difference() { cube(size = [20, 20, 20], center = true);";
    for (int i = 0; i < 3; i++)
        sprintf(text + strlen(text), bites, 2 * i - 2, i % 2, 4 + 0.3 * i);
    strcat(text, "}");
    check_variant(text, 512, "auto", "chain ", false);
}

/* Intersections spread over half a ball, taken from a cube: a tile in which the two solids of one
 * are apart along all rays has neither. Twice as many tiles would be for the loop. */
static void check_apart(void)
{
    enum { NUM = 24 };
    const struct example example = {"apart", "", 512, 220};
    char text[256 * NUM] = "difference() { cube(size = [40, 40, 40], center = true);";
    for (int i = 0; i < NUM; i++) {
        const double z = 1 - (double)i / NUM, r = 20 * sqrt(1 - z * z), turn = 2.39996 * i;
        sprintf(text + strlen(text),
                "multmatrix([[1, 0, 0, %g], [0, 0, -1, %g], [0, 1, 0, %g], [0, 0, 0, 1]])"
                "intersection() { sphere(r = 8);"
                "cylinder(h = 20, r1 = 5, r2 = 5, center = true); }",
                r * cos(turn), r * sin(turn), 20 * z);
    }
    strcat(text, "}");
    check_text(&example, text);
}

/* Boxes taken from a cube, each of them inside of the one before: of those only that one matters,
 * wherever two are on the screen. */
static void check_inside(void)
{
    enum { NUM = 40, SIZE = 256 };
    char text[128 * NUM] = "difference() { cube(size = [100, 100, 100], center = true);";
    for (int i = 0; i < NUM; i++)
        sprintf(text + strlen(text),
                "multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 50], [0, 0, 0, 1]])"
                "cube(size = [%g, %g, %g], center = true);",
                90 - 2.0 * i, 90 - 2.0 * i, 90 - 2.0 * i);
    strcat(text, "}");
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    struct picture picture = {NULL, NULL};
    struct csgcast_stats stats;
    const bool ok = scene && draw(CSGCAST_BACKEND_AUTO, scene, SIZE, &picture, &stats);
    CHECK(ok, "no picture");
    if (ok)
        CHECK(stats.solid_tests < 3 * stats.proxy_pixels, "%zu tests at %zu pixels",
              stats.solid_tests, stats.proxy_pixels);
    csgcast_scene_destroy(scene);
    drop(&picture);
}

/* The corners of the cube are no tiles of a program of their own; neither is what draws few pixels.
 */
static void check_few_programs(void)
{
    check_alone(five, "chain ");
    const char *const few =
        "sphere(r = 2); multmatrix([[1, 0, 0, 6], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])"
        "cylinder(h = 4, r1 = 2, r2 = 2);"
        "multmatrix([[1, 0, 0, 12], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])"
        "cylinder($fn = 5, h = 4, r1 = 2, r2 = 1);"
        "multmatrix([[1, 0, 0, 0], [0, 1, 0, 6], [0, 0, 1, 0], [0, 0, 0, 1]])"
        "difference() { cube([3, 3, 3]); sphere(r = 2); }";
    char *text = malloc(strlen(few) + 100);
    CHECK(text, "out of memory");
    if (!text)
        return;
    check_alone(few, "loop ");
    sprintf(text, "%s cube([40, 40, 40], center = true);", few);
    check_alone(text, "straight 1, loop ");
    sprintf(text, "sphere(r = 2);");
    check_alone(text, "straight 1");
    free(text);
}

/* A plate that is drawn alone has no depth buffer; with a post in it, before it in the file, it
 * has, also in the renderer that has drawn the plate alone. */
static void check_post(const struct example *example)
{
    const size_t bytes = 4 * (size_t)example->size * (size_t)example->size;
    const struct csgcast_renderer_params params = {0};
    struct csgcast_renderer *renderer = csgcast_renderer_create(&params);
    char *alone = plate(example->solid), *both = alone ? malloc(strlen(alone) + 150) : NULL;
    uint8_t *direct = malloc(bytes), *shaded = malloc(bytes);
    float *z = malloc(bytes / 4 * sizeof *z);
    bool ok = both && direct && shaded && z;
    if (both)
        sprintf(both,
                "multmatrix([[1, 0, 0, 32], [0, 1, 0, 32], [0, 0, 1, 0], [0, 0, 0, 1]]) "
                "cylinder(h = 30, r1 = 4, r2 = 4);\n%s",
                alone);
    const char *texts[] = {alone, both, alone};
    for (int i = 0; i < 3 && ok; i++) {
        ok = draw_colors(renderer, texts[i], example->size, direct, NULL) &&
             draw_colors(renderer, texts[i], example->size, shaded, z);
        CHECK(ok && memcmp(direct, shaded, bytes) == 0, "%s, picture %d", example->name, i);
    }
    CHECK(ok, "%s", example->name);
    csgcast_renderer_destroy(renderer);
    free(alone);
    free(both);
    free(direct);
    free(shaded);
    free(z);
}

int main(void)
{
    check_kept(&examples[0]);
    check_rows();
    check_few_solids();
    check_stiff();
    check_clauses();
    check_apart();
    check_inside();
    check_few_programs();
    check_post(&examples[1]);
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++)
        check_example(&examples[i]);
    return num_failed != 0;
}
