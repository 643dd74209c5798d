/* SPDX-License-Identifier: MIT */
/*
 * Which structures of a scene have programs of their own: those met most often, wherever they stand
 * in the text, whatever their sizes and places. Single solids take no room among them where crowds
 * hold them; a hexagonal prism is one structure more.
 */
#include "csg/structure.h"

#include <stdio.h>
#include <string.h>

#include "check.h"
#include "csg/scene.h"

enum { NUM_RARE = 12, NUM_COMMON = 7, NUM_TWICE = 2, MAX_TEXT = 1 << 14 };

/* A cube less so many spheres, away from all others. */
static void add_object(char *text, int place, int num_spheres, double size)
{
    char *at = text + strlen(text);
    at += sprintf(at, "translate([%d, 0, 0]) difference() { cube(%g);", 20 * place, size);
    for (int i = 0; i < num_spheres; i++)
        at += sprintf(at, "translate([%g, 0, 0]) sphere(%g);", i * size / num_spheres, size / 9);
    sprintf(at, "}\n");
}

static struct csgcast_scene *load(const char *text)
{
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    CHECK(scene != NULL, "%.80s", text);
    return scene;
}

/* Objects of structures that are met once, then of others that are met twice. */
static void check_common(void)
{
    static char text[MAX_TEXT];
    int place = 0;
    text[0] = '\0';
    for (int i = 0; i < NUM_RARE; i++)
        add_object(text, place++, 1 + i, 10);
    for (int i = 0; i < NUM_TWICE * NUM_COMMON; i++)
        add_object(text, place++, 1 + NUM_RARE + i % NUM_COMMON - NUM_COMMON, 8 + i % 3);
    sprintf(text + strlen(text), "translate([%d, 0, 0]) sphere(3);", 20 * place);
    struct csgcast_scene *scene = load(text);
    const size_t num = scene ? scene->objects->num : 0;
    CHECK(num == NUM_RARE + NUM_TWICE * NUM_COMMON + 1, "%zu objects", num);
    size_t num_common = 0;
    for (size_t i = 0; i < num; i++) {
        const bool is_common = csg_plan_is_common(scene->plan, i);
        num_common += i < NUM_RARE && is_common;
        CHECK(is_common || i < NUM_RARE - NUM_COMMON, "object %zu has no program of its own", i);
    }
    CHECK(num_common == CSG_MAX_STRAIGHT_PROGRAMS, "%zu structures have programs", num_common);
    csgcast_scene_destroy(scene);
}

/* So many prisms beside structures that take all the room, each of them met twice. */
static void check_prisms(int num_prisms, bool wanted)
{
    static char text[MAX_TEXT];
    int place = 0;
    text[0] = '\0';
    for (int i = 0; i < NUM_TWICE * CSG_MAX_STRAIGHT_PROGRAMS; i++)
        add_object(text, place++, 1 + i % CSG_MAX_STRAIGHT_PROGRAMS, 10);
    for (int i = 0; i < num_prisms; i++)
        sprintf(text + strlen(text), "translate([%d, 0, 0]) cylinder(h = 9, r = 4, $fn = 6);\n",
                20 * place++);
    struct csgcast_scene *scene = load(text);
    size_t num_programs = 0;
    for (size_t i = 0; i < CSG_PLAN_MAX_STRUCTURES; i++)
        num_programs += scene->plan->is_common[i];
    CHECK(num_programs == CSG_MAX_STRAIGHT_PROGRAMS, "%zu programs", num_programs);
    CHECK(csg_plan_is_common(scene->plan, scene->objects->num - 1) == wanted,
          "%d prisms: program of their own", num_prisms);
    csgcast_scene_destroy(scene);
}

/* The order of the leaves in the text decides which face shows where two coincide. */
static void check_order(void)
{
    struct csgcast_scene *scene = load(
        "difference() { cube(9); union() { sphere(2); intersection() { cube(5); sphere(4); } } }"
        "translate([20, 0, 0])"
        "difference() { cube(9); union() { intersection() { cube(5); sphere(4); } sphere(2); } }");
    const struct csg_plan *plan = scene->plan;
    CHECK(scene->objects->num == 2 && plan->structures[0] != plan->structures[1],
          "two structures count as one");
    csgcast_scene_destroy(scene);
}

int main(void)
{
    check_common();
    check_prisms(1, false);
    check_prisms(NUM_TWICE + 1, true);
    check_order();
    return num_failed != 0;
}
