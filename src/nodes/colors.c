/* SPDX-License-Identifier: MIT */
#include "nodes/colors.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

struct named_color {
    const char *name;
    uint32_t rgb; /* 0xRRGGBB */
};

static const struct named_color named_colors[] = {
#define CSG_COLOR(name, rgb) {#name, rgb},
#include "nodes/colors.def"
#undef CSG_COLOR
};

enum { num_named_colors = sizeof named_colors / sizeof named_colors[0] };

static void set_rgb(float color[4], uint32_t rgb)
{
    for (int i = 0; i < 3; i++)
        color[i] = (float)(rgb >> (16 - 8 * i) & 0xFF) / 255.0f;
}

/* Case does not count in colour names. */
static bool matches(const char *name, const char *text)
{
    for (; *name && *text; name++, text++)
        if (*name != (*text >= 'A' && *text <= 'Z' ? *text - 'A' + 'a' : *text))
            return false;
    return *name == *text;
}

static bool read_name(const char *text, float color[4])
{
    for (size_t i = 0; i < num_named_colors; i++)
        if (matches(named_colors[i].name, text)) {
            set_rgb(color, named_colors[i].rgb);
            return true;
        }
    if (!matches("transparent", text))
        return false;
    memset(color, 0, 4 * sizeof *color);
    return true;
}

static int hex_value(char c)
{
    static const char digits[] = "0123456789abcdef";
    const char *found = c ? strchr(digits, c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c) : NULL;
    return found ? (int)(found - digits) : -1;
}

/* One or two digits for each of three or four components. */
static bool read_hex(const char *text, float color[4])
{
    const size_t length = strlen(text);
    if (text[0] != '#' || (length != 4 && length != 5 && length != 7 && length != 9))
        return false;
    const size_t digits = length > 5 ? 2 : 1;
    for (size_t i = 0; i < (length - 1) / digits; i++) {
        const int high = hex_value(text[1 + i * digits]);
        const int low = hex_value(text[1 + i * digits + digits - 1]);
        if (high < 0 || low < 0)
            return false;
        color[i] = (float)(high * 16 + low) / 255.0f;
    }
    return true;
}

/* Entries that are missing or no numbers stay as they are, as in OpenSCAD. */
static void read_vector(const struct csg_value *vector, float color[4])
{
    for (size_t i = 0; i < 4 && i < vector->num; i++) {
        const struct csg_value *item = &vector->items[i];
        if (item->type == CSG_VALUE_NUMBER)
            color[i] = item->number > -1 ? (float)fmin(item->number, 1e6) : -1.0f;
    }
}

bool csg_color_read(const struct csg_args *args, float color[4])
{
    const struct csg_value *c = csg_args_find(args, "c");
    color[0] = color[1] = color[2] = -1;
    color[3] = 1;
    if (c && c->type == CSG_VALUE_VECTOR)
        read_vector(c, color);
    else if (c && !(c->type == CSG_VALUE_STRING &&
                    (read_hex(c->string, color) || read_name(c->string, color))))
        return csg_args_error(args, "c must be [r, g, b, a] with numbers from 0 to 1, \"#rrggbb\" "
                                    "or the name of a CSS colour"),
               false;
    color[3] = (float)csg_args_number(args, "alpha", (double)color[3], NULL);
    return true;
}
