/* SPDX-License-Identifier: MIT */
#include "text/fonts.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <fontconfig/fontconfig.h>
#include FT_TRUETYPE_IDS_H

static const char default_font[] = "Liberation Sans:style=Regular";

struct csg_fonts {
    FcConfig *config;
    FT_Library library;
    char *name; /* of the face at hand, as asked for; NULL: none */
    FT_Face face;
};

void csg_fonts_destroy(struct csg_fonts *fonts)
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

struct csg_fonts *csg_fonts_create(void)
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
    csg_fonts_destroy(fonts);
    return NULL;
}

bool csg_fonts_add(struct csg_fonts *fonts, const char *path)
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

void csg_fonts_list(const struct csg_fonts *fonts, void *user, csg_font_file_fn *file)
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
FT_Face csg_fonts_select(struct csg_fonts *fonts, const char *font)
{
    char *name = copy_name(font);
    if (name && fonts->name && strcmp(name, fonts->name) == 0) {
        free(name);
        return fonts->face;
    }
    if (fonts->face)
        FT_Done_Face(fonts->face);
    free(fonts->name);
    fonts->name = name;
    fonts->face = name ? find_face(fonts, name) : NULL;
    const FT_F26Dot6 size = (FT_F26Dot6)CSG_FONT_SIZE;
    return fonts->face && FT_Set_Char_Size(fonts->face, 0, size, 100, 100) == 0 ? fonts->face
                                                                                : NULL;
}
