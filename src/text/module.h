/* SPDX-License-Identifier: MIT */
#ifndef CSG_TEXT_MODULE_H
#define CSG_TEXT_MODULE_H

/*
 * The border between libcsgcast and csgcast-text.so, which wraps FreeType, HarfBuzz and fontconfig:
 * a dozen shared libraries that only scenes with text() need.
 */

#include <stdbool.h>

/* One text(), its parameters as in OpenSCAD; no string is NULL. */
struct csg_text {
    const char *text; /* UTF-8 */
    const char *font; /* as fontconfig reads names; empty: Liberation Sans */
    const char *direction, *language, *script;
    const char *halign, *valign;
    double size, spacing;
    int segments; /* of each curve */
};

/* Takes the outlines, glyph by glyph; a contour's last point may be its first. false ends it. */
struct csg_text_sink {
    void *user;
    bool (*begin_glyph)(void *user);
    bool (*begin_contour)(void *user);
    bool (*add_point)(void *user, double x, double y);
};

enum csg_text_result {
    CSG_TEXT_DONE,
    CSG_TEXT_NO_FONT, /* fontconfig or FreeType found none; nothing is drawn */
    CSG_TEXT_ENDED,   /* by the sink */
};

typedef void csg_font_file_fn(void *user, const char *path);

/* The fonts of this machine; belongs to one thread at a time. */
struct csg_fonts;

struct csg_text_module {
    struct csg_fonts *(*create)(void); /* NULL: no memory, or fontconfig has no configuration */
    void (*destroy)(struct csg_fonts *fonts);
    /* One more font, before the first outline; false: it cannot be read, or is none. */
    bool (*add)(struct csg_fonts *fonts, const char *path);
    enum csg_text_result (*outline)(struct csg_fonts *fonts, const struct csg_text *text,
                                    const struct csg_text_sink *sink);
    /* Names each file that outlines may depend on: all fonts, and what fontconfig has read. */
    void (*list)(const struct csg_fonts *fonts, void *user, csg_font_file_fn *file);
};

/* The module's one symbol, a const struct csg_text_module, named with the version of this border.
 */
#define CSG_TEXT_MODULE csg_text_module_3
#define CSG_TEXT_MODULE_NAME "csg_text_module_3"

#endif
