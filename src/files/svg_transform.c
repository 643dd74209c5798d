/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "files/svg_text.h"
#include "solids/facets.h"

/* OpenSCAD takes the first letter for the name; what is between them are arguments. */
static const struct {
    const char *name;
    char letter;
} names[] = {{"matrix", 'm'}, {"translate", 't'}, {"scale", 's'},
             {"rotate", 'r'}, {"skewX", 'x'},     {"skewY", 'y'}};

enum { num_names = sizeof names / sizeof *names, max_args = 6 };

/* One of a transform's functions. */
struct function {
    char letter; /* 0: none yet */
    double args[max_args];
    size_t num; /* of args, also of those that do not fit */
};

struct taker {
    void *user;
    bool (*take)(void *user, const struct csg_svg_map *map);
};

static bool take(const struct taker *taker, double a, double b, double c, double d, double e,
                 double f)
{
    const struct csg_svg_map map = {{a, b, c, d, e, f}};
    return taker->take(taker->user, &map);
}

/* About a point: three maps, as OpenSCAD rounds after each. */
static bool take_turn(const struct taker *taker, const struct function *function)
{
    const double c = csg_cos_degrees(function->args[0]), s = csg_sin_degrees(function->args[0]);
    const double x = function->args[1], y = function->args[2];
    if (function->num == 1)
        return take(taker, c, -s, 0, s, c, 0);
    return take(taker, 1, 0, x, 0, 1, y) && take(taker, c, -s, 0, s, c, 0) &&
           take(taker, 1, 0, -x, 0, 1, -y);
}

static double tangent(double degrees)
{
    return csg_sin_degrees(degrees) / csg_cos_degrees(degrees);
}

/* With a wrong number of arguments it is none. */
static bool take_function(const struct taker *taker, const struct function *function)
{
    const double *a = function->args;
    const size_t num = function->num;
    switch (function->letter) {
    case 'm':
        return num != 6 || take(taker, a[0], a[2], a[4], a[1], a[3], a[5]);
    case 't':
        return num < 1 || num > 2 || take(taker, 1, 0, a[0], 0, 1, num > 1 ? a[1] : 0);
    case 's':
        return num < 1 || num > 2 || take(taker, a[0], 0, 0, 0, num > 1 ? a[1] : a[0], 0);
    case 'r':
        return (num != 1 && num != 3) || take_turn(taker, function);
    case 'x':
        return num != 1 || take(taker, 1, tangent(a[0]), 0, 0, 1, 0);
    case 'y':
        return num != 1 || take(taker, 1, 0, 0, tangent(a[0]), 1, 0);
    default:
        return true;
    }
}

/* The letter of the name, or of itself, that stands next; 0: none. at moves behind it. */
static char read_name(const char **at)
{
    for (size_t i = 0; i < num_names; i++) {
        const size_t length = strlen(names[i].name);
        if (strncmp(*at, names[i].name, length) == 0) {
            *at += length;
            return names[i].letter;
        }
    }
    return **at && strchr("mtsrxy", **at) ? *(*at)++ : '\0';
}

static bool is_separator(char c)
{
    return c == ' ' || c == ',' || c == '(' || c == ')';
}

/* An argument ends where a name begins. */
static struct csg_svg_word read_argument(const char **at)
{
    const char *begin = *at;
    for (const char *ahead = begin; *ahead && !is_separator(*ahead) && !read_name(&ahead);)
        *at = ++ahead;
    return (struct csg_svg_word){begin, (size_t)(*at - begin)};
}

bool csg_svg_transform(const char *text, void *user,
                       bool (*take_map)(void *user, const struct csg_svg_map *map))
{
    const struct taker taker = {user, take_map};
    struct function function = {0};
    bool ok = true;
    while (ok && *text) {
        if (is_separator(*text)) {
            text++;
            continue;
        }
        const char letter = read_name(&text);
        if (letter) {
            ok = take_function(&taker, &function);
            function = (struct function){.letter = letter};
            continue;
        }
        const double argument = csg_svg_number(read_argument(&text));
        if (function.num < max_args)
            function.args[function.num] = argument;
        function.num++;
    }
    return ok && take_function(&taker, &function);
}
