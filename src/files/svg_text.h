/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_SVG_TEXT_H
#define CSG_FILES_SVG_TEXT_H

/* What stands in the attributes of SVG, as OpenSCAD 2021.01 understands it. */

#include <stdbool.h>
#include <stddef.h>

/* A part of an attribute. */
struct csg_svg_word {
    const char *at;
    size_t length;
};

/* A whole word as a number; what is none is 0. */
double csg_svg_number(struct csg_svg_word word);

/* The next word between blanks and commas; of the characters in commands each is a word by itself.
 * false: there is none. */
bool csg_svg_next_word(const char **at, const char *commands, struct csg_svg_word *word);

enum csg_svg_unit {
    CSG_SVG_UNDEFINED, /* no length */
    CSG_SVG_NONE,
    CSG_SVG_PX,
    CSG_SVG_PT,
    CSG_SVG_PC,
    CSG_SVG_IN,
    CSG_SVG_CM,
    CSG_SVG_MM,
    CSG_SVG_RELATIVE, /* em, ex, % */
};

struct csg_svg_length {
    double number;
    enum csg_svg_unit unit;
};

struct csg_svg_length csg_svg_length(const char *text);

/* x, y, width and height. false: it is none. */
bool csg_svg_view_box(const char *text, double box[4]);

/* preserveAspectRatio. */
struct csg_svg_alignment {
    double x, y;   /* the share of the free room that is before the drawing */
    bool is_none;  /* width and height are scaled by themselves */
    bool is_slice; /* the larger scale counts, else the smaller one */
};

struct csg_svg_alignment csg_svg_alignment(const char *text);

/* The value of a property in a style attribute; its length is 0 where there is none. */
struct csg_svg_word csg_svg_style(const char *style, const char *property);

/* The map of a point is m[0] x + m[1] y + m[2], m[3] x + m[4] y + m[5]. */
struct csg_svg_map {
    double m[6];
};

/* Hands over the maps of a transform attribute, the outermost first. false: take was false. */
bool csg_svg_transform(const char *text, void *user,
                       bool (*take)(void *user, const struct csg_svg_map *map));

#endif
