/* SPDX-License-Identifier: MIT */
/* What extruded polygons that something is cut from become: a few are convex pieces, each of a
 * crowd is one surface. */
#include "plane/extrude.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "csgcast/csgcast.h"
#include "messages.h"

/* A star of so many corners is so many pieces. */
enum { NUM_CORNERS = 80, NUM_PIECES = 52, MAX_TEXT = 1 << 18 };

/* Returns the end of the text. */
static char *put_polygon(char *at)
{
    at += sprintf(at, "polygon([");
    for (int i = 0; i < NUM_CORNERS; i++) {
        const double a = 2 * acos(-1) * i / NUM_CORNERS, r = i % 2 ? 10 : 8;
        at += sprintf(at, "%s[%.9g, %.9g]", i ? ", " : "", r * cos(a), r * sin(a));
    }
    return at + sprintf(at, "]);");
}

static char *put_star(char *at, int place)
{
    at += sprintf(at, "translate([%d, 0, 0]) difference() { linear_extrude(height = %g) ",
                  30 * place, 4 + 0.01 * place);
    at = put_polygon(at);
    return at + sprintf(at, " cylinder(r = 4, h = 20, center = true); }\n");
}

static void check_stars(int num, bool are_surfaces)
{
    static char text[MAX_TEXT];
    char *end = text;
    struct csgcast_scene_info info = {0};
    for (int i = 0; i < num; i++)
        end = put_star(end, i);
    struct csgcast_scene *scene = csgcast_scene_parse(text, (size_t)(end - text), NULL);
    CHECK(scene, "%d stars", num);
    csgcast_scene_get_info(scene, &info);
    CHECK((info.num_leaves == (size_t)(2 * num)) == are_surfaces, "%d stars are %zu leaves", num,
          info.num_leaves);
    csgcast_scene_destroy(scene);
}

/* One whose height an edit sets is what the changed text would make of it. */
static void check_edit(void)
{
    static char text[MAX_TEXT];
    char *end = text;
    for (int i = 0; i < CSG_EXTRUDE_CROWD; i++)
        end = put_star(end, i);
    struct csgcast_scene *scene = csgcast_scene_parse(text, (size_t)(end - text), NULL);
    const struct csgcast_edit edit = {.leaf = 2, .parameters = "height = 9"};
    CHECK(scene && csgcast_scene_edit(scene, &edit, 1), "an edit");
    CHECK(csgcast_scene_num_leaves(scene) == 2 * CSG_EXTRUDE_CROWD, "%zu leaves after an edit",
          csgcast_scene_num_leaves(scene));
    csgcast_scene_destroy(scene);
}

/* One extrusion of all stars. */
static void check_drawing(int num, size_t num_leaves)
{
    static char text[MAX_TEXT];
    char *end = text;
    struct csgcast_scene_info info = {0};
    end += sprintf(end, "difference() { cube([%d, 30, 2]); linear_extrude(height = 4) {", 30 * num);
    for (int i = 0; i < num; i++) {
        end += sprintf(end, "translate([%d, 15]) ", 30 * i + 15);
        end = put_polygon(end);
    }
    end += sprintf(end, "} }");
    struct csgcast_scene *scene = csgcast_scene_parse(text, (size_t)(end - text), NULL);
    CHECK(scene, "a drawing of %d stars", num);
    csgcast_scene_get_info(scene, &info);
    CHECK(info.num_leaves == num_leaves + 1, "a drawing of %d stars is %zu leaves", num,
          info.num_leaves - 1);
    csgcast_scene_destroy(scene);
}

/* What nobody can make is an error that says how much it is, without asking openscad; in an edit the
 * scene stays. */
static void check_refused(const char *node, const char *fine, const char *absurd, const char *said)
{
    char text[256];
    struct messages messages = {0};
    const struct csgcast_scene_params params = {.facets = CSGCAST_FACETS_AS_WRITTEN,
                                                .openscad = "/nowhere/openscad",
                                                .log = keep_message,
                                                .log_user = &messages};
    snprintf(text, sizeof text, node, absurd);
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    CHECK(!scene && strstr(messages.last, said) && !strstr(messages.last, "nowhere"), "%s: %s",
          text, messages.last);
    csgcast_scene_destroy(scene);
    snprintf(text, sizeof text, node, fine);
    scene = csgcast_scene_parse(text, strlen(text), &params);
    CHECK(scene && csgcast_scene_num_leaves(scene) == 1, "%s: %s", text, messages.last);
    messages.last[0] = '\0';
    const struct csgcast_edit edit = {.leaf = 0, .parameters = absurd};
    CHECK(!csgcast_scene_edit(scene, &edit, 1) && strstr(messages.last, said), "%s to %s: %s", text,
          absurd, messages.last);
    CHECK(csgcast_scene_num_leaves(scene) == 1, "%s after a refused edit", text);
    csgcast_scene_destroy(scene);
}

static void check_too_fine(const char *operand)
{
    char text[256];
    struct messages messages = {0};
    const struct csgcast_scene_params params = {.log = keep_message, .log_user = &messages};
    snprintf(text, sizeof text, "hull() { %s cube(9); }", operand);
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    CHECK(!scene && strstr(messages.last, "<memory>:1:10:") && strstr(messages.last, "10000"),
          "%s: %s", text, messages.last);
    csgcast_scene_destroy(scene);
}

int main(void)
{
    enum { NUM_ALONE = CSG_EXTRUDE_CROWD_PIECES / NUM_PIECES };
    check_stars(1, false);
    check_stars(CSG_EXTRUDE_CROWD - 1, false);
    check_stars(CSG_EXTRUDE_CROWD, true);
    check_edit();
    check_drawing(NUM_ALONE, (size_t)NUM_ALONE * NUM_PIECES);
    check_drawing(NUM_ALONE + 1, NUM_ALONE + 1);
    check_refused("linear_extrude(%s) square(3);", "height = 5, twist = 90",
                  "height = 5, twist = 1e9", "faces, the most is");
    check_refused("linear_extrude(%s) square(3);", "height = 5, twist = 90, slices = 9",
                  "height = 5, twist = 90, slices = 1e9", "8e+09 faces, the most is 5000000");
    check_refused("linear_extrude(%s) square(3);", "height = 5, scale = [2, 1], $fn = 9",
                  "height = 5, scale = [2, 1], $fn = 1e7", "faces, the most is");
    check_refused("rotate_extrude(%s) translate([5, 0]) circle(r = 2, $fn = 8);", "$fn = 6",
                  "$fn = 1e9", "its 1000000000 segments have 1.6e+10 faces");
    check_too_fine("cylinder(h = 5, r = 3, $fn = 1e5);");
    check_too_fine("rotate_extrude($fn = 1e5) translate([5, 0]) square(2);");
    return num_failed != 0;
}
