/* SPDX-License-Identifier: MIT */
#include "nodes/text.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "common/hash.h"
#include "common/module.h"
#include "nodes/figures.h"
#include "nodes/transforms.h"
#include "solids/facets.h"
#include "text/module.h"

/* ---- the module --------------------------------------------------------------------------- */

static void add_fonts(const struct csg_text_state *state, const struct csgcast_scene_params *params,
                      const struct csg_log *log)
{
    for (size_t i = 0; i < params->num_fonts; i++)
        if (!state->module->add(state->fonts, params->fonts[i]))
            csg_log_warning(log, CSGCAST_MESSAGE_FILE, "cannot read the font %s", params->fonts[i]);
}

static bool open_module(struct csg_text_state *state, const struct csgcast_scene_params *params,
                        const struct csg_log *log)
{
    const struct csg_text_module *module =
        csg_module_symbol("csgcast-text.so", "CSGCAST_TEXT_MODULE", CSG_TEXT_MODULE_NAME);
    struct csg_fonts *fonts = module ? module->create() : NULL;
    if (!fonts)
        return false;
    *state = (struct csg_text_state){module, fonts};
    add_fonts(state, params, log);
    return true;
}

void csg_text_finish(struct csg_text_state *state)
{
    if (state->module)
        state->module->destroy(state->fonts);
}

/* Adds up, as fontconfig lists fonts in the order of a folder's entries. */
static void add_file(void *user, const char *path)
{
    uint64_t *sum = user;
    struct stat info;
    if (stat(path, &info) != 0)
        return;
    const int64_t facts[] = {info.st_size, info.st_mtim.tv_sec, info.st_mtim.tv_nsec};
    *sum += csg_hash(csg_hash(CSG_HASH_START, path, strlen(path)), facts, sizeof facts);
}

uint64_t csg_text_fonts(const struct csgcast_scene_params *params)
{
    struct csg_text_state state = {0};
    uint64_t sum = 0;
    if (open_module(&state, params, &csg_log_silent))
        state.module->list(state.fonts, &sum, add_file);
    csg_text_finish(&state);
    return sum;
}

/* ---- glyphs ------------------------------------------------------------------------------- */

struct contour {
    size_t begin, end; /* of its points */
    double area;       /* twice, positive counter-clockwise */
    size_t owner;      /* see find_owner */
};

/* The glyph at hand. */
struct glyph {
    const struct csg_space *space;
    struct csg_drawing *drawing;
    double rounding; /* of points, as a share of their coordinates */
    CSG_ARRAY(struct csg_vec2) points;
    CSG_ARRAY(struct contour) contours;
};

static double twice_area(const struct csg_vec2 *p, size_t num)
{
    double area = 0;
    for (size_t i = 0; i < num; i++) {
        const struct csg_vec2 a = p[i], b = p[i + 1 < num ? i + 1 : 0];
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

/* Crossings of the ray from p to the right. */
static bool is_around(const struct glyph *glyph, const struct contour *contour, struct csg_vec2 p)
{
    bool inside = false;
    for (size_t i = contour->begin; i < contour->end; i++) {
        const struct csg_vec2 a = glyph->points.data[i];
        const struct csg_vec2 b = glyph->points.data[i + 1 < contour->end ? i + 1 : contour->begin];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

static bool add_contour(const struct glyph *glyph, const struct contour *contour)
{
    bool ok = csg_drawing_add_contour(glyph->drawing);
    for (size_t i = contour->begin; i < contour->end && ok; i++) {
        const struct csg_vec2 at = glyph->points.data[i];
        const struct csg_vec3 p = csg_map_point(&glyph->space->map, csg_vec3(at.x, at.y, 0));
        ok = csg_drawing_add_point(glyph->drawing, p.x, p.y);
    }
    return ok;
}

/* The smallest larger contour that goes the other way and has this one in it; num where none has.
 */
static size_t find_owner(const struct glyph *glyph, const struct contour *inner)
{
    const size_t num = glyph->contours.num;
    size_t best = num;
    for (size_t i = 0; i < num; i++) {
        const struct contour *contour = &glyph->contours.data[i];
        if (fabs(contour->area) > fabs(inner->area) && (contour->area > 0) != (inner->area > 0) &&
            is_around(glyph, contour, glyph->points.data[inner->begin]) &&
            (best == num || fabs(contour->area) < fabs(glyph->contours.data[best].area)))
            best = i;
    }
    return best;
}

/* Whether the contour is no hole: of those around it, each in the next, the number is even. */
static bool is_outer(const struct glyph *glyph, size_t i)
{
    bool outer = true;
    for (; glyph->contours.data[i].owner < glyph->contours.num; i = glyph->contours.data[i].owner)
        outer = !outer;
    return outer;
}

static double rounding_of(const struct glyph *glyph, const struct contour *contour)
{
    struct csg_box box = csg_box_empty;
    double size = 0;
    for (size_t i = contour->begin; i < contour->end; i++) {
        const struct csg_vec2 p = glyph->points.data[i];
        size = fmax(size, fmax(fabs(p.x), fabs(p.y)));
        csg_box_extend(&box, csg_vec3(p.x, p.y, 0));
    }
    return glyph->rounding * size * csg_space_stretch(glyph->space) +
           csg_space_rounding(glyph->space, &box);
}

/*
 * OpenSCAD fills what contours wind round in either direction. Holes wind the other way than the
 * contour they are in, and islands in a hole the other way than the hole, so each outer contour
 * with the holes right in it is one figure; figures unite.
 */
static bool add_figures(struct glyph *glyph)
{
    const size_t num = glyph->contours.num;
    bool ok = true;
    for (size_t i = 0; i < num; i++)
        glyph->contours.data[i].owner = find_owner(glyph, &glyph->contours.data[i]);
    for (size_t i = 0; i < num && ok; i++) {
        const struct contour *outer = &glyph->contours.data[i];
        if (!is_outer(glyph, i))
            continue;
        ok = csg_drawing_add_figure(glyph->drawing, rounding_of(glyph, outer)) &&
             add_contour(glyph, outer);
        for (size_t j = 0; j < num && ok; j++)
            if (glyph->contours.data[j].owner == i)
                ok = add_contour(glyph, &glyph->contours.data[j]);
    }
    return ok;
}

static void end_contour(struct glyph *glyph)
{
    if (glyph->contours.num == 0)
        return;
    struct contour *last = &glyph->contours.data[glyph->contours.num - 1];
    last->end = glyph->points.num;
    last->area = twice_area(&glyph->points.data[last->begin], last->end - last->begin);
    if (last->end - last->begin < 3 || last->area == 0)
        glyph->contours.num--;
}

static bool end_glyph(struct glyph *glyph)
{
    end_contour(glyph);
    const bool ok = add_figures(glyph);
    glyph->points.num = glyph->contours.num = 0;
    return ok;
}

static bool begin_glyph(void *user)
{
    return end_glyph(user);
}

static bool begin_contour(void *user)
{
    struct glyph *glyph = user;
    end_contour(glyph);
    return csg_array_push(&glyph->contours, ((struct contour){.begin = glyph->points.num}));
}

static bool add_point(void *user, double x, double y)
{
    struct glyph *glyph = user;
    return csg_array_push(&glyph->points, ((struct csg_vec2){x, y}));
}

/* ---- the node ----------------------------------------------------------------------------- */

static const char *find_string(const struct csg_args *args, const char *name, const char *fallback)
{
    const struct csg_value *value = csg_args_find(args, name);
    return value && value->type == CSG_VALUE_STRING ? value->string : fallback;
}

/* Of one curve. An extrusion cannot have more corners. */
#define MAX_SEGMENTS 20000

/* An eighth of the segments of a circle of radius size for each curve, as OpenSCAD has it. */
static struct csg_text read_text(const struct csg_args *args, double *rounding)
{
    const struct csg_facets facets = csg_args_facets(args);
    struct csg_text text = {.text = find_string(args, "text", ""),
                            .font = find_string(args, "font", ""),
                            .direction = find_string(args, "direction", ""),
                            .language = find_string(args, "language", "en"),
                            .script = find_string(args, "script", ""),
                            .halign = find_string(args, "halign", "left"),
                            .valign = find_string(args, "valign", "baseline"),
                            .spacing = csg_args_number(args, "spacing", 1, NULL)};
    text.size = csg_args_number(args, "size", 10, rounding);
    const int segments = csg_facets_count(&facets, text.size) / 8 + 1;
    text.segments = segments > 2 ? segments : 2;
    return text;
}

static bool add_text(struct csg_walk *walk, uint32_t node, const struct csg_text *text,
                     struct glyph *glyph)
{
    const struct csg_text_state *state = walk->builder->text;
    const struct csg_text_sink sink = {.user = glyph,
                                       .begin_glyph = begin_glyph,
                                       .begin_contour = begin_contour,
                                       .add_point = add_point};
    const enum csg_text_result result = state->module->outline(state->fonts, text, &sink);
    if (result == CSG_TEXT_NO_FONT)
        csg_walk_warning(walk, node,
                         "no font for '%.60s'; nothing is drawn (Debian: "
                         "fonts-liberation)",
                         text->font);
    return (result != CSG_TEXT_ENDED && end_glyph(glyph)) || csg_walk_no_memory(walk);
}

bool csg_figure_text(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                     const struct csg_space *space, struct csg_drawing *drawing)
{
    struct csg_text_state *state = walk->builder->text;
    struct glyph glyph = {.space = space, .drawing = drawing};
    const uint32_t draw = (uint32_t)drawing->nodes.num;
    struct csg_map inverse;
    double rounding = 0;
    bool ok = csg_drawing_open(drawing, CSG_DRAW_UNION) || csg_walk_no_memory(walk);
    const struct csg_text text = read_text(args, &rounding);
    const bool is_there = isfinite(text.size) && text.size != 0 && isfinite(text.spacing) &&
                          text.text[0] && !space->is_empty && csg_map_invert(&space->map, &inverse);
    if (ok && is_there && text.segments > MAX_SEGMENTS) {
        csg_report_error(walk->builder->report, CSGCAST_MESSAGE_SCENE,
                         csg_walk_node(walk, node)->place,
                         "text: $fn makes %d segments of each curve, the most is %d; use a $fn "
                         "below 160000",
                         text.segments, MAX_SEGMENTS);
    } else if (ok && is_there && !state->module &&
               !open_module(state, walk->builder->params, &walk->builder->report->log)) {
        csg_walk_unsupported(walk, node,
                             "text needs csgcast-text.so, which is missing, or lacks its libraries "
                             "(Debian: libfreetype6 libharfbuzz0b libfontconfig1)");
    } else if (ok && is_there) {
        glyph.rounding = rounding / fabs(text.size);
        ok = add_text(walk, node, &text, &glyph);
    }
    csg_drawing_close(drawing, draw);
    free(glyph.points.data);
    free(glyph.contours.data);
    return ok;
}
