/* SPDX-License-Identifier: MIT */
/*
 * What an object asks of numbers after edits is what is found of it anew, to the last bit: holes in
 * a block, beside one another and nearly parallel, are moved, turned and resized, most often the
 * one that asked for the most. Little of it is looked at again. What is found anew takes as long as
 * there are planes, however many of them have one normal.
 */
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "check.h"
#include "csg/object.h"
#include "csg/scene.h"
#include "dice.h"
#include "sharpness/surveyor.h"

#define NUM_HOLES 200
#define NUM_EDITS 150

static double sizes[NUM_HOLES + 1][3] = {{100, 100, 10}};

/* On a grid faces meet that are hardly turned against one another. */
static double coordinate(bool on_grid, double lo, double hi)
{
    const double x = random_between(lo, hi);
    return on_grid ? round(x) : x;
}

/* Turned by so little, or by more than what counts as parallel. */
static void random_matrix(bool on_grid, double m[16])
{
    const double turn = random_below(3) ? random_between(-2e-3, 2e-3) : random_between(-3, 3);
    const double c = cos(turn), s = sin(turn);
    const double end = on_grid ? 40 : 90;
    const double place[3] = {coordinate(on_grid, 5, end), coordinate(on_grid, 5, end),
                             random_between(0.5, 8)};
    const double rows[3][4] = {{c, -s, 0, place[0]}, {s, c, 0, place[1]}, {0, 0, 1, place[2]}};
    memcpy(m, rows, sizeof rows);
    memcpy(m + 12, (const double[4]){0, 0, 0, 1}, 4 * sizeof *m);
}

static void write_size(size_t leaf, char *text, size_t size)
{
    snprintf(text, size, "size = [%.6g, %.6g, %.6g]", sizes[leaf][0], sizes[leaf][1],
             sizes[leaf][2]);
}

static struct csgcast_scene *holes_scene(bool on_grid)
{
    static char text[NUM_HOLES * 400];
    int length = snprintf(text, sizeof text, "difference() { cube([100, 100, 10]);\n");
    for (size_t i = 1; i <= NUM_HOLES; i++) {
        double m[16];
        char cube[96];
        random_matrix(on_grid, m);
        for (int j = 0; j < 3; j++)
            sizes[i][j] = coordinate(on_grid, 1, 5);
        write_size(i, cube, sizeof cube);
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "multmatrix([[%.17g,%.17g,0,%.17g],[%.17g,%.17g,0,%.17g],"
                           "[0,0,1,%.17g],[0,0,0,1]]) cube(%s);\n",
                           m[0], m[1], m[3], m[4], m[5], m[7], m[11], cube);
    }
    snprintf(text + length, sizeof text - (size_t)length, "}\n");
    return csgcast_scene_parse(text, strlen(text), NULL);
}

static void compare(const struct csgcast_scene *scene, int edit)
{
    struct csgcast_scene anew = *scene;
    anew.sharpness = csg_sharpness_create(scene, NULL);
    CHECK(anew.sharpness != NULL, "out of memory");
    for (size_t i = 0; i < scene->objects->num && anew.sharpness; i++) {
        const struct csg_sharpness x = csg_sharpness_of(scene, i), y = csg_sharpness_of(&anew, i);
        CHECK(memcmp(&x, &y, sizeof x) == 0,
              "edit %d: gap %.17g, not %.17g; angle %.17g, not %.17g", edit, x.least[CSG_FINE_GAP],
              y.least[CSG_FINE_GAP], x.least[CSG_FINE_ANGLE], y.least[CSG_FINE_ANGLE]);
    }
    csg_sharpness_destroy(anew.sharpness);
}

/* Any, the block among them, or one that is named. */
static size_t choose_leaf(const struct csgcast_scene *scene)
{
    const struct csg_sharpness sharp = csg_sharpness_of(scene, 0);
    const unsigned kind = random_below(4);
    return kind == 0   ? random_below(NUM_HOLES + 1)
           : kind == 1 ? sharp.leaf[CSG_FINE_ANGLE]
                       : sharp.leaf[CSG_FINE_GAP];
}

/* One side of it is resized, or it is moved. */
static void edit(struct csgcast_scene *scene, bool on_grid, size_t leaf, int number)
{
    double matrix[16];
    char parameters[96];
    struct csgcast_edit change = {.leaf = leaf};
    random_matrix(on_grid, matrix);
    if (leaf != 0 && random_below(3) == 0) {
        change.matrix = matrix;
    } else {
        sizes[leaf][leaf ? random_below(3) : 2] =
            leaf ? coordinate(on_grid, 1, 5) : random_between(9, 11);
        write_size(leaf, parameters, sizeof parameters);
        change.parameters = parameters;
    }
    CHECK(csgcast_scene_edit(scene, &change, 1), "edit %d", number);
}

static void move_hole(struct csgcast_scene *scene, double x)
{
    const double place[16] = {1, 0, 0, x, 0, 1, 0, 20, 0, 0, 1, 5, 0, 0, 0, 1};
    CHECK(csgcast_scene_set_matrix(scene, 100, place), "a hole is moved");
}

/* Planes say nothing of thickness, so it tells which blocks have been looked at. */
static void check_recalled(struct csgcast_scene *scene)
{
    move_hole(scene, 15);
    struct csg_surveyor *surveyor = scene->sharpness->surveyor;
    CHECK(surveyor != NULL, "the edits were not followed");
    if (!surveyor)
        return;
    const struct csg_recall *recall = &surveyor->recall;
    size_t num_recalled = 0;
    for (size_t i = 0; i < recall->blocks.num; i++)
        recall->blocks.data[i].sharp.least[CSG_FINE_THICKNESS] = 0;
    move_hole(scene, 20);
    for (size_t i = 0; i < recall->blocks.num; i++)
        num_recalled += recall->blocks.data[i].sharp.least[CSG_FINE_THICKNESS] == 0;
    CHECK(num_recalled > 0 && num_recalled < recall->blocks.num, "%zu of %zu blocks are recalled",
          num_recalled, recall->blocks.num);
}

static void check(bool on_grid)
{
    struct csgcast_scene *scene = holes_scene(on_grid);
    CHECK(scene && scene->objects->num == 1, "the scene is wrong");
    for (int i = 0; i < NUM_EDITS && scene && num_failed == 0; i++) {
        edit(scene, on_grid, choose_leaf(scene), i);
        compare(scene, i);
    }
    if (scene && num_failed == 0)
        check_recalled(scene);
    csgcast_scene_destroy(scene);
}

/* Processor time, the least of three, that so many caps of holes in one plane take. */
static double seconds_of_caps(uint32_t num)
{
    const struct csg_plane plane = {csg_vec3(0, 0, 1), 1};
    const struct csg_ball ball = {csg_vec3(0, 0, 0), 1};
    struct csg_flats flats = {0};
    struct csg_recall recall = {0};
    double seconds = INFINITY;
    for (uint32_t i = 0; i < num; i++)
        CHECK(csg_flats_add(&flats, &plane, 0, i, true), "no memory");
    CHECK(csg_flats_sort(&flats, ball.center), "no memory");
    for (int i = 0; i < 3; i++) {
        recall.holds = false;
        CHECK(csg_recall_compare(&recall, &flats, NULL, &ball), "no memory");
        const clock_t start = clock();
        csg_recall_renew(&recall, &flats, NULL, 0, recall.blocks.num);
        seconds = fmin(seconds, (double)(clock() - start) / CLOCKS_PER_SEC);
    }
    csg_recall_finish(&recall);
    csg_flats_finish(&flats);
    return seconds;
}

/* Neither of them fits the processor's caches. */
static void test_caps(void)
{
    const double part = seconds_of_caps(100000), all = seconds_of_caps(400000);
    CHECK(all < 8 * part, "%g s, a quarter %g s", all, part);
}

int main(void)
{
    check(false);
    check(true);
    test_caps();
    return num_failed != 0;
}
