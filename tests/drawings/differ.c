/* SPDX-License-Identifier: MIT */
/*
 *   differ FILE.csg < THEIRS
 *
 * Compares the drawing in a text, as written, with one from standard input: "x y" a line, an empty
 * line behind each contour. Prints the corners of both, the area in which they differ, and the
 * length of both outlines.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "clip/module.h"
#include "common/file.h"
#include "common/module.h"
#include "csg/scene.h"
#include "nodes/drawings.h"
#include "nodes/text.h"

static bool read_drawing(struct csg_builder *builder, struct csg_drawing *drawing)
{
    struct csg_walk walk = {.builder = builder};
    const bool ok = csg_build_meanings(builder) && csg_build_dimensions(builder) &&
                    csg_build_unsupported(builder) &&
                    csg_drawing_read_node(&walk, 0, false, drawing);
    csg_arguments_finish(&walk.arguments);
    csg_text_finish(builder->text);
    free(builder->meanings);
    return ok;
}

/* The text, as the children of one node. */
static bool read_ours(const char *path, struct csg_drawing *drawing)
{
    struct csg_bytes file = {0}, text = {0};
    struct csg_document document = {0};
    struct csg_report report;
    struct csgcast_scene scene = {0};
    const struct csgcast_scene_params params = {.facets = CSGCAST_FACETS_AS_WRITTEN};
    struct csg_log log = {0};
    bool ok = csg_file_read(path, &file, &log) && csg_bytes_append_text(&text, "group() {") &&
              csg_bytes_append(&text, file.data, file.num) && csg_bytes_append_text(&text, "}");
    csg_report_init(&report, &log, path);
    struct csg_text_state fonts = {0};
    struct csg_builder builder = {.document = &document,
                                  .params = &params,
                                  .report = &report,
                                  .scene = &scene,
                                  .facets = CSGCAST_FACETS_AS_WRITTEN,
                                  .text = &fonts,
                                  .clip.is_wanted = true,
                                  .num_threads = 1,
                                  .directory = "."};
    ok = ok && csg_document_parse(&document, text.data, text.num, 1, &report) &&
         read_drawing(&builder, drawing);
    csg_document_finish(&document);
    free(file.data);
    free(text.data);
    return ok && csg_report_finish(&report);
}

static bool read_theirs(struct csg_drawing *drawing)
{
    char line[256];
    bool is_new = true, ok = csg_drawing_add_figure(drawing, 0);
    while (ok && fgets(line, sizeof line, stdin)) {
        double x, y;
        if (sscanf(line, "%lf %lf", &x, &y) != 2) {
            is_new = true;
            continue;
        }
        ok = (!is_new || csg_drawing_add_contour(drawing)) && csg_drawing_add_point(drawing, x, y);
        is_new = false;
    }
    return ok;
}

/* ---- areas ---------------------------------------------------------------------------------- */

struct sum {
    struct csg_vec2 first, last;
    double area; /* twice, of all contours so far */
};

static bool begin_contour(void *user)
{
    struct sum *sum = user;
    sum->area += sum->last.x * sum->first.y - sum->first.x * sum->last.y;
    sum->first = sum->last = (struct csg_vec2){(double)NAN, 0};
    return true;
}

static bool add_point(void *user, double x, double y)
{
    struct sum *sum = user;
    if (isnan(sum->first.x))
        sum->first = (struct csg_vec2){x, y};
    else
        sum->area += sum->last.x * y - x * sum->last.y;
    sum->last = (struct csg_vec2){x, y};
    return true;
}

/* Figures unite. */
static void add_paths(const struct csg_drawing *drawing, uint32_t operand, uint32_t first_figure,
                      struct csg_clip_path *paths, size_t *num)
{
    for (size_t n = 0; n < drawing->nodes.num; n++) {
        if (drawing->nodes.data[n].op != CSG_DRAW_FIGURE)
            continue;
        const struct csg_figure *figure = &drawing->figures.data[drawing->nodes.data[n].figure];
        for (uint32_t i = figure->begin; i < figure->end; i++) {
            const struct csg_contour *contour = &drawing->contours.data[i];
            paths[(*num)++] = (struct csg_clip_path){
                &drawing->points.data[contour->begin].x, contour->end - contour->begin, operand,
                first_figure + (uint32_t)n, figure->is_outline};
        }
    }
}

/* Of a less b. */
static double area_of_rest(const struct csg_clip_module *module, const struct csg_drawing *a,
                           const struct csg_drawing *b)
{
    struct csg_clip_path *paths = calloc(a->contours.num + b->contours.num + 1, sizeof *paths);
    struct sum sum = {0};
    const struct csg_clip_sink sink = {&sum, begin_contour, add_point};
    size_t num = 0;
    if (!paths)
        return (double)NAN;
    add_paths(a, 0, 0, paths, &num);
    add_paths(b, 1, (uint32_t)a->nodes.num, paths, &num);
    const bool ok = module->combine(CSG_CLIP_DIFFERENCE, 2, paths, num, &sink) == CSG_CLIP_DONE;
    begin_contour(&sum);
    free(paths);
    return ok ? fabs(sum.area) / 2 : (double)NAN;
}

/* Of all contours, also those that others cover. */
static double length_of(const struct csg_drawing *drawing, size_t *corners)
{
    double length = 0;
    for (size_t i = 0; i < drawing->contours.num; i++) {
        const struct csg_contour *contour = &drawing->contours.data[i];
        for (uint32_t k = contour->begin; k < contour->end; k++) {
            const struct csg_vec2 a = drawing->points.data[k];
            const struct csg_vec2 b =
                drawing->points.data[k + 1 < contour->end ? k + 1 : contour->begin];
            length += hypot(a.x - b.x, a.y - b.y);
            ++*corners;
        }
    }
    return length;
}

int main(int argc, char **argv)
{
    struct csg_drawing ours = {0}, theirs = {0};
    const struct csg_clip_module *module =
        csg_module_symbol("csgcast-clip.so", "CSGCAST_CLIP_MODULE", CSG_CLIP_MODULE_NAME);
    size_t num_ours = 0, num_theirs = 0;
    if (!module || argc != 2 || !read_ours(argv[1], &ours) || !read_theirs(&theirs))
        return 1;
    const double area = area_of_rest(module, &ours, &theirs) + area_of_rest(module, &theirs, &ours);
    const double length = length_of(&ours, &num_ours) + length_of(&theirs, &num_theirs);
    printf("%zu %zu %.9g %.9g\n", num_ours, num_theirs, area, length);
    csg_drawing_finish(&ours);
    csg_drawing_finish(&theirs);
    return area >= 0 ? 0 : 1;
}
