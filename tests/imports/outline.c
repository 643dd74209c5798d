/* SPDX-License-Identifier: MIT */
/*
 *   outline FILE [layer=L] [x=X] [y=Y] [scale=S] [fn=N] [fa=A] [fs=S] [dpi=D] [center]
 *
 * Writes the corners of the drawing in a file as csgcast reads it, after Clipper: "x y" a line, an
 * empty line behind each contour.
 */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clip/module.h"
#include "common/module.h"
#include "files/dxf.h"

struct options {
    struct csg_dxf_params dxf;
};

static void warn(void *user, size_t line, const char *text)
{
    (void)user;
    fprintf(stderr, "line %zu: %s\n", line, text);
}

static bool read_option(struct options *options, const char *text)
{
    const struct {
        const char *name;
        double *value;
    } numbers[] = {
        {"x=", &options->dxf.origin[0]},  {"y=", &options->dxf.origin[1]},
        {"scale=", &options->dxf.scale},  {"fn=", &options->dxf.facets.fn},
        {"fa=", &options->dxf.facets.fa}, {"fs=", &options->dxf.facets.fs},
    };
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        const size_t length = strlen(numbers[i].name);
        if (strncmp(text, numbers[i].name, length) == 0) {
            *numbers[i].value = atof(text + length);
            return true;
        }
    }
    if (strncmp(text, "layer=", 6) != 0)
        return false;
    options->dxf.layer = text + 6;
    return true;
}

static bool read_file(const char *path, const struct options *options, struct csg_drawing *drawing)
{
    const struct csg_log log = {0};
    const struct csg_dxf_warnings warnings = {NULL, warn};
    struct csg_bytes bytes = {0};
    const bool ok = csg_file_read(path, &bytes, &log) && csg_drawing_add_figure(drawing, 0) &&
                    csg_dxf_read(&bytes, &options->dxf, &warnings, drawing) == CSG_DXF_DONE;
    free(bytes.data);
    return ok;
}

/* ---- Clipper -------------------------------------------------------------------------------- */

static bool begin_contour(void *user)
{
    int *num = user;
    if ((*num)++ > 0)
        printf("\n");
    return true;
}

static bool add_point(void *user, double x, double y)
{
    (void)user;
    printf("%.17g %.17g\n", x, y);
    return true;
}

/* Each figure is an operand. */
static bool print_union(const struct csg_drawing *drawing)
{
    void *handle = csg_module_open("csgcast-clip.so", "CSGCAST_CLIP_MODULE");
    const struct csg_clip_module *module =
        handle ? (const struct csg_clip_module *)dlsym(handle, CSG_CLIP_MODULE_NAME) : NULL;
    struct csg_clip_path *paths = calloc(drawing->contours.num + 1, sizeof *paths);
    int num_contours = 0;
    const struct csg_clip_sink sink = {&num_contours, begin_contour, add_point};
    size_t num = 0;
    for (uint32_t i = 0; i < drawing->figures.num && paths; i++)
        for (uint32_t k = drawing->figures.data[i].begin; k < drawing->figures.data[i].end; k++) {
            const struct csg_contour *contour = &drawing->contours.data[k];
            if (contour->end > contour->begin)
                paths[num++] = (struct csg_clip_path){&drawing->points.data[contour->begin].x,
                                                      contour->end - contour->begin, i, i, false};
        }
    const bool ok =
        module && paths &&
        module->combine(drawing->figures.num > 1 ? CSG_CLIP_UNION : CSG_CLIP_CLEAN, (uint32_t)drawing->figures.num, paths, num, &sink) ==
            CSG_CLIP_DONE;
    free(paths);
    return ok;
}

int main(int argc, char **argv)
{
    struct options options = {.dxf = {.facets = {0, 12, 2}, .layer = "", .scale = 1}};
    struct csg_drawing drawing = {0};
    for (int i = 2; i < argc; i++)
        if (!read_option(&options, argv[i])) {
            fprintf(stderr, "outline: %s?\n", argv[i]);
            return 2;
        }
    const bool ok = argc > 1 && read_file(argv[1], &options, &drawing) && print_union(&drawing);
    csg_drawing_finish(&drawing);
    return ok ? 0 : 1;
}
