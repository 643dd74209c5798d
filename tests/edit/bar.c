/* SPDX-License-Identifier: MIT */

/* Edits of a surface of triangles that comes to share faces with others. */

#include <stdio.h>

#include "bench.h"

/* Cubes in a row, and behind them in the text a twisted bar that stands on the plane z. */
static void print_bar(char *text, size_t size, double z)
{
    size_t num = 0;
    for (int i = 0; i < 20; i++)
        num += (size_t)snprintf(text + num, size - num,
                                "multmatrix([[1,0,0,%d],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) "
                                "color([0, %.2g, 1]) cube([2, 2, %d]);\n",
                                2 * i, 0.05 * i, 1 + i % 3);
    snprintf(text + num, size - num,
             "multmatrix([[1,0,0,4],[0,1,0,1],[0,0,1,%.17g],[0,0,0,1]])\n"
             "linear_extrude(height = 3, twist = 90, slices = 8) square([5, 1], center = true);\n",
             z);
}

/* A surface of triangles comes to stand on solids that others stand beside, and leaves them. */
void check_bar(struct bench *bench)
{
    print_bar(bench->text, MODEL_MAX_TEXT, 5);
    struct csgcast_scene *scene = bench_begin(bench, bench->text);
    struct csgcast_leaf leaf;
    bench_draw_edited(bench, scene, NULL);
    CHECK(csgcast_scene_get_leaf(scene, 20, &leaf), "%s", bench_last_message);
    for (int i = 0; i < 12; i++) {
        const double z = i % 4 ? i % 4 - 1 : 5.25;
        const double matrix[16] = {1, 0, 0, 4, 0, 1, 0, 1, 0, 0, 1, z, 0, 0, 0, 1};
        print_bar(bench->text, MODEL_MAX_TEXT, z);
        CHECK(csgcast_scene_set_matrix(scene, leaf.first, matrix), "%s", bench_last_message);
        bench_compare_text(bench, scene, "bar", true);
    }
    csgcast_scene_destroy(scene);
}
