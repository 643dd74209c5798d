/* SPDX-License-Identifier: MIT */

/*
 * Edits through the library against loading the edited text: pictures, bounds and counts equal to
 * the last bit, no program compiled, and edits that are wrong change nothing.
 *
 *     edit [--backend=egl|osmesa|reference] [--scenes=N] [--seed=S]
 */

#include <csgcast/csgcast.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../unit/check.h"
#include "model.h"

#define SIZE 72
#define PIXELS (SIZE * SIZE)
#define NUM_EDITS 5

struct picture {
    float rgba[4 * PIXELS], z[PIXELS], normal[3 * PIXELS], id[PIXELS];
};

struct bench {
    struct csgcast_renderer *edited, *fresh; /* one each, so that programs can be counted */
    struct picture got, expected;
    char text[MODEL_MAX_TEXT];
    bool reference;
};

static size_t num_messages;
static const char *forced; /* variant; NULL: none */
static char last_message[512];

static void count_message(void *user, enum csgcast_log_level level, enum csgcast_message id,
                          const char *text)
{
    (void)user, (void)level, (void)id;
    num_messages++;
    snprintf(last_message, sizeof last_message, "%s", text);
}

static struct csgcast_scene *parse(const char *text, bool editable)
{
    const struct csgcast_scene_params params = {
        .name = "model", .editable = editable, .log = count_message};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    if (!scene) {
        fprintf(stderr, "%s\n%s", last_message, text);
        exit(1);
    }
    return scene;
}

static void draw_view(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                      const struct csgcast_camera *camera, struct picture *picture)
{
    const struct csgcast_view view = {
        .width = SIZE, .height = SIZE, .camera = *camera, .variant = forced};
    const struct csgcast_image image = {
        .rgba = picture->rgba, .z = picture->z, .normal = picture->normal, .id = picture->id};
    CHECK(csgcast_render(renderer, scene, &view, &image), "the scene does not render");
}

static void draw(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                 struct picture *picture)
{
    draw_view(renderer, scene, &(struct csgcast_camera){0}, picture);
}

static size_t num_programs(const struct csgcast_renderer *renderer)
{
    struct csgcast_stats stats;
    csgcast_renderer_get_stats(renderer, &stats);
    return stats.programs;
}

static void compare_pictures(const struct bench *bench, const char *what, bool with_id)
{
    size_t rgba = 0, z = 0, normal = 0, id = 0;
    for (int i = 0; i < PIXELS; i++) {
        rgba += memcmp(bench->got.rgba + 4 * i, bench->expected.rgba + 4 * i, 16) != 0;
        z += memcmp(&bench->got.z[i], &bench->expected.z[i], 4) != 0;
        normal += memcmp(bench->got.normal + 3 * i, bench->expected.normal + 3 * i, 12) != 0;
        id += with_id && bench->got.id[i] != bench->expected.id[i];
    }
    CHECK(rgba + z + normal + id == 0, "%s: pixels differ, rgba %zu z %zu normal %zu id %zu\n%s",
          what, rgba, z, normal, id, bench->text);
}

static void compare_info(const struct csgcast_scene *a, const struct csgcast_scene *b,
                         const char *what)
{
    struct csgcast_scene_info x, y;
    double box[2][6] = {{0}};
    csgcast_scene_get_info(a, &x);
    csgcast_scene_get_info(b, &y);
    CHECK(x.num_leaves == y.num_leaves && x.num_nodes == y.num_nodes && x.depth == y.depth &&
              x.num_objects == y.num_objects && x.num_planes == y.num_planes &&
              x.num_quadrics == y.num_quadrics && x.num_shared == y.num_shared &&
              x.num_dropped == y.num_dropped && x.max_crossings == y.max_crossings &&
              x.num_kinds == y.num_kinds,
          "%s: counts differ: leaves %zu/%zu nodes %zu/%zu objects %zu/%zu planes %zu/%zu shared "
          "%zu/%zu dropped %zu/%zu",
          what, x.num_leaves, y.num_leaves, x.num_nodes, y.num_nodes, x.num_objects, y.num_objects,
          x.num_planes, y.num_planes, x.num_shared, y.num_shared, x.num_dropped, y.num_dropped);
    CHECK(csgcast_scene_get_bounds(a, box[0], box[0] + 3) ==
                  csgcast_scene_get_bounds(b, box[1], box[1] + 3) &&
              memcmp(box[0], box[1], sizeof box[0]) == 0,
          "%s: bounds differ", what);
}

static void compare(struct bench *bench, const struct csgcast_scene *scene,
                    const struct model *model, const char *what, bool with_id)
{
    model_print(model, bench->text);
    struct csgcast_scene *fresh = parse(bench->text, false);
    draw(bench->edited, scene, &bench->got);
    draw(bench->fresh, fresh, &bench->expected);
    compare_pictures(bench, what, with_id);
    if (with_id)
        compare_info(scene, fresh, what);
    csgcast_scene_destroy(fresh);
}

/* Many edits of one scene, each leaf also far away, large or gone for a while, every few of them
 * drawn by the next variant. */
static void check_series(struct bench *bench, uint64_t seed)
{
    static struct model model;
    size_t name = 0;
    model_init(&model, seed, 24);
    for (int i = 0; i < model.num_leaves; i++)
        model.leaves[i].color[0] = -1;
    model_print(&model, bench->text);
    struct csgcast_scene *scene = parse(bench->text, true);
    for (int i = 0; i < 8 * NUM_EDITS; i++) {
        const size_t leaf = (size_t)model_random(&model, 0, model.num_leaves);
        struct model_leaf *own = &model.leaves[leaf];
        model_random_matrix(&model, own->matrix);
        own->matrix[3] += i % 7 == 3 ? 300 : 0;
        for (int j = 0; j < 3 && i % 7 == 5; j++)
            own->matrix[5 * j] *= 20;
        CHECK(csgcast_scene_set_matrix(scene, leaf, own->matrix), "%s", last_message);
        if (i % 4)
            continue;
        forced = csgcast_variant_name(name++);
        name = forced ? name : 0;
        compare(bench, scene, &model, forced ? forced : "auto", true);
    }
    forced = NULL;
    csgcast_scene_destroy(scene);
}

/* One random change, made in the model and in the scene. */
static const char *edit_one(struct model *model, struct csgcast_scene *scene, size_t leaf)
{
    struct model_leaf *own = &model->leaves[leaf];
    switch ((int)model_random(model, 0, 3)) {
    case 0:
        model_random_matrix(model, own->matrix);
        CHECK(csgcast_scene_set_matrix(scene, leaf, own->matrix), "%s", last_message);
        return "matrix";
    case 1:
        model_random_parameters(model, own->kind, own->parameters);
        CHECK(csgcast_scene_set_parameters(scene, leaf, own->parameters), "%s", last_message);
        return "parameters";
    default:
        model_random_color(model, own->color);
        CHECK(csgcast_scene_set_color(scene, leaf, own->color), "%s", last_message);
        return "colour";
    }
}

static size_t random_leaf(struct model *model)
{
    return (size_t)model_random(model, 0, model->num_leaves);
}

static void check_random(struct bench *bench, uint64_t seed, int max_leaves, bool editable)
{
    static struct model model;
    model_init(&model, seed, max_leaves);
    model_print(&model, bench->text);
    struct csgcast_scene *scene = parse(bench->text, editable);
    compare(bench, scene, &model, "before", true);
    for (int i = 0; i < NUM_EDITS; i++) {
        const char *what = edit_one(&model, scene, random_leaf(&model));
        compare(bench, scene, &model, what, true);
    }
    csgcast_scene_destroy(scene);
}

/* Programs for structures only: from afar no quadric is stiff, and all colours are opaque. */
static void check_programs(struct bench *bench, uint64_t seed, int max_leaves)
{
    static struct model model;
    const struct csgcast_camera camera = {.kind = CSGCAST_CAMERA_GIMBAL,
                                          .translate = {3, 3, 3},
                                          .rotate = {58, 7, 23},
                                          .distance = 120};
    const float orange[4] = {1, 0.5f, 0, 1};
    model_init(&model, seed, max_leaves);
    for (int i = 0; i < model.num_leaves; i++)
        model.leaves[i].color[0] = -1;
    model_print(&model, bench->text);
    struct csgcast_scene *scene = parse(bench->text, true);
    draw_view(bench->edited, scene, &camera, &bench->got);
    const size_t programs = num_programs(bench->edited);
    for (int i = 0; i < 4 * NUM_EDITS; i++) {
        const size_t leaf = random_leaf(&model);
        model_random_matrix(&model, model.leaves[leaf].matrix);
        model_random_parameters(&model, model.leaves[leaf].kind, model.leaves[leaf].parameters);
        const struct csgcast_edit edit = {leaf, model.leaves[leaf].matrix,
                                          model.leaves[leaf].parameters, orange};
        CHECK(csgcast_scene_edit(scene, &edit, 1), "%s", last_message);
        draw_view(bench->edited, scene, &camera, &bench->got);
        CHECK(num_programs(bench->edited) == programs, "seed %llu: %zu programs became %zu",
              (unsigned long long)seed, programs, num_programs(bench->edited));
    }
    csgcast_scene_destroy(scene);
}

/* Many leaves in one call, one of them twice. */
static void check_batch(struct bench *bench)
{
    static struct model model;
    struct csgcast_edit edits[5] = {{0}};
    double matrices[5][16];
    model_init(&model, 11, 20);
    model_print(&model, bench->text);
    struct csgcast_scene *scene = parse(bench->text, true);
    for (size_t i = 0; i < 5; i++) {
        model_random_matrix(&model, matrices[i]);
        edits[i] = (struct csgcast_edit){.leaf = i < 4 ? i : 0, .matrix = matrices[i]};
        memcpy(model.leaves[edits[i].leaf].matrix, matrices[i], sizeof matrices[i]);
    }
    CHECK(csgcast_scene_edit(scene, edits, 5), "%s", last_message);
    compare(bench, scene, &model, "batch", true);
    csgcast_scene_destroy(scene);
}

/* A solid that goes and comes back keeps its index; nothing of it shows meanwhile. */
static void check_empty(struct bench *bench)
{
    static const char text[] =
        "difference() { cube(10); sphere(4); }\ntranslate([20,0,0]) cube(3);";
    static const char without[] =
        "difference() { cube(10); sphere(0); }\ntranslate([20,0,0]) cube(3);";
    struct csgcast_leaf leaf;
    struct csgcast_scene *scene = parse(text, true), *fresh = parse(without, false);
    const double flat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    draw(bench->edited, scene, &bench->got);
    const size_t programs = num_programs(bench->edited);
    draw(bench->fresh, fresh, &bench->expected);
    CHECK(csgcast_scene_set_parameters(scene, 1, "r = 0"), "%s", last_message);
    draw(bench->edited, scene, &bench->got);
    compare_pictures(bench, "empty by parameters", false);
    CHECK(csgcast_scene_get_leaf(scene, 1, &leaf) && leaf.empty &&
              strcmp(leaf.parameters, "r = 0") == 0,
          "leaf 1 is not empty");
    CHECK(csgcast_scene_set_parameters(scene, 1, "4"), "%s", last_message);
    CHECK(csgcast_scene_set_matrix(scene, 1, flat), "%s", last_message);
    draw(bench->edited, scene, &bench->got);
    compare_pictures(bench, "empty by matrix", false);
    struct csgcast_scene *whole = parse(text, false);
    CHECK(csgcast_scene_get_leaf(scene, 0, &leaf) &&
              csgcast_scene_set_matrix(scene, 1, leaf.matrix),
          "%s", last_message);
    draw(bench->edited, scene, &bench->got);
    draw(bench->fresh, whole, &bench->expected);
    compare_pictures(bench, "back again", true);
    CHECK(num_programs(bench->edited) == programs, "an empty leaf compiled a program");
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
static void check_growth(struct bench *bench)
{
    static float got[LARGE_SIZE * LARGE_SIZE], expected[LARGE_SIZE * LARGE_SIZE];
    const double large[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const double small[16] = {0.3, 0, 0, 0, 0, 0.3, 0, 0, 0, 0, 0.3, 0, 0, 0, 0, 1};
    char *text = bench->text;
    int at = snprintf(text, MODEL_MAX_TEXT, "difference() { cube(24, center = true);");
    for (int i = 0; i < 14; i++)
        at += snprintf(text + at, MODEL_MAX_TEXT - (size_t)at,
                       "translate([%d, %d, 3]) sphere(%d);", 3 * (i % 5) - 5, 4 * (i / 5) - 4,
                       2 + i % 7);
    snprintf(text + at, MODEL_MAX_TEXT - (size_t)at, "}");
    struct csgcast_scene *scene = parse(text, true), *fresh = parse(text, false);
    CHECK(csgcast_scene_set_matrix(scene, 0, small), "%s", last_message);
    const size_t programs = draw_large(bench->edited, scene, "straight 1", got);
    CHECK(csgcast_scene_set_matrix(scene, 0, large), "%s", last_message);
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
    struct csgcast_scene *scene = parse(text, false);
    struct csgcast_leaf leaf, piece;
    CHECK(csgcast_scene_get_leaf(scene, 0, &leaf), "%s", last_message);
    CHECK(memcmp(leaf.matrix, expected, sizeof expected) == 0, "the matrix differs");
    CHECK(strcmp(leaf.kind, "cylinder") == 0 && leaf.line == 2 && leaf.column == 3 &&
              strcmp(leaf.parameters, "h = 3, /* ) */ r = 1") == 0 && leaf.color[0] == 1 &&
              leaf.num == 1,
          "%s %u:%u (%s)", leaf.kind, leaf.line, leaf.column, leaf.parameters);
    const size_t num = csgcast_scene_num_leaves(scene);
    CHECK(num == 3, "%zu leaves", num);
    CHECK(csgcast_scene_get_leaf(scene, 2, &piece) && piece.first == 1 && piece.num == 2,
          "first %zu num %zu", piece.first, piece.num);
    CHECK(csgcast_scene_set_matrix(scene, 2, expected), "%s", last_message);
    CHECK(csgcast_scene_get_leaf(scene, 1, &piece) &&
              memcmp(piece.matrix, expected, sizeof expected) == 0,
          "the pieces do not move as one");
    struct csgcast_scene *fresh = parse(
        "color([1, 0, 0]) multmatrix([[1,0,0,5],[0,1,0,6],[0,0,1,7],[0,0,0,1]]) scale([2, 3, 4])\n"
        "  cylinder(h = 3, r = 1);\n"
        "multmatrix([[2,0,0,5],[0,3,0,6],[0,0,4,7],[0,0,0,1]])"
        "linear_extrude(height = 2) polygon([[0, 0], [4, 0], [1, 1], [0, 4]]);",
        false);
    draw(bench->edited, scene, &bench->got);
    draw(bench->fresh, fresh, &bench->expected);
    compare_pictures(bench, "pieces", true);
    CHECK(!csgcast_scene_set_parameters(scene, 1, "height = 3") &&
              strstr(last_message, "linear_extrude"),
          "%s", last_message);
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
    struct csgcast_scene *scene = parse(text, false), *fresh = parse(text, false);
    struct csgcast_leaf leaf;
    CHECK(csgcast_scene_get_leaf(scene, 1, &leaf) &&
              csgcast_scene_set_parameters(scene, 1, leaf.parameters) &&
              csgcast_scene_set_matrix(scene, 1, leaf.matrix),
          "%s", last_message);
    draw(bench->edited, scene, &bench->got);
    draw(bench->fresh, fresh, &bench->expected);
    compare_pictures(bench, "unchanged", true);
    compare_info(scene, fresh, "unchanged");
    csgcast_scene_destroy(fresh);
    csgcast_scene_destroy(scene);
}

/* A wide union and what it is cut by, moved along x by at. */
static void print_section(char *text, size_t size, double at)
{
    size_t num = (size_t)snprintf(text, size, "difference() { union() {\n");
    for (int i = 0; i < 40; i++)
        num += (size_t)snprintf(text + num, size - num,
                                "multmatrix([[1,0,0,%d],[0,1,0,%d],[0,0,1,%d],[0,0,0,1]]) %s\n",
                                i % 5 * 3, i / 5 % 4 * 3, i / 20 * 3,
                                i % 3 ? "sphere(2);" : "cube(2);");
    snprintf(text + num, size - num,
             "}\nmultmatrix([[1,0,0,%.17g],[0,1,0,-9],[0,0,1,-9],[0,0,0,1]]) cube(40);\n}", at);
}

/* What a section cuts changes as it is moved, and with it which objects there are. */
static void check_section(struct bench *bench)
{
    char text[8192];
    print_section(text, sizeof text, 7);
    struct csgcast_scene *scene = parse(text, true);
    for (double at = -5; at < 20; at += 2.5) {
        const double matrix[16] = {1, 0, 0, at, 0, 1, 0, -9, 0, 0, 1, -9, 0, 0, 0, 1};
        print_section(text, sizeof text, at);
        struct csgcast_scene *fresh = parse(text, false);
        CHECK(csgcast_scene_set_matrix(scene, 40, matrix), "%s", last_message);
        draw(bench->edited, scene, &bench->got);
        draw(bench->fresh, fresh, &bench->expected);
        compare_pictures(bench, "section", true);
        compare_info(scene, fresh, "section");
        csgcast_scene_destroy(fresh);
    }
    csgcast_scene_destroy(scene);
}

static void expect_error(bool refused, const char *message)
{
    CHECK(refused && strstr(last_message, message), "expected '%s', got '%s'", message,
          last_message);
    last_message[0] = 0;
}

static void check_errors(struct bench *bench)
{
    static const char text[] = "cube(2);\nsphere(1);";
    struct csgcast_scene *scene = parse(text, false);
    double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const float nan_color[4] = {NAN, 0, 0, 1};
    const struct csgcast_edit second_wrong[2] = {{.leaf = 0, .parameters = "3"},
                                                 {.leaf = 7, .parameters = "3"}};
    draw(bench->edited, scene, &bench->expected);
    expect_error(!csgcast_scene_set_matrix(scene, 2, matrix), "there is no leaf 2 of 2");
    matrix[3] = INFINITY;
    expect_error(!csgcast_scene_set_matrix(scene, 0, matrix), "not finite");
    matrix[3] = 0, matrix[12] = 5;
    expect_error(!csgcast_scene_set_matrix(scene, 0, matrix), "by rows");
    expect_error(!csgcast_scene_set_color(scene, 0, nan_color), "colour");
    expect_error(!csgcast_scene_set_parameters(scene, 1, "r = "), "<edit of leaf 1>:");
    expect_error(!csgcast_scene_set_parameters(scene, 1, "r = 3); cube("), "nothing may follow");
    CHECK(csgcast_scene_set_parameters(scene, 1, "1 // end"), "%s", last_message);
    expect_error(!csgcast_scene_edit(scene, second_wrong, 2), "there is no leaf 7");
    draw(bench->edited, scene, &bench->got);
    compare_pictures(bench, "after refused edits", true);
    csgcast_scene_destroy(scene);
}

static struct csgcast_renderer *create(enum csgcast_backend backend)
{
    struct csgcast_renderer *renderer =
        csgcast_renderer_create(&(struct csgcast_renderer_params){.backend = backend});
    if (!renderer)
        exit(1);
    return renderer;
}

int main(int argc, char **argv)
{
    static struct bench bench;
    enum csgcast_backend backend = CSGCAST_BACKEND_EGL;
    unsigned long long seed = 1;
    int num_scenes = 10;
    for (int i = 1; i < argc; i++) {
        if (strncmp(argv[i], "--scenes=", 9) == 0)
            num_scenes = atoi(argv[i] + 9);
        else if (strncmp(argv[i], "--seed=", 7) == 0)
            seed = strtoull(argv[i] + 7, NULL, 10);
        else if (strcmp(argv[i], "--backend=osmesa") == 0)
            backend = CSGCAST_BACKEND_OSMESA;
        else if (strcmp(argv[i], "--backend=reference") == 0)
            backend = CSGCAST_BACKEND_REFERENCE;
        else if (strcmp(argv[i], "--backend=egl") != 0)
            return fprintf(stderr, "edit: unknown option %s\n", argv[i]), 2;
    }
    bench.edited = create(backend);
    bench.fresh = create(backend);
    check_growth(&bench); /* first: no program is there */
    for (int i = 0; i < num_scenes; i++)
        check_random(&bench, seed + (unsigned)i, 3 + 5 * (i % 10), i % 2);
    for (int i = 0; i < num_scenes; i++)
        check_programs(&bench, seed + (unsigned)i, 3 + 5 * (i % 10));
    for (int i = 0; i < num_scenes / 5; i++)
        check_series(&bench, seed + 100 + (unsigned)i);
    check_batch(&bench);
    check_empty(&bench);
    check_getters(&bench);
    check_same(&bench);
    check_section(&bench);
    check_errors(&bench);
    csgcast_renderer_destroy(bench.edited);
    csgcast_renderer_destroy(bench.fresh);
    printf("%s\n", num_failed ? "FAIL" : "ok");
    return num_failed != 0;
}
