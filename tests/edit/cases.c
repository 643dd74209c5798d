/* SPDX-License-Identifier: MIT */

/* Edits that once went wrong, or could. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench.h"

/* A solid that goes and comes back keeps its index; nothing of it shows meanwhile. */
static void check_empty(struct bench *bench)
{
    static const char text[] =
        "difference() { cube(10); sphere(4); }\ntranslate([20,0,0]) cube(3);";
    static const char without[] =
        "difference() { cube(10); sphere(0); }\ntranslate([20,0,0]) cube(3);";
    struct csgcast_leaf leaf;
    struct csgcast_scene *scene = bench_begin(bench, text), *fresh = bench_parse(without);
    const double flat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    bench_draw_edited(bench, scene, NULL);
    bench_draw(bench->fresh, fresh, NULL, &bench->expected);
    CHECK(csgcast_scene_set_parameters(scene, 1, "r = 0"), "%s", bench_last_message);
    bench_draw_edited(bench, scene, NULL);
    bench_compare_pictures(bench, "empty by parameters", false);
    CHECK(csgcast_scene_get_leaf(scene, 1, &leaf) && leaf.empty &&
              strcmp(leaf.parameters, "r = 0") == 0,
          "leaf 1 is not empty");
    CHECK(csgcast_scene_set_parameters(scene, 1, "4"), "%s", bench_last_message);
    CHECK(csgcast_scene_set_matrix(scene, 1, flat), "%s", bench_last_message);
    bench_draw_edited(bench, scene, NULL);
    bench_compare_pictures(bench, "empty by matrix", false);
    struct csgcast_scene *whole = bench_parse(text);
    CHECK(csgcast_scene_get_leaf(scene, 0, &leaf) &&
              csgcast_scene_set_matrix(scene, 1, leaf.matrix),
          "%s", bench_last_message);
    bench_draw_edited(bench, scene, NULL);
    bench_draw(bench->fresh, whole, NULL, &bench->expected);
    bench_compare_pictures(bench, "back again", true);
    csgcast_scene_destroy(whole);
    csgcast_scene_destroy(fresh);
    csgcast_scene_destroy(scene);
}

#define LARGE_SIZE 256

/* Of an object that is drawn in tiles where it is large, and whole where it is not. */
static size_t draw_large(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                         const char *variant, float *id)
{
    const struct csgcast_view view = {
        .width = LARGE_SIZE,
        .height = LARGE_SIZE,
        .camera = {.kind = CSGCAST_CAMERA_GIMBAL, .rotate = {58, 7, 23}, .distance = 80}};
    const struct csgcast_image image = {.id = id};
    struct csgcast_stats stats;
    CHECK(csgcast_render(renderer, scene, &view, &image), "the scene does not render");
    csgcast_renderer_get_stats(renderer, &stats);
    CHECK(!variant || strstr(stats.variants, "reference") || strstr(stats.variants, variant),
          "%s instead of %s", stats.variants, variant);
    return stats.programs;
}

/* An edit that makes an object larger draws it in tiles, for which all programs are there. */
void check_growth(struct bench *bench)
{
    static float got[LARGE_SIZE * LARGE_SIZE], expected[LARGE_SIZE * LARGE_SIZE];
    const double large[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const double small[16] = {0.15, 0, 0, 0, 0, 0.15, 0, 0, 0, 0, 0.15, 0, 0, 0, 0, 1};
    char *text = bench->text;
    int at = snprintf(text, MODEL_MAX_TEXT, "difference() { cube(24, center = true);");
    for (int i = 0; i < 14; i++)
        at += snprintf(text + at, MODEL_MAX_TEXT - (size_t)at, "translate([%d, %d, 3]) sphere(%d);",
                       3 * (i % 5) - 5, 4 * (i / 5) - 4, 2 + i % 7);
    snprintf(text + at, MODEL_MAX_TEXT - (size_t)at, "}");
    struct csgcast_scene *scene = bench_begin(bench, text), *fresh = bench_parse(text);
    CHECK(csgcast_scene_set_matrix(scene, 0, small), "%s", bench_last_message);
    const size_t programs = draw_large(bench->edited, scene, "straight 1", got);
    CHECK(csgcast_scene_set_matrix(scene, 0, large), "%s", bench_last_message);
    CHECK(draw_large(bench->edited, scene, "chain", got) == programs, "growth compiled a program");
    draw_large(bench->fresh, fresh, "chain", expected);
    CHECK(memcmp(got, expected, sizeof got) == 0, "grown: pixels differ");
    csgcast_scene_destroy(fresh);
    csgcast_scene_destroy(scene);
}

/* The matrix is the product of all around the leaf; a node with several leaves moves as one. */
static void check_getters(struct bench *bench)
{
    static const char text[] =
        "color([1, 0, 0]) multmatrix([[1,0,0,5],[0,1,0,6],[0,0,1,7],[0,0,0,1]]) scale([2, 3, 4])\n"
        "  cylinder(h = 3, /* ) */ r = 1);\n"
        "linear_extrude(height = 2) polygon([[0, 0], [4, 0], [1, 1], [0, 4]]);";
    static const double expected[16] = {2, 0, 0, 5, 0, 3, 0, 6, 0, 0, 4, 7, 0, 0, 0, 1};
    struct csgcast_scene *scene = bench_begin(bench, text);
    struct csgcast_leaf leaf, piece;
    CHECK(csgcast_scene_get_leaf(scene, 0, &leaf), "%s", bench_last_message);
    CHECK(memcmp(leaf.matrix, expected, sizeof expected) == 0, "the matrix differs");
    CHECK(strcmp(leaf.kind, "cylinder") == 0 && leaf.line == 2 && leaf.column == 3 &&
              strcmp(leaf.parameters, "h = 3, /* ) */ r = 1") == 0 && leaf.color[0] == 1 &&
              leaf.num == 1,
          "%s %u:%u (%s)", leaf.kind, leaf.line, leaf.column, leaf.parameters);
    const size_t num = csgcast_scene_num_leaves(scene);
    CHECK(num == 3, "%zu leaves", num);
    CHECK(csgcast_scene_get_leaf(scene, 2, &piece) && piece.first == 1 && piece.num == 2,
          "first %zu num %zu", piece.first, piece.num);
    CHECK(csgcast_scene_set_matrix(scene, 2, expected), "%s", bench_last_message);
    CHECK(csgcast_scene_get_leaf(scene, 1, &piece) &&
              memcmp(piece.matrix, expected, sizeof expected) == 0,
          "the pieces do not move as one");
    struct csgcast_scene *fresh = bench_parse(
        "color([1, 0, 0]) multmatrix([[1,0,0,5],[0,1,0,6],[0,0,1,7],[0,0,0,1]]) scale([2, 3, 4])\n"
        "  cylinder(h = 3, r = 1);\n"
        "multmatrix([[2,0,0,5],[0,3,0,6],[0,0,4,7],[0,0,0,1]])"
        "linear_extrude(height = 2) polygon([[0, 0], [4, 0], [1, 1], [0, 4]]);");
    bench_draw_edited(bench, scene, NULL);
    bench_draw(bench->fresh, fresh, NULL, &bench->expected);
    bench_compare_pictures(bench, "pieces", true);
    csgcast_scene_destroy(fresh);
    csgcast_scene_destroy(scene);
}

/* A chain of rounded matrices: setting what was got changes nothing, flush faces stay flush. */
static void check_same(struct bench *bench)
{
    static const char text[] =
        "difference() {\n"
        " multmatrix([[0.707107,-0.707107,0,1.23457],[0.707107,0.707107,0,0],[0,0,1,0],[0,0,0,1]])"
        "\n"
        "  cube(10);\n"
        " multmatrix([[0.707107,-0.707107,0,1.23457],[0.707107,0.707107,0,0],[0,0,1,0],[0,0,0,1]])"
        "\n"
        "  multmatrix([[1,0,0,3.33333],[0,1,0,3.33333],[0,0,1,5],[0,0,0,1]]) cube([3,3,5]);\n}";
    struct csgcast_scene *scene = bench_begin(bench, text), *fresh = bench_parse(text);
    struct csgcast_leaf leaf;
    CHECK(csgcast_scene_get_leaf(scene, 1, &leaf) &&
              csgcast_scene_set_parameters(scene, 1, leaf.parameters) &&
              csgcast_scene_set_matrix(scene, 1, leaf.matrix),
          "%s", bench_last_message);
    bench_draw_edited(bench, scene, NULL);
    bench_draw(bench->fresh, fresh, NULL, &bench->expected);
    bench_compare_pictures(bench, "unchanged", true);
    bench_compare_info(scene, fresh, "unchanged");
    csgcast_scene_destroy(fresh);
    csgcast_scene_destroy(scene);
}

/* A wide union and what it is cut by, moved along x by at. */
static void print_section(char *text, size_t size, double at)
{
    size_t num = (size_t)snprintf(text, size, "difference() { union() {\n");
    for (int i = 0; i < 40; i++)
        num += (size_t)snprintf(
            text + num, size - num, "multmatrix([[1,0,0,%d],[0,1,0,%d],[0,0,1,%d],[0,0,0,1]]) %s\n",
            i % 5 * 3, i / 5 % 4 * 3, i / 20 * 3, i % 3 ? "sphere(2);" : "cube(2);");
    snprintf(text + num, size - num,
             "}\nmultmatrix([[1,0,0,%.17g],[0,1,0,-9],[0,0,1,-9],[0,0,0,1]]) cube(40);\n}", at);
}

/* What a section cuts changes as it is moved, and with it which objects there are. */
static void check_section(struct bench *bench)
{
    print_section(bench->text, MODEL_MAX_TEXT, 7);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    bench_draw_edited(bench, scene, NULL);
    for (double at = -5; at < 20; at += 2.5) {
        const double matrix[16] = {1, 0, 0, at, 0, 1, 0, -9, 0, 0, 1, -9, 0, 0, 0, 1};
        print_section(bench->text, MODEL_MAX_TEXT, at);
        CHECK(csgcast_scene_set_matrix(scene, 40, matrix), "%s", bench_last_message);
        bench_compare_text(bench, scene, "section", true);
    }
    csgcast_scene_destroy(scene);
}

/* What boxes leave of a node may be several objects, which are blended one by one: so they are as
 * well where solids are kept that do not show. */
static void check_blended(struct bench *bench)
{
    static const char *const parts[][3] = {{"", "color([0, 1, 0, 0.5]) sphere(3);", ""},
                                           {"", "#sphere(3);", ""},
                                           {"%", "sphere(3);", "cube(1);"}};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        snprintf(bench->text, MODEL_MAX_TEXT,
                 "%sdifference() { union() { %s"
                 " multmatrix([[1,0,0,2],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) cube(3); }"
                 " multmatrix([[1,0,0,50],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) cube(1); } %s",
                 parts[i][0], parts[i][1], parts[i][2]);
        struct csgcast_scene *scene = bench_begin(bench, bench->text);
        struct csgcast_scene *fresh = bench_parse(bench->text);
        bench_draw_edited(bench, scene, NULL);
        bench_draw(bench->fresh, fresh, NULL, &bench->expected);
        bench_compare_pictures(bench, "blended", true);
        csgcast_scene_destroy(fresh);
        csgcast_scene_destroy(scene);
    }
}

/* A scene whose first frame had no use for a shading pass: bytes, as a viewer asks for them. */
static void draw_bytes(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                       uint8_t *rgba, struct csgcast_stats *stats)
{
    const struct csgcast_view view = {.width = SIZE, .height = SIZE};
    const struct csgcast_image image = {.rgba8 = rgba};
    CHECK(csgcast_render(renderer, scene, &view, &image), "the scene does not render");
    csgcast_renderer_get_stats(renderer, stats);
}

/* Other numbers of faces, solids that turn translucent, and what is left of an object: all of it is
 * drawn by what was compiled for the first frame. */
static void check_bytes(struct bench *bench)
{
    static const char format[] =
        "difference() { cube(6); cylinder(%s); }\ncolor([%s]) cylinder(%s);\n";
    static const char *const edits[][3] = {
        {"h = 9, r = 2, $fn = 6", "1, 1, 0, 1", "h = 4, r = 5, $fn = 5"},
        {"h = 9, r = 0", "1, 1, 0, 1", "h = 4, r = 5, $fn = 3"},
        {"h = 9, r = 0", "1, 0, 0, 0.5", "h = 4, r = 5, $fn = 4"},
        {"h = 9, r = 3", "1, 0, 0, 0.5", "h = 4, r = 5"},
        {"h = 9, r = 3", "1, 0, 1, 1", "h = 4, r1 = 5, r2 = 0, $fn = 9"},
    };
    static uint8_t got[4 * PIXELS], expected[4 * PIXELS];
    struct csgcast_stats stats;
    snprintf(bench->text, MODEL_MAX_TEXT, format, "h = 9, r = 2", "1, 1, 0, 1", "h = 4, r = 5");
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    draw_bytes(bench->edited, scene, got, &stats);
    const size_t programs = stats.programs;
    for (size_t i = 0; i < sizeof edits / sizeof *edits; i++) {
        float color[4];
        sscanf(edits[i][1], "%f, %f, %f, %f", &color[0], &color[1], &color[2], &color[3]);
        const struct csgcast_edit both[2] = {
            {.leaf = 1, .parameters = edits[i][0]},
            {.leaf = 2, .parameters = edits[i][2], .color = color}};
        CHECK(csgcast_scene_edit(scene, both, 2), "%s", bench_last_message);
        draw_bytes(bench->edited, scene, got, &stats);
        CHECK(stats.programs == programs, "edit %zu compiled: %zu programs became %zu (%s)", i,
              programs, stats.programs, stats.variants);
        snprintf(bench->text, MODEL_MAX_TEXT, format, edits[i][0], edits[i][1], edits[i][2]);
        struct csgcast_scene *fresh = bench_parse(bench->text);
        draw_bytes(bench->fresh, fresh, expected, &stats);
        CHECK(memcmp(got, expected, sizeof got) == 0, "edit %zu: pixels differ", i);
        csgcast_scene_destroy(fresh);
    }
    csgcast_scene_destroy(scene);
}

static void expect_error(bool refused, const char *message)
{
    CHECK(refused && strstr(bench_last_message, message), "expected '%s', got '%s'", message,
          bench_last_message);
    bench_last_message[0] = 0;
}

static void check_errors(struct bench *bench)
{
    static const char text[] = "cube(2);\nsphere(1);";
    struct csgcast_scene *scene = bench_begin(bench, text);
    double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const float nan_color[4] = {NAN, 0, 0, 1};
    const struct csgcast_edit second_wrong[2] = {{.leaf = 0, .parameters = "3"},
                                                 {.leaf = 7, .parameters = "3"}};
    bench_draw(bench->edited, scene, NULL, &bench->expected);
    expect_error(!csgcast_scene_set_matrix(scene, 2, matrix), "there is no leaf 2 of 2");
    matrix[3] = INFINITY;
    expect_error(!csgcast_scene_set_matrix(scene, 0, matrix), "not finite");
    matrix[3] = 0, matrix[12] = 5;
    expect_error(!csgcast_scene_set_matrix(scene, 0, matrix), "by rows");
    expect_error(!csgcast_scene_set_color(scene, 0, nan_color), "colour");
    expect_error(!csgcast_scene_set_parameters(scene, 1, "r = "), "<edit of leaf 1>:");
    expect_error(!csgcast_scene_set_parameters(scene, 1, "r = 3); cube("), "nothing may follow");
    CHECK(csgcast_scene_set_parameters(scene, 1, "1 // end"), "%s", bench_last_message);
    expect_error(!csgcast_scene_edit(scene, second_wrong, 2), "there is no leaf 7");
    bench_draw_edited(bench, scene, NULL);
    bench_compare_pictures(bench, "after refused edits", true);
    csgcast_scene_destroy(scene);
}

/* Zeros of a matrix have no sign, whether it comes from the text or from an edit. */
static void check_zeros(struct bench *bench)
{
    static const double turned[16] = {0.8, -0.6, 1, 0, 0.6, 0.8, 1, 0, 1, 1, 2, 0, 0, 0, 0, 1};
    struct csgcast_scene *scene = bench_begin(
        bench, "multmatrix([[0.8,-0.6,1,0],[0.6,0.8,1,0],[1,1,2,0],[0,0,0,1]]) cube(5);");
    struct csgcast_scene *fresh =
        bench_parse("multmatrix([[1.5,0,0,3],[0,1,0,2],[0,0,1,1],[0,0,0,1]]) cube(5);");
    bench_draw(bench->fresh, fresh, NULL, &bench->expected);
    for (int i = 0; i < 16; i++) {
        const double zero[2] = {0, -0.0};
        const double matrix[16] = {1.5,
                                   zero[i & 1],
                                   zero[i >> 1 & 1],
                                   3,
                                   zero[i >> 2 & 1],
                                   1,
                                   zero[i >> 3],
                                   2,
                                   -0.0,
                                   0,
                                   1,
                                   1,
                                   0,
                                   0,
                                   0,
                                   1};
        CHECK(csgcast_scene_set_matrix(scene, 0, matrix), "%s", bench_last_message);
        bench_draw_edited(bench, scene, NULL);
        bench_compare_pictures(bench, "zeros", true);
        CHECK(csgcast_scene_set_matrix(scene, 0, turned), "%s", bench_last_message);
    }
    csgcast_scene_destroy(fresh);
    csgcast_scene_destroy(scene);
}

static void print_render(char *text, const char *color, double x, const char *radius)
{
    snprintf(text, MODEL_MAX_TEXT,
             "color([%s]) render() { difference() { cube(10);"
             " multmatrix([[1,0,0,%.17g],[0,1,0,1],[0,0,1,6],[0,0,0,1]]) sphere(%s); }"
             " multmatrix([[1,0,0,12],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) cube(3); }\n"
             "cube(2); multmatrix([[1,0,0,-5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) sphere(2);",
             color, x, radius);
}

/* What is left in a render() is framed by itself, and has one colour. */
static void check_render(struct bench *bench)
{
    static const struct {
        const char *color;
        double x;
        const char *radius;
    } edits[] = {{"1, 0, 0, 1", 5, "5"}, {"1, 0, 0, 1", 9, "5"},   {"0, 1, 0, 1", 9, "12"},
                 {"0, 1, 0, 1", 5, "9"}, {"0, 1, 0, 0.5", 5, "9"}, {"0, 0, 1, 0.5", 3, "4"}};
    print_render(bench->text, "1, 0, 0, 1", 5, "4");
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    bench_draw_edited(bench, scene, NULL);
    for (size_t i = 0; i < sizeof edits / sizeof *edits; i++) {
        const double matrix[16] = {1, 0, 0, edits[i].x, 0, 1, 0, 1, 0, 0, 1, 6, 0, 0, 0, 1};
        float color[4];
        sscanf(edits[i].color, "%f, %f, %f, %f", &color[0], &color[1], &color[2], &color[3]);
        const struct csgcast_edit both[2] = {
            {.leaf = 1, .matrix = matrix, .parameters = edits[i].radius},
            {.leaf = i % 3, .color = color}};
        CHECK(csgcast_scene_edit(scene, both, 2), "%s", bench_last_message);
        print_render(bench->text, edits[i].color, edits[i].x, edits[i].radius);
        bench_compare_text(bench, scene, "render", true);
    }
    csgcast_scene_destroy(scene);
}

/* An object of which nothing is left is nowhere, not everywhere: it takes no far side from others,
 * in views without perspective and of little of the scene either. */
static void check_nowhere(struct bench *bench)
{
    static const char text[] =
        "color([0.2, 0.6, 0.9, 0.5]) cube(10);\n"
        "intersection() { cube(2); multmatrix([[1,0,0,0],[0,1,0,9],[0,0,1,0],[0,0,0,1]]) "
        "sphere(2); }";
    static const struct csgcast_camera cameras[] = {
        {.viewall = true},
        {.viewall = true, .projection = CSGCAST_ORTHOGRAPHIC},
        {.kind = CSGCAST_CAMERA_GIMBAL, .rotate = {53, 0, 168}, .distance = 100, .fov = 5e-4}};
    struct csgcast_scene *scene = bench_begin(bench, text), *fresh = bench_parse(text);
    for (size_t i = 0; i < 3; i++) {
        bench_draw(bench->edited, scene, &cameras[i], &bench->got);
        bench_draw(bench->fresh, fresh, &cameras[i], &bench->expected);
        bench_compare_pictures(bench, "an object that is nowhere", true);
    }
    csgcast_scene_destroy(fresh);
    csgcast_scene_destroy(scene);
}

void check_cases(struct bench *bench)
{
    check_render(bench);
    check_zeros(bench);
    check_empty(bench);
    check_nowhere(bench);
    check_getters(bench);
    check_same(bench);
    check_section(bench);
    check_blended(bench);
    check_bytes(bench);
    check_errors(bench);
}
