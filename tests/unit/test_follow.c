/* SPDX-License-Identifier: MIT */
/* Which edits leave what they do not touch where it was; that pictures are the same, tests/edit
 * checks. */
#include <csgcast/csgcast.h>
#include <string.h>

#include "check.h"
#include "csg/scene.h"
#include "scene/edits.h"

static struct csgcast_scene *parse(const char *text)
{
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    CHECK(scene && csgcast_scene_set_parameters(scene, 0, "1"),
          "no scene"); /* what is kept is there */
    return scene;
}

/* Whether an edit goes the short way. */
static void expect(struct csgcast_scene *scene, const struct csgcast_edit *edit, bool is_short)
{
    const struct csg_plan *plan = scene->plan;
    CHECK(csgcast_scene_edit(scene, edit, 1), "the edit fails");
    CHECK((scene->plan == plan) == is_short, "leaf %zu: %s is made anew", edit->leaf,
          is_short ? "all" : "not all");
}

static void check_ways(void)
{
    struct csgcast_scene *scene =
        parse("sphere(1);\ntranslate([5, 0, 0]) sphere(1);\n"
              "difference() { translate([9, 0, 0]) cube(3); translate([9, 0, 0]) sphere(1); }\n"
              "translate([0, 9, 0]) linear_extrude(1) polygon([[0, 0], [4, 0], [1, 1], [0, 4]]);");
    const double near[16] = {1, 0, 0, 5, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1};
    const double cutting[16] = {1, 0, 0, 9, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1};
    const float red[4] = {1, 0, 0, 1}, glass[4] = {1, 0, 0, 0.5f};
    expect(scene, &(struct csgcast_edit){.leaf = 1, .matrix = near}, true);
    expect(scene, &(struct csgcast_edit){.leaf = 1, .parameters = "1.5"}, true);
    expect(scene, &(struct csgcast_edit){.leaf = 1, .color = red}, true);
    expect(scene, &(struct csgcast_edit){.leaf = 1, .color = glass}, true);
    expect(scene, &(struct csgcast_edit){.leaf = 1, .parameters = "0"}, false); /* empty */
    expect(scene, &(struct csgcast_edit){.leaf = 1, .parameters = "2"}, false); /* and not */
    expect(scene, &(struct csgcast_edit){.leaf = 1, .parameters = "1"}, true);
    expect(scene, &(struct csgcast_edit){.leaf = 3, .matrix = cutting}, true);
    expect(scene, &(struct csgcast_edit){.leaf = 3, .matrix = near}, false); /* cuts nothing */
    expect(scene, &(struct csgcast_edit){.leaf = 2, .parameters = "4"}, true);
    expect(scene, &(struct csgcast_edit){.leaf = 4, .color = glass}, false); /* of two solids */
    csgcast_scene_destroy(scene);
}

/* Of objects that are one leaf each, quadrics have no boxes of their own. */
static void check_leaves(void)
{
    struct csgcast_scene *scene =
        parse("sphere(1);\ntranslate([5, 0, 0]) sphere(1);\ntranslate([9, 0, 0]) cube(3);");
    const double near[16] = {1, 0, 0, 5, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1};
    expect(scene, &(struct csgcast_edit){.leaf = 1, .matrix = near}, true);
    expect(scene, &(struct csgcast_edit){.leaf = 2, .parameters = "2"}, true);
    csgcast_scene_destroy(scene);
}

/* What is under % or # is looked at anew with all the rest; nothing else is. */
static void check_layers(void)
{
    struct csgcast_scene *scene =
        parse("sphere(1);\ntranslate([5, 0, 0]) sphere(1);\n%translate([9, 0, 0]) cube(3);\n"
              "#translate([0, 9, 0]) cube(3);");
    const double near[16] = {1, 0, 0, 5, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1};
    expect(scene, &(struct csgcast_edit){.leaf = 1, .matrix = near}, true);
    expect(scene, &(struct csgcast_edit){.leaf = 2, .parameters = "2"}, false);
    expect(scene, &(struct csgcast_edit){.leaf = 3, .parameters = "2"}, false);
    expect(scene, &(struct csgcast_edit){.leaf = 1, .parameters = "1.1"}, true);
    csgcast_scene_destroy(scene);
}

/* The statistics tell of the last edit, of a colour as well. */
static void check_time(void)
{
    static const float red[4] = {1, 0, 0, 1};
    struct csgcast_scene *scene = parse("sphere(1);\ntranslate([5, 0, 0]) sphere(1);");
    const double *matrix = (const double[16]){1, 0, 0, 3, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    scene->csg_ms = -1;
    CHECK(csgcast_scene_set_color(scene, 0, red) && scene->csg_ms >= 0, "a colour takes no time");
    scene->csg_ms = -1;
    CHECK(csgcast_scene_set_matrix(scene, 0, matrix) && scene->csg_ms >= 0,
          "a matrix takes no time");
    csgcast_scene_destroy(scene);
}

/* Other letters are other solids. */
static void check_fonts(void)
{
    struct csgcast_scene *scene = parse("linear_extrude(height = 1) text(\"a\");\ncube(1);");
    const struct csgcast_edit one = {.leaf = 0, .node = 1, .parameters = "\"ab\""};
    const struct csgcast_edit other = {.leaf = 0, .node = 1, .parameters = "\"abc\""};
    CHECK(csgcast_scene_edit(scene, &one, 1), "the edit fails");
    const struct csg_fonts *fonts = scene->edits->text.fonts;
    CHECK(csgcast_scene_edit(scene, &other, 1), "the edit fails");
    CHECK(fonts && scene->edits->text.fonts == fonts, "fonts do not stay open");
    csgcast_scene_destroy(scene);
}

int main(void)
{
    check_ways();
    check_time();
    check_fonts();
    check_leaves();
    check_layers();
    return num_failed != 0;
}
