/* SPDX-License-Identifier: MIT */
#include "files/svg_shape.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "files/svg_text.h"
#include "solids/facets.h"

enum { ellipse_points = 40 };

/* A rectangle's corners are round from there on; a stroke that is thinner has width 1. */
static const double min_radius = 1e-8, min_width = 0.01;

const char *csg_svg_find(const struct csg_svg_attributes *attributes, const char *name)
{
    for (size_t i = 0; i < attributes->num; i++)
        if (strcmp(attributes->list[i].name, name) == 0)
            return attributes->list[i].value;
    return "";
}

static struct csg_svg_word word_of(const char *text)
{
    return (struct csg_svg_word){text, strlen(text)};
}

static double number(const struct csg_svg_attributes *attributes, const char *name)
{
    return csg_svg_number(word_of(csg_svg_find(attributes, name)));
}

/* ---- strokes -------------------------------------------------------------------------------- */

/* The attribute, or else the property of the style. */
static struct csg_svg_word find_property(const struct csg_svg_attributes *attributes,
                                         const char *name)
{
    const char *value = csg_svg_find(attributes, name);
    return *value ? word_of(value) : csg_svg_style(csg_svg_find(attributes, "style"), name);
}

static bool is_word(struct csg_svg_word word, const char *text)
{
    return word.length == strlen(text) && memcmp(word.at, text, word.length) == 0;
}

static struct csg_clip_pen pen_of(const struct csg_svg_attributes *attributes)
{
    const double width = csg_svg_number(find_property(attributes, "stroke-width"));
    const struct csg_svg_word cap = find_property(attributes, "stroke-linecap");
    const struct csg_svg_word join = find_property(attributes, "stroke-linejoin");
    return (struct csg_clip_pen){
        .width = width < min_width ? 1 : width,
        .join = is_word(join, "bevel")   ? CSG_CLIP_JOIN_BEVEL
                : is_word(join, "round") ? CSG_CLIP_JOIN_ROUND
                                         : CSG_CLIP_JOIN_MITER,
        .cap = is_word(cap, "butt")    ? CSG_CLIP_CAP_BUTT
               : is_word(cap, "round") ? CSG_CLIP_CAP_ROUND
                                       : CSG_CLIP_CAP_SQUARE,
    };
}

/* ---- shapes --------------------------------------------------------------------------------- */

static void add_path(struct csg_svg_paths *paths, const struct csg_svg_attributes *attributes)
{
    csg_svg_add_data(paths, csg_svg_find(attributes, "d"));
}

static void add_ellipse_of(struct csg_svg_paths *paths, double x, double y, double rx, double ry)
{
    csg_svg_begin_path(paths);
    for (int i = 1; i <= ellipse_points; i++) {
        const double degrees = i * 360.0 / ellipse_points;
        csg_svg_add_point(paths, rx * csg_sin_degrees(degrees) + x,
                          ry * csg_cos_degrees(degrees) + y);
    }
}

static void add_ellipse(struct csg_svg_paths *paths, const struct csg_svg_attributes *attributes)
{
    add_ellipse_of(paths, number(attributes, "cx"), number(attributes, "cy"),
                   number(attributes, "rx"), number(attributes, "ry"));
}

static void add_circle(struct csg_svg_paths *paths, const struct csg_svg_attributes *attributes)
{
    const double r = number(attributes, "r");
    add_ellipse_of(paths, number(attributes, "cx"), number(attributes, "cy"), r, r);
}

static void add_line(struct csg_svg_paths *paths, const struct csg_svg_attributes *attributes)
{
    csg_svg_begin_path(paths);
    csg_svg_add_point(paths, number(attributes, "x1"), number(attributes, "y1"));
    csg_svg_add_point(paths, number(attributes, "x2"), number(attributes, "y2"));
    csg_svg_stroke_path(paths);
}

/* Pairs of numbers; half of one is left out. */
static void add_points(struct csg_svg_paths *paths, const struct csg_svg_attributes *attributes)
{
    const char *text = csg_svg_find(attributes, "points");
    struct csg_svg_word x, y;
    csg_svg_begin_path(paths);
    while (csg_svg_next_word(&text, "", &x) && csg_svg_next_word(&text, "", &y))
        csg_svg_add_point(paths, csg_svg_number(x), csg_svg_number(y));
}

static void add_polyline(struct csg_svg_paths *paths, const struct csg_svg_attributes *attributes)
{
    add_points(paths, attributes);
    csg_svg_stroke_path(paths);
}

struct rectangle {
    double x, y, width, height, rx, ry;
};

/* A number as C++ streams write it, whatever the locale: OpenSCAD makes path data of a rectangle
 * with round corners, with six digits. */
static void print_number(char **at, const char *end, char command, double value)
{
    const int length = snprintf(*at, (size_t)(end - *at), "%c%.6g ", command, value);
    for (char *c = *at + 1; c < *at + length; c++)
        if (!strchr("0123456789+-e ", *c))
            *c = '.';
    *at += length;
}

/* At most six numbers behind a command. */
static void print_data(char **at, const char *end, char command, const double *numbers, int num)
{
    for (int i = 0; i < num; i++)
        print_number(at, end, i == 0 ? command : ',', numbers[i]);
}

static void add_round_rectangle(struct csg_svg_paths *paths, const struct rectangle *r)
{
    const double left = r->x, right = r->x + r->width, top = r->y, bottom = r->y + r->height;
    const double a = r->x + r->rx, b = r->x + r->width - r->rx;
    const double c = r->y + r->ry, d = r->y + r->height - r->ry;
    const double corners[4][2] = {{right, c}, {b, bottom}, {left, d}, {a, top}};
    const double sides[4] = {b, d, a, c};
    char text[1024], *at = text; /* each of some 40 numbers takes up to 14 characters */
    const char *end = text + sizeof text;
    print_data(&at, end, 'M', (const double[]){a, top}, 2);
    for (int i = 0; i < 4; i++) {
        print_data(&at, end, i % 2 == 0 ? 'H' : 'V', &sides[i], 1);
        print_data(&at, end, 'A',
                   (const double[]){r->rx, r->ry, 0, 0, 1, corners[i][0], corners[i][1]}, 7);
    }
    snprintf(at, (size_t)(end - at), "z");
    csg_svg_add_data(paths, text);
}

static void add_rectangle(struct csg_svg_paths *paths, const struct csg_svg_attributes *attributes)
{
    struct rectangle r = {number(attributes, "x"),     number(attributes, "y"),
                          number(attributes, "width"), number(attributes, "height"),
                          number(attributes, "rx"),    number(attributes, "ry")};
    const bool has_rx = fabs(r.rx) >= min_radius, has_ry = fabs(r.ry) >= min_radius;
    if (has_rx || has_ry) {
        r.rx = fmin(has_rx ? r.rx : r.ry, r.width / 2);
        r.ry = fmin(has_ry ? r.ry : number(attributes, "rx"), r.height / 2);
        add_round_rectangle(paths, &r);
        return;
    }
    csg_svg_begin_path(paths);
    csg_svg_add_point(paths, r.x, r.y);
    csg_svg_add_point(paths, r.x + r.width, r.y);
    csg_svg_add_point(paths, r.x + r.width, r.y + r.height);
    csg_svg_add_point(paths, r.x, r.y + r.height);
}

bool csg_svg_add_shape(struct csg_svg_paths *paths, const char *name,
                       const struct csg_svg_attributes *attributes)
{
    static const struct {
        const char *name;
        void (*add)(struct csg_svg_paths *paths, const struct csg_svg_attributes *attributes);
    } shapes[] = {{"path", add_path},       {"rect", add_rectangle}, {"circle", add_circle},
                  {"ellipse", add_ellipse}, {"line", add_line},      {"polyline", add_polyline},
                  {"polygon", add_points}};
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        if (strcmp(name, shapes[i].name) != 0)
            continue;
        paths->pen = pen_of(attributes);
        shapes[i].add(paths, attributes);
        return true;
    }
    return false;
}
