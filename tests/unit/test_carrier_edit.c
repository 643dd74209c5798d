/* SPDX-License-Identifier: MIT */
/*
 * Carriers after edits are those of a scene that is loaded so: solids on a grid, of sizes that are
 * equal or nearly so, with the rounding of six digits and gaps about the tolerance, many of them
 * turned by angles that nearly agree, change one after the other. In half of the scenes some of
 * them are surfaces of triangles.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "carrier/carrier.h"
#include "check.h"
#include "common/random.h"
#include "csg/object.h"
#include "csg/scene.h"
#include "sharpness/sharpness.h"

#define NUM_LEAVES 120
#define NUM_EDITS 60
#define NUM_SCENES 12

static uint64_t state;

static double uniform(double lo, double hi)
{
    return csg_random_between(&state, lo, hi);
}

static int pick(int num)
{
    return (int)uniform(0, num);
}

/* What the file's rounding leaves of a number on the grid, or what lies just beside it. */
static double coordinate(int num)
{
    static const double aside[5] = {0, 0, 1e-6, 7e-6, 3e-5};
    const double value = pick(num) / 3.0 + aside[pick(5)] * (pick(3) - 1);
    char text[32];
    snprintf(text, sizeof text, "%.6g", value);
    return atof(text);
}

static void random_matrix(bool may_vanish, double matrix[16])
{
    static const double turns[4][2] = {{1, 0}, {0, 1}, {0.707107, 0.707107}, {0.7071, 0.707113}};
    const double *turn = turns[pick(4)];
    const double values[16] = {
        turn[0], -turn[1], 0, coordinate(12), turn[1], turn[0], 0, coordinate(12),
        0,       0,        1, coordinate(6),  0,       0,       0, 1};
    memcpy(matrix, values, sizeof values);
    if (pick(20) == 0)
        matrix[3] += 1000; /* beyond the index */
    if (may_vanish && pick(20) == 0)
        memset(matrix, 0, 3 * sizeof *matrix); /* nothing is left */
}

static void random_parameters(int kind, bool may_vanish, char *text, size_t size)
{
    if (kind == 3) /* no parameters that an edit can set: with its polygon, a surface */
        snprintf(text, size, "height = %g, twist = 45, slices = 8) square([%g, %g]",
                 (1 + pick(3)) / 3.0, 0.3 + coordinate(4), 0.3 + coordinate(2));
    else if (kind == 0)
        snprintf(text, size, "size = [%g, %g, %g]", 0.3 + coordinate(4), 0.3 + coordinate(4),
                 pick(15) ? 1 : 40.0);
    else if (kind == 1)
        snprintf(text, size, "h = %g, r = %g, $fn = %d", 0.3 + coordinate(4), (1 + pick(2)) / 3.0,
                 pick(2) ? 0 : 3 + pick(4));
    else
        snprintf(text, size, "r = %g", may_vanish && pick(8) == 0 ? 0 : 1.0 / 3 + coordinate(2));
}

static const char *const kinds[4] = {"cube", "cylinder", "sphere", "linear_extrude"};

static struct csgcast_scene *random_scene(bool has_surfaces, int *leaf_kinds)
{
    static char text[256 * NUM_LEAVES];
    static const char *const groups[2] = {"union", "difference"};
    size_t num = (size_t)snprintf(text, sizeof text, "%s() { cube([4, 5, 2]);\n", groups[pick(2)]);
    leaf_kinds[0] = 0;
    for (int i = 1; i < NUM_LEAVES; i++) {
        char parameters[96];
        double m[16];
        leaf_kinds[i] = has_surfaces && pick(8) == 0 ? 3 : pick(3);
        random_parameters(leaf_kinds[i], false, parameters, sizeof parameters);
        random_matrix(false, m);
        num += (size_t)snprintf(text + num, sizeof text - num,
                                "multmatrix([[%.6g,%.6g,0,%.6g],[%.6g,%.6g,0,%.6g],[0,0,1,%.6g],"
                                "[0,0,0,1]]) %s(%s);\n",
                                m[0], m[1], m[3], m[4], m[5], m[7], m[11], kinds[leaf_kinds[i]],
                                parameters);
    }
    snprintf(text + num, sizeof text - num, "}");
    return csgcast_scene_parse(text, strlen(text), NULL);
}

static bool is_own(const struct csg_carriers *carriers, uint32_t leaf, uint32_t face)
{
    const uint32_t begin = carriers->face_begin[leaf];
    return begin == carriers->face_begin[leaf + 1] ||
           carriers->faces[begin + face].carrier == CSG_NO_CARRIER;
}

/* Of a surface the same faces have carriers. */
static bool is_same(const struct csgcast_scene *a, const struct csgcast_scene *b, uint32_t leaf,
                    uint32_t face)
{
    struct csg_map inverse = csg_map_identity;
    bool flipped[2];
    csg_map_invert(&a->leaves[leaf].shape.frame, &inverse);
    const struct csg_plane x = csg_carrier_of_face(a, leaf, face, &inverse, &flipped[0]);
    const struct csg_plane y = csg_carrier_of_face(b, leaf, face, &inverse, &flipped[1]);
    return memcmp(&x, &y, sizeof x) == 0 && flipped[0] == flipped[1] &&
           is_own(a->carriers, leaf, face) == is_own(b->carriers, leaf, face);
}

static bool is_same_quadric(const struct csgcast_scene *scene, const struct csg_carriers *a,
                            const struct csg_face *x, const struct csg_carriers *b,
                            const struct csg_face *y)
{
    if (x->carrier == CSG_NO_CARRIER || y->carrier == CSG_NO_CARRIER)
        return x->carrier == y->carrier;
    return a->quadric_leaves[x->carrier] == b->quadric_leaves[y->carrier] &&
           x->flipped == y->flipped &&
           memcmp(csg_carrier_quadric_box(scene, a, x->carrier),
                  csg_carrier_quadric_box(scene, b, y->carrier), sizeof(struct csg_box)) == 0;
}

/* Whose faces mean something. */
static void mark_drawn(const struct csgcast_scene *scene, bool *drawn)
{
    memset(drawn, 0, NUM_LEAVES * sizeof *drawn);
    for (size_t i = 0; i < scene->objects->num; i++) {
        const struct csg_object *object = &scene->objects->data[i];
        const struct csg_node *nodes = scene->trees[object->layer].data;
        for (uint32_t j = object->begin; j < object->end; j++)
            if (nodes[j].op == CSG_LEAF && !nodes[j].spare)
                drawn[nodes[j].leaf] = true;
    }
}

/* Planes of carriers differ, so faces with one plane have one carrier. What follows of them. */
static void compare(const struct csgcast_scene *scene, int edit)
{
    const struct csg_carriers *a = scene->carriers;
    struct csg_carriers *b = csg_carriers_create(scene, false);
    struct csgcast_scene anew = *scene;
    bool drawn[NUM_LEAVES];
    CHECK(b != NULL, "out of memory");
    anew.carriers = b;
    mark_drawn(scene, drawn);
    for (uint32_t leaf = 0; leaf < scene->num_leaves && b; leaf++) {
        if (!drawn[leaf])
            continue;
        for (uint32_t i = 0; i < csg_num_faces(scene, leaf); i++)
            CHECK(is_same(scene, &anew, leaf, i), "edit %d: leaf %u face %u", edit, (unsigned)leaf,
                  (unsigned)i);
        CHECK(is_same_quadric(scene, a, &a->quadric_faces[leaf], b, &b->quadric_faces[leaf]),
              "edit %d: quadric of leaf %u", edit, (unsigned)leaf);
        CHECK(a->sheets[leaf] == b->sheets[leaf], "edit %d: leaf %u", edit, (unsigned)leaf);
    }
    CHECK(b && a->num_shared == b->num_shared, "edit %d: %zu faces share, not %zu", edit,
          a->num_shared, b->num_shared);
    CHECK(b && a->num_planes - a->num_unused_planes == b->num_planes &&
              a->num_quadrics - a->num_unused_quadrics == b->num_quadrics,
          "edit %d: %zu planes and %zu quadrics, not %zu and %zu", edit,
          a->num_planes - a->num_unused_planes, a->num_quadrics - a->num_unused_quadrics,
          b->num_planes, b->num_quadrics);
    CHECK(b && a->num_own == b->num_own, "edit %d: %zu own planes, not %zu", edit, a->num_own,
          b->num_own);
    csg_carriers_destroy(b);
    anew = *scene;
    anew.sharpness = csg_sharpness_create(scene, NULL);
    for (size_t i = 0; i < scene->objects->num && anew.sharpness; i++) {
        const struct csg_sharpness x = csg_sharpness_of(scene, i), y = csg_sharpness_of(&anew, i);
        CHECK(memcmp(&x, &y, sizeof x) == 0, "edit %d: object %zu is as fine as another", edit, i);
    }
    CHECK(anew.sharpness != NULL, "out of memory");
    csg_sharpness_destroy(anew.sharpness);
}

static size_t num_kept;

static void check(uint64_t seed)
{
    int leaf_kinds[NUM_LEAVES];
    state = seed;
    struct csgcast_scene *scene = random_scene(seed % 2 == 0, leaf_kinds);
    CHECK(scene != NULL, "seed %d: the scene is wrong", (int)seed);
    for (int i = 0; i < NUM_EDITS && scene && num_failed == 0; i++) {
        struct csgcast_edit edits[3] = {{0}};
        char parameters[3][96];
        double matrices[3][16];
        const size_t num = 1 + (size_t)pick(3);
        for (size_t j = 0; j < num; j++) {
            edits[j].leaf = (size_t)pick(NUM_LEAVES);
            random_matrix(true, matrices[j]);
            random_parameters(leaf_kinds[edits[j].leaf], true, parameters[j], sizeof parameters[j]);
            edits[j].matrix = pick(3) ? matrices[j] : NULL;
            edits[j].parameters = leaf_kinds[edits[j].leaf] != 3 && pick(2) ? parameters[j] : NULL;
        }
        CHECK(csgcast_scene_edit(scene, edits, num), "seed %d: edit %d", (int)seed, i);
        num_kept += scene->carriers->kept != NULL;
        compare(scene, i);
    }
    csgcast_scene_destroy(scene);
}

static void move(struct csgcast_scene *scene, size_t leaf, double x, double z, int edit)
{
    const double matrix[16] = {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, z, 0, 0, 0, 1};
    CHECK(csgcast_scene_set_matrix(scene, leaf, matrix), "edit %d", edit);
    compare(scene, edit);
}

/* A solid whose top stays in its plane comes to where a larger one's, which is turned a little, is
 * within the rounding of it. */
static void check_moved_along(void)
{
    static const char text[] =
        "multmatrix([[1,0,-1e-05,0],[0,1,0,0],[1e-05,0,1,0],[0,0,0,1]]) cube([100.001,100,1]);\n"
        "cube([2,2,1]); multmatrix([[1,0,0,300],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) cube(3);";
    static const double places[] = {90, 91, 0.5, 92, 0.5};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    for (int i = 0; i < 5; i++)
        move(scene, 1, places[i], 0, i);
    CHECK(scene->carriers->kept != NULL, "the edits were not followed");
    csgcast_scene_destroy(scene);
}

/* What is near to a surface depends on how the text rounds other solids, however far they are. */
static void check_far_rounding(void)
{
    static const char text[] =
        "linear_extrude(height = 2, twist = 45, slices = 8) square([4, 3]);\n"
        "cube(1); translate([50, 0, 0]) cube([3.00001, 3, 3]);";
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    move(scene, 1, 1, 2.000003, 0);
    move(scene, 1, 1.5, 2.000003, 1);
    CHECK(csgcast_scene_set_parameters(scene, 2, "3"), "the parameters are not set");
    compare(scene, 2);
    move(scene, 1, 1, 2.000003, 3);
    csgcast_scene_destroy(scene);
}

/* test_carrier_edit [SCENES] */
int main(int argc, char **argv)
{
    const int num_scenes = argc > 1 ? atoi(argv[1]) : NUM_SCENES;
    for (int seed = 1; seed <= num_scenes; seed++)
        check((uint64_t)seed);
    check_moved_along();
    check_far_rounding();
    CHECK(num_kept > (size_t)(num_scenes * NUM_EDITS / 2), "only %zu edits were followed",
          num_kept);
    return num_failed != 0;
}
