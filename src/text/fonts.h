/* SPDX-License-Identifier: MIT */
#ifndef CSG_TEXT_FONTS_H
#define CSG_TEXT_FONTS_H

/* The machine's fonts and those that were added, found by name as OpenSCAD finds them. */

#include <ft2build.h>
#include FT_FREETYPE_H

#include "text/module.h"

/* OpenSCAD's size of glyphs in FreeType. */
#define CSG_FONT_SIZE 1e5

/* As in struct csg_text_module. */
struct csg_fonts *csg_fonts_create(void);
void csg_fonts_destroy(struct csg_fonts *fonts);
bool csg_fonts_add(struct csg_fonts *fonts, const char *path);
void csg_fonts_list(const struct csg_fonts *fonts, void *user, csg_font_file_fn *file);

/* The face of that name, "" being OpenSCAD's default, until the next call; NULL: there is none. */
FT_Face csg_fonts_select(struct csg_fonts *fonts, const char *font);

#endif
