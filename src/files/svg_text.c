/* SPDX-License-Identifier: MIT */
#include "files/svg_text.h"

#include <string.h>

#include "common/number.h"

static bool is_separator(char c)
{
    return c == ' ' || c == ',';
}

static bool is_command(char c, const char *commands)
{
    return strchr(commands, c) != NULL;
}

double csg_svg_number(struct csg_svg_word word)
{
    double number;
    return csg_number_read_signed(word.at, word.length, &number) ? number : 0;
}

bool csg_svg_next_word(const char **at, const char *commands, struct csg_svg_word *word)
{
    const char *c = *at;
    while (is_separator(*c))
        c++;
    word->at = c;
    if (*c && is_command(*c, commands))
        c++;
    else
        while (*c && !is_separator(*c) && !is_command(*c, commands))
            c++;
    word->length = (size_t)(c - word->at);
    *at = c;
    return word->length > 0;
}

/* ---- numbers at the beginning of a text ----------------------------------------------------- */

static void skip_blanks(const char **at)
{
    while (**at == ' ' || (**at >= '\t' && **at <= '\r'))
        ++*at;
}

static const char *skip_digits(const char *at)
{
    while (*at >= '0' && *at <= '9')
        at++;
    return at;
}

/* The longest number at the beginning. */
static bool read_number(const char **at, double *number)
{
    const char *begin = *at, *end = begin + (*begin == '-' || *begin == '+');
    end = skip_digits(end);
    if (*end == '.')
        end = skip_digits(end + 1);
    if (*end == 'e' || *end == 'E') {
        const char *digits = end + 1 + (end[1] == '-' || end[1] == '+');
        if (skip_digits(digits) > digits)
            end = skip_digits(digits);
    }
    *at = end;
    return csg_number_read_signed(begin, (size_t)(end - begin), number);
}

/* Takes the text where it stands next. */
static bool skip_text(const char **at, const char *text)
{
    const size_t length = strlen(text);
    if (strncmp(*at, text, length) != 0)
        return false;
    *at += length;
    return true;
}

/* ---- the page ------------------------------------------------------------------------------- */

struct csg_svg_length csg_svg_length(const char *text)
{
    static const struct {
        const char *name;
        enum csg_svg_unit unit;
    } units[] = {{"em", CSG_SVG_RELATIVE}, {"ex", CSG_SVG_RELATIVE}, {"px", CSG_SVG_PX},
                 {"in", CSG_SVG_IN},       {"cm", CSG_SVG_CM},       {"mm", CSG_SVG_MM},
                 {"pt", CSG_SVG_PT},       {"pc", CSG_SVG_PC},       {"%", CSG_SVG_RELATIVE}};
    struct csg_svg_length length = {0, CSG_SVG_NONE};
    skip_blanks(&text);
    if (!read_number(&text, &length.number))
        return (struct csg_svg_length){0, CSG_SVG_UNDEFINED};
    skip_blanks(&text);
    for (size_t i = 0; i < sizeof units / sizeof *units && length.unit == CSG_SVG_NONE; i++)
        if (skip_text(&text, units[i].name))
            length.unit = units[i].unit;
    skip_blanks(&text);
    return *text ? (struct csg_svg_length){0, CSG_SVG_UNDEFINED} : length;
}

bool csg_svg_view_box(const char *text, double box[4])
{
    for (int i = 0; i < 4; i++) {
        skip_blanks(&text);
        if (i > 0 && skip_text(&text, ","))
            skip_blanks(&text);
        if (!read_number(&text, &box[i]))
            return false;
    }
    skip_blanks(&text);
    return !*text && box[2] >= 0 && box[3] >= 0;
}

/* "Min", "Mid" or "Max". */
static bool read_share(const char **at, double *share)
{
    *share = skip_text(at, "Min") ? 0 : skip_text(at, "Mid") ? 0.5 : 1;
    return *share < 1 || skip_text(at, "Max");
}

struct csg_svg_alignment csg_svg_alignment(const char *text)
{
    static const struct csg_svg_alignment standard = {.x = 0.5, .y = 0.5};
    struct csg_svg_alignment alignment = {0};
    skip_blanks(&text);
    skip_text(&text, "defer");
    skip_blanks(&text);
    alignment.is_none = skip_text(&text, "none");
    if (!alignment.is_none && !(skip_text(&text, "x") && read_share(&text, &alignment.x) &&
                                skip_text(&text, "Y") && read_share(&text, &alignment.y)))
        return standard;
    skip_blanks(&text);
    alignment.is_slice = skip_text(&text, "slice");
    if (!alignment.is_slice)
        skip_text(&text, "meet");
    skip_blanks(&text);
    return *text ? standard : alignment;
}

/* ---- styles --------------------------------------------------------------------------------- */

struct csg_svg_word csg_svg_style(const char *style, const char *property)
{
    const size_t length = strlen(property);
    while (*style) {
        const size_t all = strcspn(style, ";");
        const char *value = style + length + 1;
        if (all > length && strncmp(style, property, length) == 0 && style[length] == ':' &&
            !memchr(value, ':', all - length - 1))
            return (struct csg_svg_word){value, all - length - 1};
        style += all + (style[all] == ';');
    }
    return (struct csg_svg_word){style, 0};
}
