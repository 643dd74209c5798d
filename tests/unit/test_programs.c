/* SPDX-License-Identifier: MIT */
/*
 * When programs are compiled: of a fixed scene few with the first picture and the others with those
 * after it, of one that may be edited all with the first. A part of which there are many has its
 * program at once. Where a view moves a little, colours go on being drawn with or without a pass of
 * their own. A renderer that draws ever other scenes does not keep all their programs, and takes none
 * for the one before it.
 */
#include <math.h>
#include <string.h>

#include "check.h"
#include "csg/scene.h"
#include "csgcast/csgcast.h"

enum { SIZE = 512, FEW = 2, ENOUGH = 40 };

static const char text[] = "difference() { cube([20, 20, 20], center = true); sphere(r = 13);"
                           " cylinder(h = 30, r1 = 6, r2 = 6, center = true);"
                           " multmatrix([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])"
                           "  cylinder(h = 30, r1 = 6, r2 = 6, center = true);"
                           " multmatrix([[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]])"
                           "  cylinder(h = 30, r1 = 6, r2 = 6, center = true); }";

static unsigned char first[4 * SIZE * SIZE], later[4 * SIZE * SIZE];

/* The number of programs that there are then. */
static size_t draw_view(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                        struct csgcast_view view, unsigned char *rgba8)
{
    struct csgcast_stats stats;
    view.width = view.height = SIZE;
    CHECK(csgcast_render(renderer, scene, &view, &(struct csgcast_image){.rgba8 = rgba8}),
          "no picture");
    csgcast_renderer_get_stats(renderer, &stats);
    return stats.programs;
}

static size_t draw(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                   unsigned char *rgba8)
{
    return draw_view(renderer, scene, (struct csgcast_view){.width = SIZE}, rgba8);
}

static struct csgcast_scene *parse_text(const char *csg, bool fixed)
{
    struct csgcast_scene *scene =
        csgcast_scene_parse(csg, strlen(csg), &(struct csgcast_scene_params){.fixed = fixed});
    CHECK(scene, "no scene: %s", csg);
    return scene;
}

static struct csgcast_scene *parse(bool fixed)
{
    return parse_text(text, fixed);
}

/* Pictures until one compiles nothing; the number of programs then. */
static size_t settle(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                     size_t programs)
{
    size_t before = 0;
    for (int i = 0; i < ENOUGH && programs > before; i++) {
        before = programs;
        programs = draw(renderer, scene, later);
        CHECK(memcmp(first, later, sizeof first) == 0, "picture %d is another one", i + 1);
    }
    CHECK(programs == before, "%d pictures, and the next one compiles again", ENOUGH);
    return programs;
}

static void check_fixed(void)
{
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    struct csgcast_scene *scene = parse(true);
    const size_t few = draw(renderer, scene, first), all = settle(renderer, scene, few);
    CHECK(few <= FEW, "the first picture compiled %zu programs", few);
    CHECK(all > few, "later pictures compiled none");
    csgcast_scene_destroy(scene);
    scene = parse(true);
    CHECK(draw(renderer, scene, later) == all, "another scene of the same kind compiled some");
    csgcast_scene_destroy(scene);
    csgcast_renderer_destroy(renderer);
}

/* One part, again and again: its program alone draws the first picture. */
static void check_copies(void)
{
    enum { NUM = 100 };
    static char parts[256 * NUM];
    for (int i = 0; i < NUM; i++) {
        const size_t length = strlen(parts);
        snprintf(parts + length, sizeof parts - length,
                 "multmatrix([[1, 0, 0, %d], [0, 1, 0, %d], [0, 0, 1, 0], [0, 0, 0, 1]])"
                 " difference() { cube([10, 10, 4]); multmatrix([[1, 0, 0, 5], [0, 1, 0, 5],"
                 " [0, 0, 1, -1], [0, 0, 0, 1]]) cylinder(h = 6, r1 = 2, r2 = 4); }",
                 12 * (i % 10), 12 * (i / 10));
    }
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    struct csgcast_scene *scene = parse_text(parts, true);
    const size_t few = draw(renderer, scene, first);
    CHECK(few == 1, "the first picture of copies compiled %zu programs", few);
    CHECK(settle(renderer, scene, few) == few, "later pictures of copies compiled some");
    csgcast_scene_destroy(scene);
    csgcast_renderer_destroy(renderer);
}

static void check_edited(void)
{
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    struct csgcast_scene *scene = parse(false);
    const size_t all = draw(renderer, scene, first);
    CHECK(settle(renderer, scene, all) == all, "a picture after the first compiled");
    csgcast_scene_destroy(scene);
    csgcast_renderer_destroy(renderer);
}

/* A cube less what balls have in common with cylinders that lie in them. */
static struct csgcast_scene *parse_bites(void)
{
    char bites[4096] = "difference() { cube([20, 20, 20], center = true);";
    for (int i = 0; i < 8; i++) {
        const size_t length = strlen(bites);
        const double turn = 2.4 * i, z = 12 - 1.5 * i, r = sqrt(144 - z * z);
        snprintf(bites + length, sizeof bites - length,
                 "multmatrix([[%g, %g, 0, %g], [%g, %g, 0, %g], [0, 0, 1, %g], [0, 0, 0, 1]])"
                 " intersection() { sphere(r = 4);"
                 " multmatrix([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])"
                 "  cylinder(h = 10, r1 = 2.5, r2 = 2.5, center = true); }",
                 cos(turn), -sin(turn), r * cos(turn), sin(turn), cos(turn), r * sin(turn), z);
    }
    const size_t length = strlen(bites);
    snprintf(bites + length, sizeof bites - length, "}");
    return parse_text(bites, false);
}

/* Views of a scene that may be edited ask for other chains, and get those that there are. */
static void check_orbit(void)
{
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    struct csgcast_scene *scene = parse_bites();
    size_t all = 0;
    for (int turn = 0; turn < 360; turn += 9) {
        const double tilt = turn == 0 ? 55 : 35;
        const struct csgcast_camera camera = {
            .kind = CSGCAST_CAMERA_GIMBAL, .rotate = {tilt, 0, turn}, .distance = 85};
        const size_t programs =
            draw_view(renderer, scene, (struct csgcast_view){.camera = camera}, later);
        all = turn == 0 ? programs : all;
        CHECK(programs == all, "turned by %d it compiled", turn);
    }
    csgcast_scene_destroy(scene);
    csgcast_renderer_destroy(renderer);
}

/* Six slabs, each with a corner cut off, one above the other. */
static struct csgcast_scene *parse_slabs(void)
{
    char slabs[2048] = "";
    for (int i = 0; i < 6; i++) {
        const size_t length = strlen(slabs);
        snprintf(slabs + length, sizeof slabs - length,
                 "multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, %d], [0, 0, 0, 1]])"
                 " difference() { cube([20, 20, 1]); cube([5, 5, 1]); }",
                 3 * i);
    }
    return parse_text(slabs, true);
}

/* tilt: degrees, 0 from above, where the slabs cover each other. */
static size_t draw_tilted(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                          double tilt)
{
    const struct csgcast_camera camera = {.kind = CSGCAST_CAMERA_GIMBAL,
                                          .rotate = {tilt, 0, 0},
                                          .distance = 100,
                                          .projection = CSGCAST_ORTHOGRAPHIC,
                                          .viewall = true};
    return draw_view(renderer, scene,
                     (struct csgcast_view){.variant = "straight", .camera = camera}, later);
}

/* Fragments a pixel come to 2 between the first two tilts, and to a third of that or its threefold
 * at the last one. */
static void check_moved(double tilt, double near, double far)
{
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    struct csgcast_scene *scene = parse_slabs();
    const size_t programs = draw_tilted(renderer, scene, tilt);
    CHECK(draw_tilted(renderer, scene, near) == programs, "%g to %g degrees compiled", tilt, near);
    CHECK(draw_tilted(renderer, scene, far) > programs, "%g to %g degrees kept to it", near, far);
    csgcast_scene_destroy(scene);
    csgcast_renderer_destroy(renderer);
}

/* A small part whose structure the bits of number tell, and a cube far from it. */
static struct csgcast_scene *parse_part(int number)
{
    char part[1024] = "multmatrix([[1, 0, 0, 200], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])"
                      " cube(20); difference() { cube(20);";
    for (int bit = 0; bit < 6; bit++) {
        const size_t length = strlen(part);
        snprintf(part + length, sizeof part - length,
                 "multmatrix([[1, 0, 0, %d], [0, 1, 0, 0], [0, 0, 1, 19], [0, 0, 0, 1]]) %s;",
                 4 * bit, number >> bit & 1 ? "sphere(r = 3)" : "cube(2)");
    }
    strcat(part, "}");
    return parse_text(part, true);
}

/* The number of programs after two pictures, as the first takes none of a structure. */
static size_t draw_part(struct csgcast_renderer *renderer, int number, unsigned char *rgba8)
{
    struct csgcast_scene *scene = parse_part(number);
    draw(renderer, scene, rgba8);
    const size_t programs = draw(renderer, scene, rgba8);
    csgcast_scene_destroy(scene);
    return programs;
}

static size_t draw_parts(struct csgcast_renderer *renderer, int begin, int end)
{
    size_t programs = 0;
    for (int number = begin; number < end; number++)
        programs = draw_part(renderer, number, later);
    return programs;
}

static void check_many(void)
{
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    draw_part(renderer, 0, first);
    const size_t some = draw_parts(renderer, 1, 8);
    CHECK(draw_part(renderer, 0, later) == some, "of eight structures one was compiled twice");
    const size_t many = draw_parts(renderer, 8, 48);
    CHECK(many >= some + 40, "40 structures have %zu programs", many - some);
    CHECK(draw_part(renderer, 0, later) == many + 1, "all of 48 structures are kept");
    CHECK(memcmp(first, later, sizeof first) == 0, "compiled once more it is another picture");
    csgcast_renderer_destroy(renderer);
}

/* The programs that there are when text is drawn after a ball, at another place in memory or, as
 * where the ball is gone, at the same. */
static size_t draw_after_ball(bool same_place)
{
    struct csgcast_renderer *renderer = csgcast_renderer_create(NULL);
    struct csgcast_scene *before = parse_text("sphere(r = 3);", false), *scene = parse(false);
    draw(renderer, before, first);
    if (same_place) {
        const struct csgcast_scene moved = *before;
        *before = *scene;
        *scene = moved;
    }
    const size_t programs = draw(renderer, same_place ? before : scene, first);
    csgcast_scene_destroy(before);
    csgcast_scene_destroy(scene);
    csgcast_renderer_destroy(renderer);
    return programs;
}

static void check_reloaded(void)
{
    const size_t same = draw_after_ball(true), other = draw_after_ball(false);
    CHECK(same == other, "%zu programs at the place of the scene before, %zu elsewhere", same,
          other);
}

int main(void)
{
    check_reloaded();
    check_many();
    check_fixed();
    check_copies();
    check_edited();
    check_orbit();
    check_moved(78, 64, 0);
    check_moved(64, 78, 90);
    return num_failed != 0;
}
