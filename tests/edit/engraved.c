/* SPDX-License-Identifier: MIT */

/* Surfaces of triangles that are moved through a plate: their faces are flush with its sides, within
 * it, and cross them. */

#include <stdio.h>

#include "bench.h"

/* Where the plate, a twisted bar and another one are along z. */
struct place {
    double plate, bar, other;
};

static void print_engraved(char *text, size_t size, const struct place *place)
{
    snprintf(text, size,
             "difference() {\n"
             "multmatrix([[1,0,0,-10],[0,1,0,-10],[0,0,1,%.17g],[0,0,0,1]]) cube([20, 20, 4]);\n"
             "multmatrix([[1,0,0,-4],[0,1,0,0],[0,0,1,%.17g],[0,0,0,1]])"
             " linear_extrude(height = 4, twist = 30, slices = 6) square(6, center = true);\n"
             "multmatrix([[1,0,0,4],[0,1,0,1],[0,0,1,%.17g],[0,0,0,1]])"
             " linear_extrude(height = 6, twist = 30, slices = 6) square(6, center = true);\n}",
             place->plate, place->bar, place->other);
}

static void move_to(struct csgcast_scene *scene, const struct place *place)
{
    const double plate[16] = {1, 0, 0, -10, 0, 1, 0, -10, 0, 0, 1, place->plate, 0, 0, 0, 1};
    const double bar[16] = {1, 0, 0, -4, 0, 1, 0, 0, 0, 0, 1, place->bar, 0, 0, 0, 1};
    const double other[16] = {1, 0, 0, 4, 0, 1, 0, 1, 0, 0, 1, place->other, 0, 0, 0, 1};
    const struct csgcast_edit edits[3] = {
        {.leaf = 0, .matrix = plate}, {.leaf = 1, .matrix = bar}, {.leaf = 2, .matrix = other}};
    CHECK(csgcast_scene_edit(scene, edits, 3), "%s", bench_last_message);
}

void check_engraved(struct bench *bench)
{
    static const struct place places[] = {
        {0, 0, 0}, {0, 0, 1}, {0, 1, -1}, {0, -1, 0},    {1, -1, 0}, {1, -3, -5}, {1, 1, -1},
        {1, 2, 5}, {0, 2, 5}, {0, 4, -2}, {0, 0.5, 4.5}, {0, 0, -2}, {-2, 0, -2}};
    char *text = bench->text;
    print_engraved(text, MODEL_MAX_TEXT, &places[0]);
    struct csgcast_scene *scene = bench_begin(bench, text);
    bench_draw_edited(bench, scene, NULL);
    for (size_t i = 1; i < sizeof places / sizeof *places; i++) {
        print_engraved(text, MODEL_MAX_TEXT, &places[i]);
        move_to(scene, &places[i]);
        bench_compare_text(bench, scene, "engraved", true);
    }
    csgcast_scene_destroy(scene);
}
