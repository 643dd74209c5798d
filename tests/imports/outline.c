/* SPDX-License-Identifier: MIT */
/*
 *   outline FILE [layer=L] [x=X] [y=Y] [scale=S] [fn=N] [fa=A] [fs=S] [dpi=D] [center]
 *
 * Writes the corners of the drawing in a file as csgcast reads it, after Clipper: "x y" a line, an
 * empty line behind each contour. Of an AMF file it writes the points of the meshes.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clip/module.h"
#include "common/module.h"
#include "files/amf.h"
#include "files/dxf.h"
#include "files/svg.h"
#include "xml/module.h"

struct options {
    struct csg_dxf_params dxf;
    struct csg_svg_params svg;
};

static const void *open_module(const char *file, const char *variable, const char *name)
{
    const void *module = csg_module_symbol(file, variable, name);
    if (!module)
        fprintf(stderr, "outline: %s does not load\n", file);
    return module;
}

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
        {"dpi=", &options->svg.dpi},
    };
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        const size_t length = strlen(numbers[i].name);
        if (strncmp(text, numbers[i].name, length) == 0) {
            *numbers[i].value = atof(text + length);
            return true;
        }
    }
    options->svg.center |= strcmp(text, "center") == 0;
    if (strcmp(text, "center") == 0)
        return true;
    if (strncmp(text, "layer=", 6) != 0)
        return false;
    options->dxf.layer = text + 6;
    return true;
}

static bool read_dxf(const struct csg_bytes *bytes, const struct options *options,
                     struct csg_drawing *drawing)
{
    const struct csg_dxf_warnings warnings = {NULL, warn};
    return csg_drawing_add_figure(drawing, 0) &&
           csg_dxf_read(bytes, &options->dxf, &warnings, drawing) == CSG_DXF_DONE;
}

/* What is malformed is empty. */
static bool read_svg(const struct csg_bytes *bytes, const struct options *options,
                     struct csg_drawing *drawing)
{
    struct csg_svg_params params = options->svg;
    struct csg_xml_error error;
    params.clip = open_module("csgcast-clip.so", "CSGCAST_CLIP_MODULE", CSG_CLIP_MODULE_NAME);
    params.xml = open_module("csgcast-xml.so", "CSGCAST_XML_MODULE", CSG_XML_MODULE_NAME);
    if (!params.clip || !params.xml)
        return false;
    const enum csg_svg_result result = csg_svg_read(bytes, &params, drawing, &error);
    if (result == CSG_SVG_MALFORMED)
        drawing->figures.num = 0;
    if (result == CSG_SVG_MALFORMED)
        warn(NULL, error.line, error.text);
    return result == CSG_SVG_DONE || result == CSG_SVG_MALFORMED;
}

static bool print_amf(const struct csg_bytes *bytes)
{
    struct csg_mesh_list list = {0};
    struct csg_xml_error error;
    const struct csg_xml_module *xml =
        open_module("csgcast-xml.so", "CSGCAST_XML_MODULE", CSG_XML_MODULE_NAME);
    const enum csg_amf_result result =
        xml ? csg_amf_read(bytes, "x.amf", xml, &list, &error) : CSG_AMF_NO_MEMORY;
    for (size_t i = 0; i < list.meshes.num; i++)
        for (size_t k = 0; k < list.meshes.data[i].points.num; k++) {
            const struct csg_vec3 p = list.meshes.data[i].points.data[k];
            printf("%.17g %.17g %.17g\n", p.x, p.y, p.z);
        }
    csg_mesh_list_finish(&list);
    return result != CSG_AMF_NO_MEMORY;
}

static bool read_file(const char *path, const struct options *options, struct csg_drawing *drawing)
{
    const struct csg_log log = {0};
    const char *dot = strrchr(path, '.');
    struct csg_bytes bytes = {0};
    const bool is_svg = dot && strcmp(dot, ".svg") == 0, is_amf = dot && strcmp(dot, ".amf") == 0;
    const bool ok =
        csg_file_read(path, &bytes, &log) && (is_amf   ? print_amf(&bytes)
                                              : is_svg ? read_svg(&bytes, options, drawing)
                                                       : read_dxf(&bytes, options, drawing));
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
static bool print_outline(const struct csg_drawing *drawing, bool is_union)
{
    const struct csg_clip_module *module =
        open_module("csgcast-clip.so", "CSGCAST_CLIP_MODULE", CSG_CLIP_MODULE_NAME);
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
        module->combine(is_union ? CSG_CLIP_UNION : CSG_CLIP_CLEAN, (uint32_t)drawing->figures.num,
                        paths, num, &sink) == CSG_CLIP_DONE;
    free(paths);
    return ok;
}

int main(int argc, char **argv)
{
    struct options options = {.dxf = {.facets = {0, 12, 2}, .layer = "", .scale = 1},
                              .svg = {.dpi = 72}};
    struct csg_drawing drawing = {0};
    for (int i = 2; i < argc; i++)
        if (!read_option(&options, argv[i])) {
            fprintf(stderr, "outline: %s?\n", argv[i]);
            return 2;
        }
    const bool ok = argc > 1 && read_file(argv[1], &options, &drawing) &&
                    print_outline(&drawing, strstr(argv[1], ".svg") != NULL);
    csg_drawing_finish(&drawing);
    return ok ? 0 : 1;
}
