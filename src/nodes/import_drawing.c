/* SPDX-License-Identifier: MIT */
/*
 * import() of drawings. What OpenSCAD cannot read is empty there.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "files/dxf.h"
#include "files/svg.h"
#include "nodes/clip.h"
#include "nodes/drawings.h"
#include "nodes/figures.h"
#include "nodes/import.h"
#include "nodes/transforms.h"

/* The file at hand. */
struct source {
    struct csg_walk *walk;
    uint32_t node;
    const struct csg_args *args;
    double scale; /* of DXF */
    const char *name;
    struct csg_bytes bytes;
    size_t num_warnings;
};

/* Of one file; the others are only counted. */
enum { max_warnings = 3 };

static void warn(void *user, size_t line, const char *text)
{
    struct source *source = user;
    if (source->num_warnings++ < max_warnings)
        csg_walk_warning(source->walk, source->node, "%.80s:%zu: %s", source->name, line, text);
}

/* ---- DXF ------------------------------------------------------------------------------------ */

static struct csg_dxf_params dxf_params(const struct csg_args *args, double scale)
{
    const struct csg_value *layer = csg_args_find(args, "layer");
    struct csg_dxf_params params = {
        .facets = csg_args_facets(args),
        .layer = layer && layer->type == CSG_VALUE_STRING ? layer->string : "",
        .scale = scale > 0 && isfinite(scale) ? scale : 1};
    double origin[2];
    if (csg_value_numbers(csg_args_find(args, "origin"), 2, origin, NULL) && isfinite(origin[0]) &&
        isfinite(origin[1])) {
        params.origin[0] = origin[0];
        params.origin[1] = origin[1];
    }
    return params;
}

static bool add_dxf(struct source *source, struct csg_drawing *drawing)
{
    const struct csg_dxf_params params = dxf_params(source->args, source->scale);
    const struct csg_dxf_warnings warnings = {source, warn};
    const uint32_t draw = (uint32_t)drawing->nodes.num;
    const size_t num_contours = drawing->contours.num;
    if (!csg_drawing_add_figure(drawing, 0))
        return csg_walk_no_memory(source->walk);
    const enum csg_dxf_result result = csg_dxf_read(&source->bytes, &params, &warnings, drawing);
    if (result == CSG_DXF_NO_MEMORY)
        return csg_walk_no_memory(source->walk);
    if (source->num_warnings > max_warnings)
        csg_walk_warning(source->walk, source->node, "%.80s: %zu more such places", source->name,
                         source->num_warnings - max_warnings);
    if (source->num_warnings == 0 && drawing->contours.num == num_contours)
        csg_walk_warning(source->walk, source->node,
                         "%.80s: no line in it%s%.80s; nothing is drawn", source->name,
                         params.layer[0] ? " on layer " : "", params.layer);
    if (result == CSG_DXF_TOO_LARGE) {
        csg_drawing_cut(drawing, draw);
        csg_report_error(source->walk->builder->report, CSGCAST_MESSAGE_SCENE,
                         csg_walk_node(source->walk, source->node)->place,
                         "%.80s: blocks and curves of more than %d lines; import a single layer, "
                         "or use a smaller $fn",
                         source->name, CSG_DXF_MAX_LINES);
    }
    return true;
}

/* ---- SVG ------------------------------------------------------------------------------------ */

/* Clipper's grid, to which coordinates are cut off. */
static const double clipped_rounding = 0x1p-16;

/* Compressed, which libxml2 reads from files only. */
static bool is_gzip(const struct csg_bytes *bytes)
{
    return bytes->num > 2 && memcmp(bytes->data, "\x1f\x8b", 2) == 0;
}

/* A file that does not say otherwise has 72 units to the inch, but .csg texts always do. */
static double dpi_of(const struct csg_args *args)
{
    const double dpi = csg_args_number(args, "dpi", 72, NULL);
    return dpi >= 0.001 && isfinite(dpi) ? dpi : 72;
}

/* The shapes become one figure: the union, as Clipper makes it. Where drawings are clipped anyway
 * it is made there. */
static bool unite(const struct source *source, uint32_t draw, struct csg_drawing *drawing)
{
    csg_drawing_close(drawing, draw);
    if (!csg_clip_is_wanted(source->walk) && !csg_clip_evaluate(source->walk, drawing, draw))
        return false;
    for (uint32_t i = draw; i < drawing->nodes.num; i++)
        if (drawing->nodes.data[i].op == CSG_DRAW_FIGURE) {
            struct csg_figure *figure = &drawing->figures.data[drawing->nodes.data[i].figure];
            figure->rounding = clipped_rounding;
            figure->is_outline = false; /* maps may turn it inside out */
        }
    return true;
}

static bool add_svg(struct source *source, struct csg_drawing *drawing)
{
    struct csg_xml_error error = {0};
    const struct csg_svg_params params = {
        .dpi = dpi_of(source->args),
        .center = csg_args_bool(source->args, "center"),
        .xml = csg_import_xml(source->walk),
        .clip = csg_clip_is_there(source->walk) ? source->walk->builder->clip.module : NULL};
    if (!params.xml || !params.clip) {
        csg_walk_unsupported(source->walk, source->node,
                             "import of SVG needs csgcast-xml.so and csgcast-clip.so; one is "
                             "missing, or lacks its libraries (Debian: libxml2 libzip4 "
                             "libpolyclipping22)");
        return true;
    }
    const uint32_t draw = (uint32_t)drawing->nodes.num;
    const size_t num_contours = drawing->contours.num;
    enum csg_svg_result result = CSG_SVG_FOREIGN;
    if (!csg_drawing_open(drawing, CSG_DRAW_UNION))
        return csg_walk_no_memory(source->walk);
    if (!is_gzip(&source->bytes))
        result = csg_svg_read(&source->bytes, &params, drawing, &error);
    if (result == CSG_SVG_FOREIGN)
        csg_walk_unsupported(source->walk, source->node,
                             "import: %.100s is compressed, or its numbers are too large",
                             source->name);
    else if (result == CSG_SVG_ENTITY)
        csg_import_refuse(source->walk, source->node, source->name, &error);
    else if (result == CSG_SVG_MALFORMED)
        csg_walk_warning(source->walk, source->node, "%.80s:%zu: %s; nothing is drawn",
                         source->name, error.line, error.text);
    else if (result == CSG_SVG_DONE && drawing->contours.num == num_contours)
        csg_walk_warning(source->walk, source->node, "%.80s: no shape in it; nothing is drawn",
                         source->name);
    return result == CSG_SVG_NO_MEMORY ? csg_walk_no_memory(source->walk)
                                       : unite(source, draw, drawing);
}

/* ---- the nodes ------------------------------------------------------------------------------ */

/* The kinds of files. add: false, with a message, when memory is out. */
static const struct format {
    const char *ending;
    bool (*add)(struct source *source, struct csg_drawing *drawing);
} formats[] = {{".dxf", add_dxf}, {".svg", add_svg}};

static const struct format *find_format(const char *name)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (csg_import_has_ending(name, formats[i].ending))
            return &formats[i];
    return NULL;
}

bool csg_import_is_drawing(const char *name)
{
    return find_format(name) != NULL;
}

static bool read_file(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                      double scale, struct csg_drawing *drawing)
{
    struct source source = {.walk = walk, .node = node, .args = args, .scale = scale};
    const uint32_t draw = (uint32_t)drawing->nodes.num;
    bool ok = csg_import_read(walk, node, args, &source.name, &source.bytes);
    const struct format *format = find_format(source.name);
    if (ok && format)
        ok = format->add(&source, drawing);
    else if (ok && source.name)
        csg_walk_unsupported(walk, node, "import: %.100s is of a kind that is not supported",
                             source.name);
    if (ok && drawing->nodes.num == draw)
        ok = csg_drawing_open(drawing, CSG_DRAW_UNION) || csg_walk_no_memory(source.walk);
    free(source.bytes.data);
    return ok;
}

bool csg_import_drawing(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                        double scale, struct csg_drawing *drawing)
{
    return read_file(walk, node, args, scale, drawing) &&
           (!csg_clip_is_wanted(walk) || csg_clip_evaluate(walk, drawing, 0));
}

bool csg_figure_import(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       const struct csg_space *space, struct csg_drawing *drawing)
{
    const uint32_t draw = (uint32_t)drawing->nodes.num;
    return read_file(walk, node, args, csg_args_number(args, "scale", 1, NULL), drawing) &&
           csg_drawing_place(walk, drawing, draw, space);
}
