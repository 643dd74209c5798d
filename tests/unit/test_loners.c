/* SPDX-License-Identifier: MIT */
/*
 * In a large scene most faces are alone, and those that are not are found all the same: cubes and
 * spheres with whole numbers as coordinates have as many planes and quadrics as there are different
 * numbers, and equal numbers have one carrier. Of turned cubes that is so however densely they
 * stand.
 */
#define DICE_SEED 5

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "carrier/builder.h"
#include "carrier/carrier.h"
#include "check.h"
#include "csg/scene.h"
#include "dice.h"

enum { NUM_CUBES = 4000, NUM_SPHERES = 3000, RANGE = 30000, ROOM = 1 << 21 };

/* Turned cubes of side 2. So many have another one on a face; its other four sides lie on theirs. */
enum { NUM_TURNED = 4000, NUM_PAIRS = 500, SHARED_BY_PAIR = 5 };

struct text {
    char *data;
    size_t num;
};

static void put(struct text *text, const unsigned at[3], const char *solid)
{
    text->num += (size_t)snprintf(text->data + text->num, ROOM - text->num,
                                  "multmatrix([[1,0,0,%u],[0,1,0,%u],[0,0,1,%u],[0,0,0,1]])%s\n",
                                  at[0], at[1], at[2], solid);
}

/* Faces of the cubes: used[axis][offset]. */
static size_t put_cubes(struct text *text, bool (*used)[RANGE + 100])
{
    size_t num = 0;
    for (int i = 0; i < NUM_CUBES; i++) {
        const unsigned size = 1 + random_below(99);
        unsigned at[3];
        char solid[32];
        snprintf(solid, sizeof solid, "cube(%u);", size);
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = random_below(RANGE);
            num += (used[axis][at[axis]] ? 0u : 1u) + (used[axis][at[axis] + size] ? 0u : 1u);
            used[axis][at[axis]] = used[axis][at[axis] + size] = true;
        }
        put(text, at, solid);
    }
    return num;
}

/* Every tenth is the one before it. */
static size_t put_spheres(struct text *text)
{
    unsigned last[4] = {0};
    size_t num = 0;
    for (int i = 0; i < NUM_SPHERES; i++) {
        char solid[32];
        if (i % 10 != 9) {
            for (int axis = 0; axis < 3; axis++)
                last[axis] = random_below(RANGE);
            last[3] = (unsigned)i; /* so that no other is as large */
            num++;
        }
        snprintf(solid, sizeof solid, "sphere(%u.5);", last[3]);
        put(text, last, solid);
    }
    return num;
}

static void put_turned_cube(struct text *text, double a, double b, const double at[3], int along)
{
    text->num += (size_t)snprintf(
        text->data + text->num, ROOM - text->num,
        "multmatrix([[%.6g,%.6g,%.6g,%.6g],[%.6g,%.6g,%.6g,%.6g],[0,%.6g,%.6g,%.6g],[0,0,0,1]])"
        "translate([%d,0,0])cube(2);\n",
        cos(a), -sin(a) * cos(b), sin(a) * sin(b), at[0], sin(a), cos(a) * cos(b), -cos(a) * sin(b),
        at[1], sin(b), cos(b), at[2], along);
}

/* In so little space that planes of one normal would hardly be alone, by the rounding of their six
 * digits, which counts as they are in one Boolean. */
static void put_turned(struct text *text)
{
    text->num = (size_t)snprintf(text->data, ROOM, "difference(){union(){\n");
    for (int i = 0; i < NUM_TURNED; i++) {
        const double a = random_between(0, 6), b = random_between(0, 6);
        double at[3];
        for (int k = 0; k < 3; k++)
            at[k] = random_between(10, 13);
        put_turned_cube(text, a, b, at, 0);
        if (i < NUM_PAIRS)
            put_turned_cube(text, a, b, at, 2);
    }
    text->num +=
        (size_t)snprintf(text->data + text->num, ROOM - text->num,
                         "}multmatrix([[1,0,0,12],[0,1,0,12],[0,0,1,12],[0,0,0,1]])cube(1);}");
}

static void check_planes(const struct csgcast_scene *scene, size_t num_planes)
{
    const struct csg_carriers *carriers = scene->carriers;
    CHECK(carriers->num_planes == num_planes, "%zu planes, of %zu", carriers->num_planes,
          num_planes);
    for (size_t leaf = 0; leaf < scene->num_leaves; leaf++)
        for (size_t i = 0; i < scene->leaves[leaf].shape.num_planes; i++) {
            const struct csg_face face = carriers->faces[carriers->face_begin[leaf] + i];
            const struct csg_plane own = scene->leaves[leaf].shape.planes[i];
            const struct csg_plane plane = carriers->planes[face.carrier];
            const double s = face.flipped ? -1 : 1;
            CHECK(fabs(own.offset - s * plane.offset) < 1e-6 &&
                      csg_dot(own.normal, plane.normal) * s > 1 - 1e-12,
                  "leaf %zu, plane %zu: not on its carrier", leaf, i);
        }
}

static size_t count(const uint8_t *loners, size_t num)
{
    size_t sum = 0;
    for (size_t i = 0; i < num; i++)
        sum += loners[i];
    return sum;
}

/* Of faces with a number of their own most are found to be alone, and others never. */
static void check_found(const struct csgcast_scene *scene, size_t num_quadrics)
{
    struct csg_carriers *carriers = calloc(1, sizeof *carriers);
    struct csg_carrier_builder builder = {.scene = scene, .carriers = carriers};
    const struct csg_loners *loners = &builder.loners;
    const bool ok =
        carriers && csg_carrier_rank_leaves(&builder) && csg_carrier_outline(&builder) &&
        csg_remote_find(&builder.remote, scene, builder.wanted, builder.largest_rounding) &&
        csg_carrier_start_index(&builder) && csg_carriers_allocate_faces(&builder) &&
        csg_loners_find(&builder.loners, &builder);
    CHECK(ok && loners->planes && loners->quadrics, "no loners are looked for");
    if (ok && loners->planes && loners->quadrics) {
        const size_t num_faces = carriers->face_begin[scene->num_leaves];
        const size_t planes = count(loners->planes, num_faces);
        const size_t quadrics = count(loners->quadrics, scene->num_leaves);
        CHECK(planes > num_faces / 2, "%zu lone planes of %zu", planes, num_faces);
        CHECK(num_quadrics == 0 || (quadrics > num_quadrics / 2 && quadrics < num_quadrics),
              "%zu lone quadrics of %zu", quadrics, num_quadrics);
    }
    csg_carrier_builder_finish(&builder);
    csg_carriers_destroy(carriers);
}

static void test_whole_numbers(struct text *text)
{
    static bool used[3][RANGE + 100];
    const size_t num_planes = put_cubes(text, used);
    const size_t num_quadrics = put_spheres(text);
    struct csgcast_scene *scene = csgcast_scene_parse(text->data, text->num, NULL);
    CHECK(scene, "the scene");
    if (scene) {
        check_planes(scene, num_planes);
        CHECK(scene->carriers->num_quadrics == num_quadrics, "%zu quadrics, of %zu",
              scene->carriers->num_quadrics, num_quadrics);
        check_found(scene, num_quadrics);
        CHECK(num_planes < 6 * NUM_CUBES - 1000, "the test tests little: %zu planes", num_planes);
    }
    csgcast_scene_destroy(scene);
}

static void test_turned(struct text *text)
{
    put_turned(text);
    struct csgcast_scene *scene = csgcast_scene_parse(text->data, text->num, NULL);
    CHECK(scene, "the turned cubes");
    if (scene) {
        check_planes(scene, 6 * (NUM_TURNED + NUM_PAIRS + 1) - SHARED_BY_PAIR * NUM_PAIRS);
        check_found(scene, 0);
    }
    csgcast_scene_destroy(scene);
}

int main(void)
{
    struct text text = {malloc(ROOM), 0};
    CHECK(text.data, "memory");
    if (!text.data)
        return 1;
    test_whole_numbers(&text);
    test_turned(&text);
    free(text.data);
    return num_failed > 0;
}
