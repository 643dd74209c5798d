/* SPDX-License-Identifier: MIT */

/* What several convex solids have in common is one literal of a tile's program, and only that. */

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "csg/program.h"
#include "csg/scene.h"

/* What is taken from a cube, and the steps of the whole: solids + and complements -, with m where
 * the next step narrows the same literal, p where what was before goes to the stack; o combines
 * with that. */
struct example {
    const char *solids, *steps;
};

static const struct example examples[] = {
    {"intersection() { sphere(4); cube(5); }", "+ -m -"},
    {"intersection() { sphere(4); cube(5); cylinder(r = 2, h = 9); }", "+ -m -m -"},
    {"intersection() { sphere(4); cube(5); } sphere(3);", "+ - -m -"},
    /* One solid is not convex. */
    {"intersection() { sphere(4); quadric(coefficients = [1, 0, 0, 0, 1, 0, 0, -1, 0, -1]); }",
     "+ -p - o"},
    /* A solid and a complement. */
    {"difference() { sphere(4); cube(5); }", "+ -p + o"},
    {"difference() { sphere(4); intersection() { sphere(3); cube(5); } }", "+ -p +m + o"},
};

/* The same letters of a program's steps. */
static void write_steps(const struct csg_program *program, char *text)
{
    for (size_t i = 0; i < program->num; i++) {
        const uint32_t flags = program->data[i].flags;
        if (i > 0)
            *text++ = ' ';
        *text++ = flags & CSG_RECORD_POP ? 'o' : flags & CSG_RECORD_NEGATED ? '-' : '+';
        if (flags & CSG_RECORD_PUSH)
            *text++ = 'p';
        if (flags & CSG_RECORD_MORE)
            *text++ = 'm';
    }
    *text = '\0';
}

static void check_example(const struct example *example)
{
    char text[512], steps[64];
    snprintf(text, sizeof text, "difference() { cube(8, center = true); %s }", example->solids);
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    struct csg_program_room room = {.products = true};
    struct csg_program program = {0};
    const bool ok = scene && csg_program_append(&room, &program, scene, &scene->trees[0], 0) &&
                    program.num < sizeof steps / 4;
    CHECK(ok, "%s", text);
    if (ok) {
        write_steps(&program, steps);
        CHECK(strcmp(steps, example->steps) == 0, "%s: %s", example->solids, steps);
    }
    free(program.data);
    csg_program_room_finish(&room);
    csgcast_scene_destroy(scene);
}

int main(void)
{
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++)
        check_example(&examples[i]);
    return num_failed > 0;
}
