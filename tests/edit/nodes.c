/* SPDX-License-Identifier: MIT */

/* Parameters of nodes that become several solids, and of what is in them. */

#include <stdio.h>
#include <string.h>

#include "bench.h"

enum { MAX_EDITS = 8 };

/* A scene with "%s" where the parameters stand, and what they become one after the other. */
struct node_case {
    const char *name, *text;
    size_t leaf, node; /* that are edited */
    const char *parameters[MAX_EDITS];
};

static const struct node_case cases[] = {
    {"linear_extrude",
     "cube(2); linear_extrude(%s) polygon([[0, 0], [6, 0], [2, 2], [0, 6]]); sphere(3);",
     1,
     0,
     {"height = 2", "height = 5", "height = 5, twist = 60, slices = 9", "height = 4, scale = 0.5",
      "3, scale = [0.5, 0.75]", "height = 2, center = true", "height = 1"}},
    {"taken away",
     "difference() { cube(6); linear_extrude(%s) polygon([[0, 0], [5, 0], [2, 2], [0, 5]]); "
     "sphere(2); }\nmultmatrix([[1,0,0,8],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) cube(2);",
     1,
     0,
     {"height = 2", "height = 7", "height = 5, twist = 60, slices = 9", "height = 6, scale = 0.5",
      "height = 6"}},
    {"rotate_extrude",
     "sphere(3); rotate_extrude(%s) multmatrix([[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) "
     "square([2, 3]); cube(1);",
     1,
     0,
     {"angle = 360", "angle = 90", "angle = 120", "angle = 270", "angle = 360, $fn = 5",
      "angle = 360, $fn = 6", "angle = 360"}},
    {"circle",
     "linear_extrude(height = 3) difference() { circle(r = 6); circle(%s); }\ncube([1, 9, 2]);",
     0,
     3,
     {"r = 2", "r = 3", "d = 9, $fn = 6", "r = 7", "r = 1"}},
    {"text",
     "linear_extrude(height = 2) text(%s);\nsphere(1);",
     0,
     1,
     {"text = \"ai\", size = 6", "text = \"ai\", size = 9", "text = \"o\", size = 9"}},
    {"hull",
     "hull() { sphere(r = 2); multmatrix([[1,0,0,6],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) "
     "sphere(%s); }\ncube(3);",
     0,
     3,
     {"r = 1", "r = 1.5", "r = 0", "r = 9", "r = 1, $fn = 5"}},
    {"place in a hull",
     "hull() { cube(2); multmatrix(%s) cube([1, 2, 3]); }\ncube(3);",
     0,
     2,
     {"[[1,0,0,6],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", "[[1,0,0,4],[0,1,0,2],[0,0,1,0],[0,0,0,1]]",
      "m = [[1,0,0,0],[0,1,0,0],[0,0,1,4],[0,0,0,1]]"}},
    {"minkowski",
     "minkowski() { cube([4, 3, 2]); sphere(%s); }\ncube(3);",
     0,
     2,
     {"r = 1", "r = 0.5", "r = 0", "r = 2"}},
    {"resize",
     "cube(1); resize(%s) { cube(2); sphere(1.5); }",
     1,
     0,
     {"newsize = [4, 0, 0]", "newsize = [5, 3, 0]", "newsize = [5, 3, 0], auto = true"}},
    {"polyhedron",
     "polyhedron(points = [%s], faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);\ncube(1);",
     0,
     0,
     {"[0,0,0], [5,0,0], [0,5,0], [0,0,5]", "[0,0,0], [6,0,0], [0,4,0], [1,1,5]"}},
    {"faces that are not plane",
     "cube(1); difference() { multmatrix([[0.8,-0.6,0,0.3],[0.6,0.8,0,0.1],[0,0,1,0],[0,0,0,1]]) "
     "polyhedron(%s, faces = [[0,1,2,3], [7,6,5,4], [4,5,1,0], [5,6,2,1], [6,7,3,2], [7,4,0,3]]);"
     " sphere(3); }\nsphere(1);",
     1,
     0,
     {"[[0,0,0], [5,0,1], [5,5,0], [0,5,1], [0,0,5], [5,0,6], [5,5,5], [0,5,7]]",
      "[[0,0,0], [5,0,2], [5,5,0], [0,5,1], [0,0,5], [5,0,6], [5,5,5], [0,5,7]]",
      "[[0,0,0], [5,0,0], [5,5,0], [0,5,0], [0,0,5], [5,0,5], [5,5,5], [0,5,5]]"}},
    {"a solid among drawings, which is left out",
     "cube(6); multmatrix([[1,0,0,9],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { circle(3); "
     "linear_extrude(%s) polygon([[0, 0], [6, 0], [2, 2], [0, 6]]); sphere(2); }\nsphere(7);",
     1,
     0,
     {"height = 2", "height = 5", "height = 5, twist = 60, slices = 9", "height = 3"}},
    {"render",
     "render() difference() { cube(6, center = true); linear_extrude(%s) "
     "polygon([[0, 0], [9, 0], [2, 2], [0, 9]]); }\ncube(1);",
     1,
     0,
     {"height = 9", "height = 2", "height = 5, twist = 60, slices = 9", "height = 2, scale = 0.5"}},
    {"highlight",
     "difference() { cube(6, center = true); #linear_extrude(%s) "
     "polygon([[0, 0], [9, 0], [2, 2], [0, 9]]); }\n#cube(1);",
     1,
     0,
     {"height = 9", "height = 2", "height = 5, twist = 60, slices = 9", "height = 2, scale = 0.5"}},
    {"background",
     "%%linear_extrude(%s) polygon([[0, 0], [9, 0], [2, 2], [0, 9]]);\ncube(3);",
     0,
     0,
     {"height = 9", "height = 2", "height = 5, twist = 60, slices = 9", "height = 2, scale = 0.5"}},
    {"translucent",
     "cube(1); color([1, 0, 0, 0.5]) linear_extrude(%s) "
     "polygon([[0, 0], [9, 0], [2, 2], [0, 9]]);\ncube(3);",
     1,
     0,
     {"height = 9", "height = 2", "height = 5, twist = 60, slices = 9", "height = 2, scale = 0.5"}},
    {"drawing",
     "circle(5); polygon(%s);",
     1,
     0,
     {"[[0, 0], [9, 0], [2, 2], [0, 9]]", "[[0, 0], [9, 0], [3, 2], [0, 9]]",
      "[[0, 0], [9, 0], [0, 9]]"}},
};

static void fill(char *text, const char *format, const char *parameters)
{
    const char *at = strstr(format, "(%s)");
    at = at ? at + 1 : strstr(format, "%s");
    snprintf(text, MODEL_MAX_TEXT, "%.*s%s%s", (int)(at - format), format, parameters, at + 2);
}

/* What stands between the parentheses of the node that is edited. */
static void fill_parameters(char *parameters, size_t size, const struct node_case *node, size_t i)
{
    const char *at = strstr(node->text, "%s"), *begin = at, *end = at;
    while (begin[-1] != '(')
        begin--;
    while (*end != ')')
        end++;
    snprintf(parameters, size, "%.*s%s%.*s", (int)(at - begin), begin, node->parameters[i],
             (int)(end - at) - 2, at + 2);
}

static void check_case(struct bench *bench, const struct node_case *node)
{
    char parameters[512], what[64];
    struct csgcast_node info;
    fill(bench->text, node->text, node->parameters[0]);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    bench_compare_text(bench, scene, node->name, true);
    for (size_t i = 0; i < 2 * MAX_EDITS; i++) {
        const size_t j = i % MAX_EDITS;
        if (!node->parameters[j])
            continue;
        const struct csgcast_edit edit = {
            .leaf = node->leaf, .node = node->node, .parameters = parameters};
        fill_parameters(parameters, sizeof parameters, node, j);
        snprintf(what, sizeof what, "%s %zu", node->name, i);
        CHECK(csgcast_scene_edit(scene, &edit, 1), "%s: %s", what, bench_last_message);
        CHECK(csgcast_scene_get_node(scene, node->leaf, node->node, &info) &&
                  strcmp(info.parameters, parameters) == 0,
              "%s: %s instead of %s", what, info.parameters, parameters);
        fill(bench->text, node->text, node->parameters[j]);
        bench_compare_text(bench, scene, what, true);
    }
    csgcast_scene_destroy(scene);
}

/* Three extrusions, a sphere and what is subtracted from it. */
static void print_batch(char *text, const char *const parameters[3], double x, double radius)
{
    size_t num = 0;
    for (int i = 0; i < 3; i++)
        num += (size_t)snprintf(text + num, MODEL_MAX_TEXT - num,
                                "multmatrix([[1,0,0,%d],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) "
                                "linear_extrude(%s) polygon([[0, 0], [6, 0], [2, 2], [0, 6]]);\n",
                                8 * i, parameters[i]);
    snprintf(text + num, MODEL_MAX_TEXT - num,
             "difference() { multmatrix([[1,0,0,%.17g],[0,1,0,9],[0,0,1,0],[0,0,0,1]]) "
             "color([0, 1, 0]) sphere(4);\n"
             "multmatrix([[1,0,0,3],[0,1,0,9],[0,0,1,3],[0,0,0,1]]) sphere(%.17g); }",
             x, radius);
}

/* Leaves are renumbered where a node becomes more of them, or fewer; a call goes by the numbers
 * from before it. */
static void check_renumbering(struct bench *bench)
{
    static const char *const before[3] = {"height = 2", "height = 3", "height = 4"};
    static const char *const twisted[3] = {"3, twist = 40, slices = 5", "height = 3",
                                           "2, twist = 90, slices = 8"};
    static const double matrix[16] = {1, 0, 0, 2, 0, 1, 0, 9, 0, 0, 1, 0, 0, 0, 0, 1};
    const struct csgcast_edit edits[4] = {{.leaf = 5, .parameters = twisted[2]},
                                          {.leaf = 6, .matrix = matrix},
                                          {.leaf = 0, .parameters = "height = 9"},
                                          {.leaf = 1, .parameters = twisted[0]}};
    struct csgcast_leaf leaf;
    print_batch(bench->text, before, 5, 2);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    bench_draw_edited(bench, scene, NULL);
    CHECK(csgcast_scene_num_leaves(scene) == 8, "%zu leaves", csgcast_scene_num_leaves(scene));
    CHECK(csgcast_scene_edit(scene, edits, 4), "%s", bench_last_message);
    print_batch(bench->text, twisted, 2, 2);
    bench_compare_text(bench, scene, "two nodes at once", true);
    CHECK(csgcast_scene_num_leaves(scene) == 6, "%zu leaves", csgcast_scene_num_leaves(scene));
    CHECK(csgcast_scene_get_leaf(scene, 5, &leaf) && strcmp(leaf.kind, "sphere") == 0 &&
              leaf.first == 5 && leaf.line == 5,
          "%s %zu %u", leaf.kind, leaf.first, leaf.line);
    CHECK(csgcast_scene_set_parameters(scene, 5, "3"), "%s", bench_last_message);
    print_batch(bench->text, twisted, 2, 3);
    bench_compare_text(bench, scene, "a leaf behind them", true);
    CHECK(csgcast_scene_set_parameters(scene, 0, "height = 2") &&
              csgcast_scene_set_parameters(scene, 4, "height = 4"),
          "%s", bench_last_message);
    print_batch(bench->text, before, 2, 3);
    bench_compare_text(bench, scene, "back again", true);
    csgcast_scene_destroy(scene);
}

/* Of a node that an edit leaves nothing of the leaves stay, and come back. */
static void check_nothing(struct bench *bench)
{
    static const char *const before[3] = {"height = 2", "height = 3", "height = 4"};
    static const char *const flat[3] = {"height = 2", "height = 0", "height = 4"};
    struct csgcast_leaf leaf;
    print_batch(bench->text, before, 5, 2);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    bench_draw_edited(bench, scene, NULL);
    CHECK(csgcast_scene_set_parameters(scene, 3, flat[1]), "%s", bench_last_message);
    CHECK(csgcast_scene_get_leaf(scene, 3, &leaf) && leaf.empty && leaf.num == 2, "%zu leaves",
          leaf.num);
    print_batch(bench->text, flat, 5, 2);
    bench_compare_text(bench, scene, "nothing of a node", false);
    CHECK(csgcast_scene_set_parameters(scene, 3, before[1]), "%s", bench_last_message);
    print_batch(bench->text, before, 5, 2);
    bench_compare_text(bench, scene, "all of it again", true);
    csgcast_scene_destroy(scene);
}

static void refuse(struct csgcast_scene *scene, size_t leaf, size_t node, const char *parameters,
                   const char *message)
{
    const struct csgcast_edit edits[2] = {{.leaf = 0, .parameters = "height = 9"},
                                          {.leaf = leaf, .node = node, .parameters = parameters}};
    CHECK(!csgcast_scene_edit(scene, edits, 2) && strstr(bench_last_message, message),
          "expected '%s', got '%s'", message, bench_last_message);
}

/* Nothing changes by edits that are wrong. */
static void check_refused(struct bench *bench)
{
    static const char text[] = "linear_extrude(height = 2) circle(r = 3);\n"
                               "hull() { cube(2); #cube([1, 1, 5]); }\ncube(3);\n";
    struct csgcast_node node;
    struct csgcast_scene *scene = bench_begin(bench, text);
    bench_draw_edited(bench, scene, NULL);
    const size_t last = csgcast_scene_num_leaves(scene) - 1;
    refuse(scene, 0, 1, "r = ,", "<edit of leaf 0>:1:5");
    refuse(scene, 0, 1, "r = 3) square(", "nothing may follow");
    refuse(scene, 0, 2, "r = 3", "leaf 0 has no node 2 of 2");
    refuse(scene, last, 1, "2", "has no node 1 of 1");
    refuse(scene, 1, 1, "2", "load the changed text");
    refuse(scene, last - 1, 0, "2", "load the changed text");
    CHECK(!csgcast_scene_get_node(scene, 0, 2, &node), "node 2 of 2");
    CHECK(csgcast_scene_get_node(scene, 0, 1, &node) && strcmp(node.name, "circle") == 0 &&
              node.line == 1 && node.column == 28 && node.num == 1 &&
              strcmp(node.parameters, "r = 3") == 0,
          "%s %u:%u (%s)", node.name, node.line, node.column, node.parameters);
    snprintf(bench->text, MODEL_MAX_TEXT, "%s", text);
    bench_compare_text(bench, scene, "after refused edits", true);
    csgcast_scene_destroy(scene);
}

void check_nodes(struct bench *bench)
{
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        check_case(bench, &cases[i]);
    check_renumbering(bench);
    check_nothing(bench);
    check_refused(bench);
}
