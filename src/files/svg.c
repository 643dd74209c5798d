/* SPDX-License-Identifier: MIT */
#include "files/svg.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "files/svg_shape.h"
#include "files/svg_text.h"

/* Elements that move what is in them, and how deep they may lie in each other here. libxml2 takes
 * 256, but OpenSCAD never leaves an inner svg again. */
enum { max_depth = 1000 };

static const double inch = 25.4; /* mm */

static const size_t no_container = (size_t)-1;

struct container {
    size_t around;     /* the next one that moves it; no_container: none */
    size_t begin, end; /* of its maps */
    int depth;
};

/* Of the svg elements the last one counts. */
struct page {
    double height; /* mm */
    double scale[2], align[2], origin[2];
};

struct reader {
    const struct csg_svg_params *params;
    struct csg_drawing *drawing;
    struct page page;
    CSG_ARRAY(struct csg_svg_map) maps;
    CSG_ARRAY(struct container) containers;
    CSG_ARRAY(size_t) stack; /* of containers */
    bool in_defs;
    struct csg_svg_paths paths; /* of the shape at hand */
    struct csg_box box;         /* of all points, scaled */
    enum csg_svg_result result;
};

static bool fail(struct reader *reader, enum csg_svg_result result)
{
    if (reader->result == CSG_SVG_DONE)
        reader->result = result;
    return false;
}

/* ---- the page ------------------------------------------------------------------------------- */

static double to_mm(struct csg_svg_length length, bool has_box, double box, double dpi)
{
    switch (length.unit) {
    case CSG_SVG_NONE:
        return inch * length.number / dpi;
    case CSG_SVG_PX:
        return inch * length.number / 96;
    case CSG_SVG_PT:
        return inch * length.number / 72;
    case CSG_SVG_PC:
        return inch * length.number / 6;
    case CSG_SVG_IN:
        return inch * length.number;
    case CSG_SVG_CM:
        return 10 * length.number;
    case CSG_SVG_MM:
        return length.number;
    case CSG_SVG_UNDEFINED:
        return has_box ? inch * box / dpi : 0;
    default:
        return has_box ? box : 0;
    }
}

static double room_before(double share, double size, double scale, double box)
{
    return share == 0 ? 0 : share < 1 ? size / 2 - scale * box / 2 : size - scale * box;
}

static void read_page(struct reader *reader, const struct csg_svg_attributes *attributes)
{
    struct page *page = &reader->page;
    double box[4] = {0};
    const bool has_box = csg_svg_view_box(csg_svg_find(attributes, "viewBox"), box);
    const double dpi = reader->params->dpi;
    const double width =
        to_mm(csg_svg_length(csg_svg_find(attributes, "width")), has_box, box[2], dpi);
    page->height = to_mm(csg_svg_length(csg_svg_find(attributes, "height")), has_box, box[3], dpi);
    if (!has_box)
        return;
    page->origin[0] = box[0];
    page->origin[1] = box[1];
    page->scale[0] = width / box[2];
    page->scale[1] = page->height / box[3];
    const struct csg_svg_alignment alignment =
        csg_svg_alignment(csg_svg_find(attributes, "preserveAspectRatio"));
    if (alignment.is_none)
        return;
    const bool takes_first = (page->scale[0] < page->scale[1]) != alignment.is_slice;
    page->scale[0] = page->scale[1] = page->scale[!takes_first];
    page->align[0] = room_before(alignment.x, width, page->scale[0], box[2]);
    page->align[1] = room_before(alignment.y, page->height, page->scale[1], box[3]);
}

/* ---- containers ----------------------------------------------------------------------------- */

static bool take_map(void *user, const struct csg_svg_map *map)
{
    struct reader *reader = user;
    return csg_array_push(&reader->maps, *map);
}

static bool open_container(struct reader *reader, const struct csg_svg_attributes *attributes,
                           bool is_page)
{
    const bool is_root = reader->stack.num == 0;
    const size_t around = is_root ? no_container : reader->stack.data[reader->stack.num - 1];
    struct container container = {.around = around, .begin = reader->maps.num};
    /* What is in nothing else is not moved itself. */
    if (!is_root && !is_page &&
        !csg_svg_transform(csg_svg_find(attributes, "transform"), reader, take_map))
        return fail(reader, CSG_SVG_NO_MEMORY);
    container.end = reader->maps.num;
    if (around != no_container)
        container.depth = reader->containers.data[around].depth + 1;
    /* One without maps stands for the one around it. */
    const bool is_same = container.begin == container.end && around != no_container;
    if (!is_same && container.depth > max_depth)
        return fail(reader, CSG_SVG_FOREIGN);
    const size_t index = is_same ? around : reader->containers.num;
    return ((is_same || csg_array_push(&reader->containers, container)) &&
            csg_array_push(&reader->stack, index)) ||
           fail(reader, CSG_SVG_NO_MEMORY);
}

static void apply(const struct csg_svg_map *map, struct csg_vec2 *p)
{
    const double *m = map->m;
    *p = (struct csg_vec2){m[0] * p->x + m[1] * p->y + m[2], m[3] * p->x + m[4] * p->y + m[5]};
}

/* From the shape's space to the page's: its own maps from first_map on, then those around it, one
 * by one, as OpenSCAD rounds after each. */
static void place(const struct reader *reader, size_t first_map, struct csg_vec2 *p)
{
    const struct csg_svg_map *maps = reader->maps.data;
    for (size_t i = reader->maps.num; i > first_map; i--)
        apply(&maps[i - 1], p);
    size_t around = reader->stack.num ? reader->stack.data[reader->stack.num - 1] : no_container;
    for (; around != no_container; around = reader->containers.data[around].around)
        for (size_t i = reader->containers.data[around].end;
             i > reader->containers.data[around].begin; i--)
            apply(&maps[i - 1], p);
}

/* ---- shapes --------------------------------------------------------------------------------- */

static bool add_point(struct reader *reader, size_t first_map, struct csg_vec2 p)
{
    place(reader, first_map, &p);
    if (!isfinite(p.x + p.y))
        return fail(reader, CSG_SVG_FOREIGN);
    csg_box_extend(&reader->box,
                   csg_vec3(reader->page.scale[0] * p.x, reader->page.scale[1] * p.y, 0));
    return csg_drawing_add_point(reader->drawing, p.x, p.y) || fail(reader, CSG_SVG_NO_MEMORY);
}

static bool add_figure(struct reader *reader, size_t first_map)
{
    const struct csg_svg_paths *paths = &reader->paths;
    bool ok = csg_drawing_add_figure(reader->drawing, 0) || fail(reader, CSG_SVG_NO_MEMORY);
    for (size_t i = 0; i < paths->begins.num && ok; i++) {
        ok = csg_drawing_add_contour(reader->drawing) || fail(reader, CSG_SVG_NO_MEMORY);
        for (size_t k = paths->begins.data[i]; k < csg_svg_path_end(paths, i) && ok; k++)
            ok = add_point(reader, first_map, paths->points.data[k]);
    }
    return ok;
}

static bool read_shape(struct reader *reader, const char *name,
                       const struct csg_svg_attributes *attributes)
{
    const size_t first_map = reader->maps.num;
    struct csg_svg_paths *paths = &reader->paths;
    paths->points.num = paths->begins.num = 0;
    if (!csg_svg_add_shape(paths, name, attributes))
        return true;
    if (paths->result != CSG_SVG_DONE)
        return fail(reader, paths->result);
    if (reader->stack.num > 0 &&
        !csg_svg_transform(csg_svg_find(attributes, "transform"), reader, take_map))
        return fail(reader, CSG_SVG_NO_MEMORY);
    const bool ok = add_figure(reader, first_map);
    reader->maps.num = first_map;
    return ok;
}

/* ---- elements ------------------------------------------------------------------------------- */

static bool is_text(const char *name)
{
    return strcmp(name, "text") == 0 || strcmp(name, "tspan") == 0;
}

/* An svg in another one is never left. */
static bool end_element(void *user, const char *name)
{
    struct reader *reader = user;
    if (strcmp(name, "defs") == 0)
        reader->in_defs = false;
    if (!reader->in_defs && (strcmp(name, "g") == 0 || is_text(name)) && reader->stack.num > 0)
        reader->stack.num--;
    return true;
}

static bool begin_element(void *user, const char *name, const struct csg_xml_attribute *list,
                          size_t num, bool is_empty)
{
    struct reader *reader = user;
    const struct csg_svg_attributes attributes = {list, num};
    const bool is_page = strcmp(name, "svg") == 0;
    bool ok = true;
    if (strcmp(name, "defs") == 0)
        reader->in_defs = true;
    if (!reader->in_defs && is_page)
        read_page(reader, &attributes);
    if (!reader->in_defs && (is_page || strcmp(name, "g") == 0 || is_text(name)))
        ok = open_container(reader, &attributes, is_page);
    else if (!reader->in_defs)
        ok = read_shape(reader, name, &attributes);
    return ok && (!is_empty || end_element(reader, name));
}

/* ---- to mm ---------------------------------------------------------------------------------- */

static bool scale_points(struct reader *reader, uint32_t first_point)
{
    const struct page *page = &reader->page;
    const bool center = reader->params->center && reader->box.lo.x <= reader->box.hi.x;
    const double x = center ? (reader->box.lo.x + reader->box.hi.x) / 2 : -page->align[0];
    const double y =
        center ? (reader->box.lo.y + reader->box.hi.y) / 2 : page->height - page->align[1];
    for (size_t i = first_point; i < reader->drawing->points.num; i++) {
        struct csg_vec2 *p = &reader->drawing->points.data[i];
        p->x = page->scale[0] * (-page->origin[0] + p->x) - x;
        p->y = page->scale[1] * (-page->origin[1] - p->y) + y;
        if (!isfinite(p->x + p->y))
            return fail(reader, CSG_SVG_FOREIGN);
    }
    return true;
}

static enum csg_svg_result result_of(enum csg_xml_result result)
{
    if (result == CSG_XML_MALFORMED)
        return CSG_SVG_MALFORMED;
    if (result == CSG_XML_ENTITY)
        return CSG_SVG_ENTITY;
    return result == CSG_XML_DONE ? CSG_SVG_DONE : CSG_SVG_NO_MEMORY;
}

enum csg_svg_result csg_svg_read(const struct csg_bytes *bytes, const struct csg_svg_params *params,
                                 struct csg_drawing *drawing, struct csg_xml_error *error)
{
    struct reader reader = {.params = params,
                            .drawing = drawing,
                            .page = {.scale = {1, 1}},
                            .paths = {.clip = params->clip},
                            .box = csg_box_empty};
    const struct csg_xml_sink sink = {.user = &reader, .begin = begin_element, .end = end_element};
    const uint32_t draw = (uint32_t)drawing->nodes.num, point = (uint32_t)drawing->points.num;
    const enum csg_xml_result result =
        params->xml->read(bytes->data, bytes->num, NULL, &sink, error);
    if (result != CSG_XML_DONE)
        fail(&reader, result_of(result));
    else
        scale_points(&reader, point);
    if (reader.result != CSG_SVG_DONE)
        csg_drawing_cut(drawing, draw);
    csg_svg_paths_finish(&reader.paths);
    free(reader.maps.data);
    free(reader.containers.data);
    free(reader.stack.data);
    return reader.result;
}
