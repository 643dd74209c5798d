/* SPDX-License-Identifier: MIT */

/*
 * Crowds against the same scene drawn without culling: leaf and distance must be equal to the last
 * bit, normals nearly so, from outside, between the solids, in parallel projection and from afar.
 *
 *     crowd egl|osmesa SEED
 */

#include <csgcast/csgcast.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/random.h"
#include "ideal/text.h"

enum { SIZE = 160, PIXELS = SIZE * SIZE, NUM_VIEWS = 6 };
enum { NUM_SOLIDS = 1200, NUM_DENSE = 4000, NUM_NESTED = 500, NUM_PARTS = 2500 };

#define MAX_NORMAL_ERROR 2e-4 /* the crowd's spheres have their normals in closed form */
#define MAX_COLOR_ERROR 2e-3f
/* Of the view between the solids only: what is close to the eye may be drawn in double without the
 * crowd, and in float as one of it. */
#define MAX_DEPTH_ERROR 4e-6f

enum { AMONG = 3 }; /* that view: the eye may even be in a solid, and then there is no crowd */

static uint64_t state;

static double between(double lo, double hi)
{
    return csg_random_between(&state, lo, hi);
}

static void put_solid(struct text *text)
{
    const double a = between(0.2, 1.5), b = between(0.2, 1.5), c = between(0.2, 1.5);
    switch ((int)between(0, 9)) {
    case 0:
        text_put(text, "cube([%.9g, %.9g, %.9g]);\n", a, b, c);
        break;
    case 1:
        text_put(text, "cylinder(h = %.9g, r = %.9g);\n", 2 * a, 0.5 * b);
        break;
    case 2:
        text_put(text, "cylinder(h = %.9g, r1 = %.9g, r2 = %.9g);\n", a, b, floor(2 * c));
        break;
    case 3:
        text_put(text, "ellipsoid(r = [%.9g, %.9g, %.9g]);\n", a, b, c);
        break;
    case 4:
        text_put(text, "tetrahedron([[0, 0, 0], [%.9g, 0, 1], [0, %.9g, 0], [1, 1, %.9g]]);\n", a,
                 b, c);
        break;
    case 5:
        text_put(text, "paraboloid(r = [%.9g, %.9g], c = %.9g, h = %.9g);\n", a, b, c, c);
        break;
    default:
        text_put(text, "sphere(r = %.9g);\n", a * b * b);
    }
}

/* A turned and, for one in four, sheared place. */
static void put_place(struct text *text)
{
    const double t = between(0, 6.3), s = sin(t), c = cos(t);
    const double shear = between(0, 4) < 1 ? between(-0.4, 0.4) : 0;
    text_put(text,
             "multmatrix([[%.17g, %.17g, %.9g, %.9g], [%.17g, %.17g, 0, %.9g], [0, 0, 1, %.9g], "
             "[0, 0, 0, 1]]) ",
             c, -s, shear, between(-15, 15), s, c, between(-15, 15), between(-15, 15));
}

/* A crowd of small solids of every kind, most of them hidden; some views are from within, and then
 * many cross the eye's plane. */
static char *make_dense_scene(void)
{
    struct text text = {0};
    for (int i = 0; i < NUM_DENSE; i++) {
        text_put(&text, "multmatrix([[0.4, 0, %.9g, 0], [0, 0.4, 0, 0], [0, %.9g, 0.4, 0]]) ",
                 between(-0.2, 0.2), between(-0.2, 0.2));
        text_put(&text, "rotate([%.9g, %.9g, 0]) ", between(0, 360), between(0, 360));
        put_place(&text);
        put_solid(&text);
    }
    return text.data;
}

/* Some solids come twice, in two colours and with others between: the first one shows. Some touch:
 * a lid on a cylinder, two halves of a rod. */
static char *make_scene(void)
{
    struct text text = {0};
    for (int i = 0; i < NUM_SOLIDS; i++) {
        const size_t begin = text.num;
        put_place(&text);
        if (i % 10 == 0)
            text_put(&text, "{ cylinder(h = 2, r = 0.5); translate([0, 0, 2]) cube([1, 1, 1]); "
                            "translate([0, 0, -1]) cylinder(h = 1, r = 0.5); }\n");
        else
            put_solid(&text);
        char copy[1024];
        const size_t length = text.num - begin;
        memcpy(copy, text.data + begin, length);
        if (i % 7 == 0)
            text_put(&text, "color([1, 0, 0]) %.*s", (int)length, copy);
        if (i % 50 == 0)
            text_put(&text, "color([0, 0, 1, 0.5]) sphere(r = %.9g);\n", between(1, 2));
    }
    return text.data;
}

/* Solids around each other, from the inside out and the other way round, in full view: what is
 * large is hidden by squares of pixels. */
static char *make_nested_scene(bool is_translucent)
{
    struct text text = {0};
    text_put(&text, "color([1, 0.5, 0, %s]) {\n", is_translucent ? "0.4" : "1");
    for (int i = 0; i < NUM_NESTED; i++) {
        const double r = i % 2 ? 7 + 0.004 * i : 9 - 0.004 * i;
        text_put(&text, "rotate([%.9g, %.9g, 0]) ", between(0, 9), i % 5 ? 0 : between(0, 90));
        text_put(&text, "translate([%.9g, 0, %.9g]) ", between(-0.1, 0.1), between(-0.1, 0.1));
        if (i % 3 == 0)
            text_put(&text, "sphere(r = %.9g);\n", 1.3 * r);
        else if (i % 3 == 1)
            text_put(&text, "cube([%.9g, %.9g, %.9g], center = true);\n", 2 * r, 1.9 * r, 2.1 * r);
        else
            text_put(&text, "cylinder(h = %.9g, r = %.9g, center = true);\n", 2.2 * r, r);
    }
    text_put(&text, "}\ncolor([0, 0, 1, 1]) cylinder(h = 26, r = 0.5);\n");
    return text.data;
}

/* An object of several solids; some are empty, some bite into each other's faces. */
static void put_part(struct text *text)
{
    const double a = between(0.3, 1.5), b = between(0.3, 1.5);
    switch ((int)between(0, 6)) {
    case 0:
        text_put(text, "intersection() { sphere(r = %.9g); cube(%.9g, center = true);", a, 2 * b);
        break;
    case 1:
        text_put(text, "difference() { cylinder(h = %.9g, r = %.9g); cylinder(h = %.9g, r = %.9g);",
                 a, b, a, 0.9 * b * between(0.2, 1.2));
        break;
    case 2:
        text_put(text,
                 "difference() { sphere(r = %.9g); translate([0, 0, %.9g]) difference() { "
                 "cube(%.9g, center = true); cylinder(h = 3, r = %.9g, center = true); }",
                 a, 0.5 * b, 2 * a, 0.4 * b);
        break;
    case 3:
        text_put(text,
                 "intersection() { cylinder(h = %.9g, r1 = %.9g, r2 = 0); union() { "
                 "cube([%.9g, 9, 9], center = true); cube([9, %.9g, 9], center = true); }",
                 2 * a, b, 0.4 * b, 0.3 * b);
        break;
    default:
        text_put(text, "difference() { cube(%.9g, center = true); sphere(r = %.9g);", a,
                 a * between(0.4, 0.8));
    }
    text_put(text, " }\n");
}

/* Small objects of several solids, most of them hidden, with single ones among them; some come
 * twice, some are translucent, and some large ones hide many. */
static char *make_parts_scene(void)
{
    struct text text = {0};
    for (int i = 0; i < NUM_PARTS; i++) {
        const size_t begin = text.num;
        if (i % 200 == 0)
            text_put(&text, "color([0, 1, 0, 0.5]) ");
        put_place(&text);
        if (i % 400 == 1)
            text_put(&text, "scale(4) ");
        if (i % 9 == 0)
            put_solid(&text);
        else
            put_part(&text);
        char copy[1024];
        const size_t length = text.num - begin;
        memcpy(copy, text.data + begin, length);
        if (i % 7 == 0)
            text_put(&text, "color([1, 0, 0]) %.*s", (int)length, copy);
    }
    return text.data;
}

static struct csgcast_view view_of(int i)
{
    static const double distances[NUM_VIEWS] = {90, 40, 25, 9, 3e4, 60};
    static const double fovs[NUM_VIEWS] = {0, 0, 70, 100, 0.05, 0};
    struct csgcast_view view = {.width = SIZE, .height = i == 5 ? SIZE / 2 : SIZE};
    view.camera = (struct csgcast_camera){.kind = CSGCAST_CAMERA_GIMBAL,
                                          .rotate = {40.0 + 31 * i, 0, 17.0 * i},
                                          .distance = distances[i],
                                          .fov = fovs[i]};
    if (i == 1)
        view.camera.projection = CSGCAST_ORTHOGRAPHIC;
    return view;
}

struct picture {
    float rgba[4 * PIXELS], z[PIXELS], normal[3 * PIXELS], id[PIXELS];
};

static struct picture pictures[2];

static bool draw(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                 struct csgcast_view *view, const char *variant, struct picture *picture,
                 struct csgcast_stats *stats)
{
    const struct csgcast_image image = {
        .rgba = picture->rgba, .z = picture->z, .normal = picture->normal, .id = picture->id};
    view->variant = variant;
    const bool ok = csgcast_render(renderer, scene, view, &image);
    csgcast_renderer_get_stats(renderer, stats);
    return ok;
}

static bool differs(const struct picture *a, const struct picture *b, int i, float max_depth)
{
    double normal = 0;
    float color = 0;
    for (int j = 0; j < 3; j++)
        normal += fabs((double)a->normal[3 * i + j] - (double)b->normal[3 * i + j]);
    for (int j = 0; j < 4; j++)
        color = fmaxf(color, fabsf(a->rgba[4 * i + j] - b->rgba[4 * i + j]));
    const bool same_depth =
        a->z[i] == b->z[i] || fabsf(a->z[i] - b->z[i]) <= max_depth * fabsf(b->z[i]);
    return a->id[i] != b->id[i] || !same_depth || !(normal <= MAX_NORMAL_ERROR) ||
           !(color <= MAX_COLOR_ERROR);
}

/* false: pictures differ, or nothing was drawn as a crowd. */
static bool check(struct csgcast_renderer *renderer, const struct csgcast_scene *scene, int index)
{
    struct csgcast_view view = view_of(index);
    struct csgcast_stats crowd, plain;
    if (!draw(renderer, scene, &view, NULL, &pictures[0], &crowd) ||
        !draw(renderer, scene, &view, "straight", &pictures[1], &plain))
        return false;
    int wrong = 0, hits = 0;
    for (int i = 0; i < view.width * view.height; i++) {
        hits += pictures[1].id[i] >= 0;
        if (!differs(&pictures[0], &pictures[1], i, index == AMONG ? MAX_DEPTH_ERROR : 0) ||
            wrong++)
            continue;
        printf("first at %d,%d: leaf %g and %g, distance %.9g and %.9g\n", i % SIZE, i / SIZE,
               (double)pictures[0].id[i], (double)pictures[1].id[i], (double)pictures[0].z[i],
               (double)pictures[1].z[i]);
    }
    printf("view %d: %d of %d pixels differ; %s, without crowds %s\n", index, wrong, hits,
           crowd.variants, plain.variants);
    return wrong == 0 && hits > 100 && (index == AMONG || strstr(crowd.variants, "single")) &&
           crowd.objects_drawn <= plain.objects_drawn;
}

/* Much is hidden: what is left out must be that. */
static bool check_hidden(struct csgcast_renderer *renderer, char *text)
{
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    bool ok = scene != NULL;
    for (int i = 0; i < NUM_VIEWS && ok; i++)
        ok = check(renderer, scene, i);
    csgcast_scene_destroy(scene);
    free(text);
    return ok;
}

int main(int argc, char **argv)
{
    if (argc != 3)
        return 2;
    state = strtoull(argv[2], NULL, 10);
    const struct csgcast_renderer_params params = {
        .backend = strcmp(argv[1], "egl") == 0 ? CSGCAST_BACKEND_EGL : CSGCAST_BACKEND_OSMESA};
    struct csgcast_renderer *renderer = csgcast_renderer_create(&params);
    int failed = !renderer || !check_hidden(renderer, make_dense_scene()) ||
                 !check_hidden(renderer, make_parts_scene());
    failed = failed || !check_hidden(renderer, make_nested_scene(false)) ||
             !check_hidden(renderer, make_nested_scene(true));
    char *text = make_scene();
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    failed |= !scene;
    for (int i = 0; i < NUM_VIEWS && !failed; i++)
        failed |= !check(renderer, scene, i);
    /* What turns translucent hides nothing any more. */
    const float glass[4] = {0, 1, 0, 0.3f};
    for (size_t i = 0; i < 20 && !failed; i++)
        failed |= !csgcast_scene_set_color(scene, 37 * i, glass);
    failed = failed || !check(renderer, scene, 0);
    csgcast_renderer_destroy(renderer);
    csgcast_scene_destroy(scene);
    free(text);
    puts(failed ? "FAILED" : "ok");
    return failed;
}
