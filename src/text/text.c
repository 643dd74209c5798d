/* SPDX-License-Identifier: MIT */
/*
 * csgcast-text.so: outlines of text, the same that OpenSCAD 2021.01 draws (FontCache.cc,
 * FreetypeRenderer.cc and DrawingCallback.cc of its sources): fontconfig finds the font, HarfBuzz
 * places the glyphs and FreeType has their outlines, with hinting, at a size of 1e5.
 */
#include "text/module.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_GLYPH_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_IDS_H
#include <hb-ft.h>
#include <hb.h>

static const char default_font[] = "Liberation Sans:style=Regular";

/* OpenSCAD's sizes: of the glyphs in FreeType, and of what is drawn. */
static const double char_size = 1e5, unscale = 1 / 1.024e5;

struct csg_fonts {
    FcConfig *config;
    FT_Library library;
    char *name; /* of the face at hand, as asked for; NULL: none */
    FT_Face face;
};

/* ---- fonts -------------------------------------------------------------------------------- */

static void destroy(struct csg_fonts *fonts)
{
    if (!fonts)
        return;
    if (fonts->face)
        FT_Done_Face(fonts->face);
    if (fonts->library)
        FT_Done_FreeType(fonts->library);
    if (fonts->config)
        FcConfigDestroy(fonts->config);
    free(fonts->name);
    free(fonts);
}

/* Besides the system's fonts OpenSCAD takes those in ~/.fonts and in OPENSCAD_FONT_PATH. */
static void add_folders(FcConfig *config)
{
    const char *home = getenv("HOME"), *path = getenv("OPENSCAD_FONT_PATH");
    char folder[PATH_MAX];
    if (home && snprintf(folder, sizeof folder, "%s/.fonts", home) < (int)sizeof folder)
        FcConfigAppFontAddDir(config, (const FcChar8 *)folder);
    while (path && *path) {
        const size_t length = strcspn(path, ":");
        if (length > 0 && length < sizeof folder) {
            snprintf(folder, sizeof folder, "%.*s", (int)length, path);
            FcConfigAppFontAddDir(config, (const FcChar8 *)folder);
        }
        path += length + (path[length] == ':');
    }
}

static struct csg_fonts *create(void)
{
    struct csg_fonts *fonts = calloc(1, sizeof *fonts);
    if (!fonts)
        return NULL;
    fonts->config = FcInitLoadConfig();
    if (fonts->config && FT_Init_FreeType(&fonts->library) == 0) {
        add_folders(fonts->config);
        FcConfigBuildFonts(fonts->config);
        return fonts;
    }
    destroy(fonts);
    return NULL;
}

static bool add(struct csg_fonts *fonts, const char *path)
{
    return FcConfigAppFontAddFile(fonts->config, (const FcChar8 *)path) == FcTrue;
}

static void list_configuration(FcConfig *config, void *user, csg_font_file_fn *file)
{
    FcStrList *names = FcConfigGetConfigFiles(config);
    const FcChar8 *name;
    while (names && (name = FcStrListNext(names)))
        file(user, (const char *)name);
    if (names)
        FcStrListDone(names);
}

static void list(const struct csg_fonts *fonts, void *user, csg_font_file_fn *file)
{
    static const FcSetName sets[] = {FcSetSystem, FcSetApplication};
    list_configuration(fonts->config, user, file);
    for (size_t i = 0; i < sizeof sets / sizeof *sets; i++) {
        const FcFontSet *set = FcConfigGetFonts(fonts->config, sets[i]);
        FcChar8 *name;
        for (int j = 0; set && j < set->nfont; j++)
            if (FcPatternGetString(set->fonts[j], FC_FILE, 0, &name) == FcResultMatch)
                file(user, (const char *)name);
    }
}

static bool try_charmap(FT_Face face, int platform, int encoding)
{
    for (int i = 0; i < face->num_charmaps; i++) {
        FT_CharMap charmap = face->charmaps[i];
        if (charmap->platform_id == platform &&
            (encoding < 0 || charmap->encoding_id == encoding) &&
            FT_Set_Charmap(face, charmap) == 0)
            return true;
    }
    return false;
}

static void select_charmap(FT_Face face)
{
    static const int others[][2] = {{TT_PLATFORM_MICROSOFT, TT_MS_ID_UNICODE_CS},
                                    {TT_PLATFORM_ISO, TT_ISO_ID_10646},
                                    {TT_PLATFORM_APPLE_UNICODE, -1},
                                    {TT_PLATFORM_MICROSOFT, TT_MS_ID_SYMBOL_CS},
                                    {TT_PLATFORM_MACINTOSH, TT_MAC_ID_ROMAN},
                                    {TT_PLATFORM_ISO, TT_ISO_ID_8859_1},
                                    {TT_PLATFORM_ISO, TT_ISO_ID_7BIT_ASCII}};
    bool done = FT_Select_Charmap(face, FT_ENCODING_UNICODE) == 0;
    for (size_t i = 0; i < sizeof others / sizeof others[0] && !done; i++)
        done = try_charmap(face, others[i][0], others[i][1]);
}

static FT_Face open_match(const struct csg_fonts *fonts, const FcPattern *match)
{
    FcChar8 *file;
    int index;
    FT_Face face = NULL;
    if (FcPatternGetString(match, FC_FILE, 0, &file) != FcResultMatch ||
        FcPatternGetInteger(match, FC_INDEX, 0, &index) != FcResultMatch ||
        FT_New_Face(fonts->library, (const char *)file, index, &face) != 0)
        return NULL;
    select_charmap(face);
    return face;
}

static FT_Face find_face(const struct csg_fonts *fonts, const char *name)
{
    FcPattern *pattern = FcNameParse((const FcChar8 *)name);
    FT_Face face = NULL;
    FcResult result;
    if (!pattern)
        return NULL;
    FcPatternAddBool(pattern, FC_OUTLINE, FcTrue);
    FcPatternAddBool(pattern, FC_SCALABLE, FcTrue);
    FcConfigSubstitute(fonts->config, pattern, FcMatchPattern);
    FcDefaultSubstitute(pattern);
    FcPattern *match = FcFontMatch(fonts->config, pattern, &result);
    if (match) {
        face = open_match(fonts, match);
        FcPatternDestroy(match);
    }
    FcPatternDestroy(pattern);
    return face;
}

/* Blanks around the name do not count. */
static char *copy_name(const char *font)
{
    static const char blanks[] = " \t\n\v\f\r";
    font += strspn(font, blanks);
    size_t length = strlen(font);
    while (length > 0 && strchr(blanks, font[length - 1]))
        length--;
    char *name = malloc(length + sizeof default_font);
    if (name)
        memcpy(name, font, length);
    if (name && length == 0)
        memcpy(name, default_font, sizeof default_font);
    else if (name)
        name[length] = '\0';
    return name;
}

/* Scenes draw most of their text in one font, so the last one is kept. */
static bool select_face(struct csg_fonts *fonts, const char *font)
{
    char *name = copy_name(font);
    if (name && fonts->name && strcmp(name, fonts->name) == 0) {
        free(name);
        return fonts->face != NULL;
    }
    if (fonts->face)
        FT_Done_Face(fonts->face);
    free(fonts->name);
    fonts->name = name;
    fonts->face = name ? find_face(fonts, name) : NULL;
    return fonts->face && FT_Set_Char_Size(fonts->face, 0, (FT_F26Dot6)char_size, 100, 100) == 0;
}

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
    if (!select_face(fonts, text->font))
        return CSG_TEXT_NO_FONT;
    hb_buffer_t *buffer = hb_buffer_create();
    shape(fonts->face, text, buffer);
    const bool ok = draw_buffer(fonts->face, buffer, text, sink);
    hb_buffer_destroy(buffer);
    return ok ? CSG_TEXT_DONE : CSG_TEXT_ENDED;
}

extern const struct csg_text_module CSG_TEXT_MODULE;
__attribute__((visibility("default"))) const struct csg_text_module CSG_TEXT_MODULE = {
    .create = create, .destroy = destroy, .add = add, .outline = outline, .list = list};
