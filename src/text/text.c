/* SPDX-License-Identifier: MIT */
/*
 * csgcast-text.so: outlines of text, the same that OpenSCAD 2021.01 draws (FontCache.cc,
 * FreetypeRenderer.cc and DrawingCallback.cc of its sources): fontconfig finds the font, HarfBuzz
 * places the glyphs and FreeType has their outlines, with hinting, at a size of 1e5.
 */
#include "text/fonts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_GLYPH_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_IDS_H
#include <hb-ft.h>
#include <hb.h>

/* OpenSCAD's sizes: of the glyphs in FreeType, and of what is drawn. */
static const double char_size = CSG_FONT_SIZE, unscale = 1 / 1.024e5;

/* ---- shaping ------------------------------------------------------------------------------ */

static bool is_no_script(hb_script_t script)
{
    return script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED ||
           script == HB_SCRIPT_UNKNOWN || script == HB_SCRIPT_INVALID;
}

/* The one script of all characters that have one. */
static hb_script_t detect_script(hb_buffer_t *buffer)
{
    unsigned num;
    const hb_glyph_info_t *infos = hb_buffer_get_glyph_infos(buffer, &num);
    hb_script_t script = HB_SCRIPT_INVALID;
    for (unsigned i = 0; i < num; i++) {
        const hb_script_t of =
            hb_unicode_script(hb_unicode_funcs_get_default(), infos[i].codepoint);
        if (!is_no_script(of))
            script = script == HB_SCRIPT_INVALID || script == of ? of : HB_SCRIPT_UNKNOWN;
    }
    return script;
}

/* Symbol fonts have their characters from here on. */
enum { first_symbol = 0xf000 };

static void add_symbols(hb_buffer_t *buffer, const char *text)
{
    hb_buffer_t *decoded = hb_buffer_create();
    unsigned num;
    hb_buffer_add_utf8(decoded, text, -1, 0, -1);
    const hb_glyph_info_t *infos = hb_buffer_get_glyph_infos(decoded, &num);
    for (unsigned i = 0; i < num; i++) {
        const hb_codepoint_t c = infos[i].codepoint;
        const uint32_t symbol = c < 0x100 ? c + first_symbol : c;
        hb_buffer_add_utf32(buffer, &symbol, 1, 0, 1);
    }
    hb_buffer_destroy(decoded);
}

static bool is_symbol_font(FT_Face face)
{
    FT_UInt glyph = 0;
    return face->charmap && face->charmap->platform_id == TT_PLATFORM_MICROSOFT &&
           face->charmap->encoding_id == TT_MS_ID_SYMBOL_CS &&
           FT_Get_First_Char(face, &glyph) >= first_symbol && glyph != 0;
}

static void shape(FT_Face face, const struct csg_text *text, hb_buffer_t *buffer)
{
    if (is_symbol_font(face))
        add_symbols(buffer, text->text);
    else
        hb_buffer_add_utf8(buffer, text->text, -1, 0, -1);
    hb_script_t script = hb_script_from_string(text->script, -1);
    if (script == HB_SCRIPT_INVALID)
        script = detect_script(buffer);
    hb_direction_t direction = hb_direction_from_string(text->direction, -1);
    if (direction == HB_DIRECTION_INVALID)
        direction = hb_script_get_horizontal_direction(script);
    hb_buffer_set_direction(buffer, direction);
    hb_buffer_set_script(buffer, is_no_script(script) ? HB_SCRIPT_INVALID : script);
    hb_buffer_set_language(buffer, hb_language_from_string(text->language, -1));
    hb_font_t *font = hb_ft_font_create(face, NULL);
    hb_shape(font, buffer, NULL, 0);
    hb_font_destroy(font);
}

/* ---- placing ------------------------------------------------------------------------------ */

struct extent {
    double width, ascend, descend;
};

struct placed {
    FT_Glyph glyph; /* NULL: could not be loaded, is left out */
    const hb_glyph_position_t *position;
};

static void add_extent(struct extent *extent, const struct placed *placed, bool is_horizontal,
                       double spacing)
{
    FT_BBox box;
    FT_Glyph_Get_CBox(placed->glyph, FT_GLYPH_BBOX_GRIDFIT, &box);
    if (is_horizontal) {
        extent->width += placed->position->x_advance * unscale * spacing;
        extent->ascend = fmax(extent->ascend, (double)box.yMax * unscale);
        extent->descend = fmax(extent->descend, (double)-box.yMin * unscale);
    } else {
        extent->width = fmax(extent->width, (double)(box.xMax - box.xMin) * unscale);
        extent->ascend += placed->position->y_advance * unscale * spacing;
    }
}

static double align_x(const char *halign, const struct extent *extent)
{
    if (strcmp(halign, "right") == 0)
        return -extent->width;
    return strcmp(halign, "center") == 0 ? -extent->width / 2 : 0;
}

static double align_y(const char *valign, const struct extent *extent)
{
    if (strcmp(valign, "top") == 0)
        return -extent->ascend;
    if (strcmp(valign, "center") == 0)
        return extent->descend / 2 - extent->ascend / 2;
    return strcmp(valign, "bottom") == 0 ? extent->descend : 0;
}

/* ---- outlines ----------------------------------------------------------------------------- */

struct point {
    double x, y;
};

struct pen {
    const struct csg_text_sink *sink;
    double size;
    int segments;
    struct point at, origin;
};

static struct point point_of(const FT_Vector *v)
{
    return (struct point){(double)v->x / char_size, (double)v->y / char_size};
}

/* FreeType goes on while this is 0. */
static int add_point(const struct pen *pen, struct point p)
{
    return pen->sink->add_point(pen->sink->user, pen->size * (p.x + pen->origin.x),
                                pen->size * (p.y + pen->origin.y))
               ? 0
               : 1;
}

static int line_to(const FT_Vector *to, void *user)
{
    struct pen *pen = user;
    pen->at = point_of(to);
    return add_point(pen, pen->at);
}

static int move_to(const FT_Vector *to, void *user)
{
    const struct pen *pen = user;
    return pen->sink->begin_contour(pen->sink->user) ? line_to(to, user) : 1;
}

static int cubic_to(const FT_Vector *c1, const FT_Vector *c2, const FT_Vector *to, void *user)
{
    struct pen *pen = user;
    const struct point p0 = pen->at, p1 = point_of(c1), p2 = point_of(c2), p3 = point_of(to);
    int ended = 0;
    for (int i = 1; i <= pen->segments && !ended; i++) {
        const double a = i * (1.0 / pen->segments), b = 1 - a;
        const double w0 = b * b * b, w1 = 3 * b * b * a, w2 = 3 * b * a * a, w3 = a * a * a;
        ended = add_point(pen, (struct point){w0 * p0.x + w1 * p1.x + w2 * p2.x + w3 * p3.x,
                                              w0 * p0.y + w1 * p1.y + w2 * p2.y + w3 * p3.y});
    }
    pen->at = p3;
    return ended;
}

static int conic_to(const FT_Vector *c, const FT_Vector *to, void *user)
{
    struct pen *pen = user;
    const struct point p0 = pen->at, p1 = point_of(c), p2 = point_of(to);
    int ended = 0;
    for (int i = 1; i <= pen->segments && !ended; i++) {
        const double a = i * (1.0 / pen->segments), b = 1 - a;
        ended = add_point(pen, (struct point){b * b * p0.x + 2 * b * a * p1.x + a * a * p2.x,
                                              b * b * p0.y + 2 * b * a * p1.y + a * a * p2.y});
    }
    pen->at = p2;
    return ended;
}

static bool draw_glyph(struct pen *pen, FT_Glyph glyph)
{
    static const FT_Outline_Funcs funcs = {
        .move_to = move_to, .line_to = line_to, .conic_to = conic_to, .cubic_to = cubic_to};
    if (!pen->sink->begin_glyph(pen->sink->user))
        return false;
    return glyph->format != FT_GLYPH_FORMAT_OUTLINE ||
           FT_Outline_Decompose(&((FT_OutlineGlyph)glyph)->outline, &funcs, pen) == 0;
}

/* Glyphs follow each other by their advances; the offsets are for this glyph alone. */
static bool draw(const struct placed *placed, unsigned num, const struct csg_text *text,
                 const struct extent *extent, const struct csg_text_sink *sink)
{
    struct pen pen = {.sink = sink, .size = text->size, .segments = text->segments};
    const double x = align_x(text->halign, extent), y = align_y(text->valign, extent);
    double advance_x = 0, advance_y = 0;
    bool ok = true;
    for (unsigned i = 0; i < num && ok; i++) {
        const hb_glyph_position_t *position = placed[i].position;
        if (!placed[i].glyph)
            continue;
        pen.origin.x = x + position->x_offset * unscale + advance_x;
        pen.origin.y = y + position->y_offset * unscale + advance_y;
        ok = draw_glyph(&pen, placed[i].glyph);
        advance_x += position->x_advance * unscale * text->spacing;
        advance_y += position->y_advance * unscale * text->spacing;
    }
    return ok;
}

static void load_glyphs(FT_Face face, hb_buffer_t *buffer, struct placed *placed, unsigned num)
{
    const hb_glyph_info_t *infos = hb_buffer_get_glyph_infos(buffer, NULL);
    const hb_glyph_position_t *positions = hb_buffer_get_glyph_positions(buffer, NULL);
    for (unsigned i = 0; i < num; i++) {
        placed[i].position = &positions[i];
        if (FT_Load_Glyph(face, infos[i].codepoint, FT_LOAD_DEFAULT) != 0 ||
            FT_Get_Glyph(face->glyph, &placed[i].glyph) != 0)
            placed[i].glyph = NULL;
    }
}

static bool draw_buffer(FT_Face face, hb_buffer_t *buffer, const struct csg_text *text,
                        const struct csg_text_sink *sink)
{
    const unsigned num = hb_buffer_get_length(buffer);
    struct placed *placed = calloc(num + 1, sizeof *placed);
    const bool is_horizontal = HB_DIRECTION_IS_HORIZONTAL(hb_buffer_get_direction(buffer));
    struct extent extent = {0};
    if (!placed)
        return false;
    load_glyphs(face, buffer, placed, num);
    for (unsigned i = 0; i < num; i++)
        if (placed[i].glyph)
            add_extent(&extent, &placed[i], is_horizontal, text->spacing);
    const bool ok = draw(placed, num, text, &extent, sink);
    for (unsigned i = 0; i < num; i++)
        if (placed[i].glyph)
            FT_Done_Glyph(placed[i].glyph);
    free(placed);
    return ok;
}

static enum csg_text_result outline(struct csg_fonts *fonts, const struct csg_text *text,
                                    const struct csg_text_sink *sink)
{
    const FT_Face face = csg_fonts_select(fonts, text->font);
    if (!face)
        return CSG_TEXT_NO_FONT;
    hb_buffer_t *buffer = hb_buffer_create();
    shape(face, text, buffer);
    const bool ok = draw_buffer(face, buffer, text, sink);
    hb_buffer_destroy(buffer);
    return ok ? CSG_TEXT_DONE : CSG_TEXT_ENDED;
}

extern const struct csg_text_module CSG_TEXT_MODULE;
__attribute__((visibility("default")))
const struct csg_text_module CSG_TEXT_MODULE = {.create = csg_fonts_create,
                                                .destroy = csg_fonts_destroy,
                                                .add = csg_fonts_add,
                                                .outline = outline,
                                                .list = csg_fonts_list};
