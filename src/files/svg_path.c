/* SPDX-License-Identifier: MIT */
#include "files/svg_path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "files/svg_curve.h"
#include "files/svg_text.h"

/* A path whose ends are nearer than that is closed. */
static const double closed_distance = 0.1;

static const char commands[] = "-zmlcqahvstZMLCQAHVST";

/* ---- paths ---------------------------------------------------------------------------------- */

void csg_svg_paths_finish(struct csg_svg_paths *paths)
{
    free(paths->points.data);
    free(paths->begins.data);
}

void csg_svg_begin_path(struct csg_svg_paths *paths)
{
    if (!csg_array_push(&paths->begins, paths->points.num))
        csg_svg_fail(paths, CSG_SVG_NO_MEMORY);
}

void csg_svg_add_point(struct csg_svg_paths *paths, double x, double y)
{
    if (!csg_array_push(&paths->points, ((struct csg_vec2){x, y})))
        csg_svg_fail(paths, CSG_SVG_NO_MEMORY);
}

static size_t last_begin(const struct csg_svg_paths *paths)
{
    return paths->begins.num > 0 ? paths->begins.data[paths->begins.num - 1] : paths->points.num;
}

static bool begin_outline(void *user)
{
    struct csg_svg_paths *paths = user;
    csg_svg_begin_path(paths);
    return paths->result == CSG_SVG_DONE;
}

static bool add_corner(void *user, double x, double y)
{
    struct csg_svg_paths *paths = user;
    csg_svg_add_point(paths, x, y);
    return paths->result == CSG_SVG_DONE;
}

void csg_svg_stroke_path(struct csg_svg_paths *paths)
{
    const struct csg_clip_sink sink = {paths, begin_outline, add_corner};
    const size_t begin = last_begin(paths), num = paths->points.num - begin;
    struct csg_vec2 *points = num > 0 ? malloc(num * sizeof *points) : NULL;
    if (paths->begins.num > 0)
        paths->begins.num--;
    paths->points.num = begin;
    if (num == 0)
        return;
    if (!points) {
        csg_svg_fail(paths, CSG_SVG_NO_MEMORY);
        return;
    }
    memcpy(points, &paths->points.data[begin], num * sizeof *points);
    const enum csg_clip_result result = paths->clip->stroke(&points->x, num, &paths->pen, &sink);
    if (result != CSG_CLIP_DONE)
        csg_svg_fail(paths, result == CSG_CLIP_TOO_LARGE ? CSG_SVG_FOREIGN : CSG_SVG_NO_MEMORY);
    free(points);
}

/* The last path has points, and its ends lie apart. */
static bool is_open(const struct csg_svg_paths *paths)
{
    const size_t begin = last_begin(paths), end = paths->points.num;
    if (begin == end)
        return false;
    const struct csg_vec2 a = paths->points.data[begin], b = paths->points.data[end - 1];
    return sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)) > closed_distance;
}

/* ---- data ----------------------------------------------------------------------------------- */

enum { max_args = 7, max_exponent = 64 };

enum curve { CURVE_NONE, CURVE_QUADRATIC, CURVE_CUBIC };

struct pencil {
    struct csg_svg_paths *paths;
    char command;
    double args[max_args];
    int num; /* of args */
    struct csg_vec2 at, control;
    enum curve before; /* what control is of */
    bool was_closed;
    bool is_negative;            /* a '-' stood before */
    char exponent[max_exponent]; /* "12e", when its digits are the next word */
};

static bool is_relative(const struct pencil *pencil)
{
    return pencil->command >= 'a';
}

static struct csg_vec2 point_of(const struct pencil *pencil, int i)
{
    const double *p = &pencil->args[i];
    if (!is_relative(pencil))
        return (struct csg_vec2){p[0], p[1]};
    return (struct csg_vec2){pencil->at.x + p[0], pencil->at.y + p[1]};
}

static void line_to(struct pencil *pencil, struct csg_vec2 to)
{
    csg_svg_add_point(pencil->paths, to.x, to.y);
    pencil->at = to;
    pencil->before = CURVE_NONE;
}

/* The mirror image of the last control point where the curve before was of that kind. */
static struct csg_vec2 smooth_control(const struct pencil *pencil, enum curve kind)
{
    if (pencil->before != kind)
        return pencil->at;
    return (struct csg_vec2){pencil->at.x + (pencil->at.x - pencil->control.x),
                             pencil->at.y + (pencil->at.y - pencil->control.y)};
}

/* first: of the points among the arguments; those before are control points. */
static void curve_to(struct pencil *pencil, enum curve kind, bool is_smooth)
{
    struct csg_vec2 p[4] = {pencil->at};
    const int degree = kind == CURVE_CUBIC ? 3 : 2;
    int k = 1;
    if (is_smooth)
        p[k++] = smooth_control(pencil, kind);
    for (int arg = 0; k <= degree; arg += 2)
        p[k++] = point_of(pencil, arg);
    csg_svg_add_curve(pencil->paths, p, degree);
    pencil->control = p[degree - 1];
    pencil->at = p[degree];
    pencil->before = kind;
}

static void arc_to(struct pencil *pencil)
{
    const double *a = pencil->args;
    const struct csg_svg_arc arc = {fabs(a[0]), fabs(a[1]), a[2], a[3] > 0.5, a[4] > 0.5};
    const struct csg_vec2 to = point_of(pencil, 5);
    csg_svg_add_arc(pencil->paths, &arc, pencil->at, to);
    pencil->at = to;
    pencil->before = CURVE_NONE;
}

/* What follows are lines. */
static void move_to(struct pencil *pencil)
{
    struct csg_svg_paths *paths = pencil->paths;
    const struct csg_vec2 to = point_of(pencil, 0);
    if (last_begin(paths) < paths->points.num) {
        if (is_open(paths))
            csg_svg_stroke_path(paths);
        csg_svg_begin_path(paths);
    }
    line_to(pencil, to);
    pencil->command = is_relative(pencil) ? 'l' : 'L';
}

static void close_path(struct pencil *pencil)
{
    struct csg_svg_paths *paths = pencil->paths;
    const size_t begin = last_begin(paths);
    if (begin < paths->points.num) {
        pencil->at = paths->points.data[begin];
        csg_svg_add_point(paths, pencil->at.x, pencil->at.y);
    }
    csg_svg_begin_path(paths);
    pencil->was_closed = true;
    pencil->before = CURVE_NONE;
}

static void line_along(struct pencil *pencil, bool is_vertical)
{
    struct csg_vec2 to = pencil->at;
    double *coordinate = is_vertical ? &to.y : &to.x;
    *coordinate = pencil->args[0] + (is_relative(pencil) ? *coordinate : 0);
    line_to(pencil, to);
}

static int num_args_of(char command)
{
    static const char letters[] = "alcsqtmvh";
    static const int nums[] = {7, 2, 6, 4, 4, 2, 2, 1, 1};
    const char *found = strchr(letters, command | ('a' - 'A'));
    return found && command != ' ' ? nums[found - letters] : 0;
}

static void obey(struct pencil *pencil)
{
    switch (pencil->command | ('a' - 'A')) {
    case 'a':
        arc_to(pencil);
        break;
    case 'l':
        line_to(pencil, point_of(pencil, 0));
        break;
    case 'c':
        curve_to(pencil, CURVE_CUBIC, false);
        break;
    case 's':
        curve_to(pencil, CURVE_CUBIC, true);
        break;
    case 'q':
        curve_to(pencil, CURVE_QUADRATIC, false);
        break;
    case 't':
        curve_to(pencil, CURVE_QUADRATIC, true);
        break;
    case 'm':
        move_to(pencil);
        break;
    case 'v':
        line_along(pencil, true);
        break;
    default:
        line_along(pencil, false);
        break;
    }
}

static void add_argument(struct pencil *pencil, double number)
{
    const int wanted = num_args_of(pencil->command);
    if (wanted == 0) {
        if (pencil->command == 'z' || pencil->command == 'Z')
            close_path(pencil);
        return;
    }
    pencil->args[pencil->num++] = number;
    if (pencil->num == wanted) {
        pencil->num = 0;
        obey(pencil);
    }
}

/* Puts the part of a number before and behind an e together. */
static double join_exponent(struct pencil *pencil, struct csg_svg_word word)
{
    char text[2 * max_exponent];
    size_t length = strlen(pencil->exponent);
    memcpy(text, pencil->exponent, length);
    pencil->exponent[0] = '\0';
    if (length + word.length + 1 > sizeof text)
        return 0;
    if (pencil->is_negative)
        text[length++] = '-';
    memcpy(text + length, word.at, word.length);
    return csg_svg_number((struct csg_svg_word){text, length + word.length});
}

/* A number, its '-' being a word of its own, and so what is behind the '-' of its exponent. */
static void take_number(struct pencil *pencil, struct csg_svg_word word)
{
    if (word.at[word.length - 1] == 'e') {
        const size_t sign = pencil->is_negative;
        const bool fits = word.length + sign < max_exponent;
        pencil->exponent[0] = '-';
        if (fits)
            memcpy(pencil->exponent + sign, word.at, word.length);
        pencil->exponent[fits ? word.length + sign : 1] = '\0';
        pencil->is_negative = false;
        return;
    }
    double number;
    if (pencil->exponent[0]) {
        number = join_exponent(pencil, word);
    } else {
        number = csg_svg_number(word);
        number = pencil->is_negative ? -number : number;
    }
    pencil->is_negative = false;
    add_argument(pencil, number);
}

/* ".5.25" are two numbers. What is behind the last point and no digit is left out. */
static void take_numbers(struct pencil *pencil, struct csg_svg_word word)
{
    size_t begin = 0, num_points = 0;
    bool was_point = false;
    for (size_t i = 0; i < word.length; i++)
        num_points += word.at[i] == '.';
    if (num_points < 2) {
        take_number(pencil, word);
        return;
    }
    for (size_t i = 0; i < word.length; i++) {
        const bool is_last = i + 1 == word.length || word.at[i + 1] == '.';
        was_point = was_point || word.at[i] == '.';
        if (word.at[i] != '.' && is_last && was_point) {
            take_number(pencil, (struct csg_svg_word){word.at + begin, i + 1 - begin});
            begin = i + 1;
        }
    }
}

void csg_svg_add_data(struct csg_svg_paths *paths, const char *d)
{
    struct pencil pencil = {.paths = paths, .command = ' '};
    struct csg_svg_word word;
    csg_svg_begin_path(paths);
    while (paths->result == CSG_SVG_DONE && csg_svg_next_word(&d, commands, &word)) {
        if (word.length == 1 && *word.at == '-') {
            pencil.is_negative = true;
        } else if (word.length == 1 && strchr(commands, *word.at)) {
            pencil.command = *word.at;
            pencil.num = 0;
            if (*word.at == 'z' || *word.at == 'Z')
                close_path(&pencil);
        } else {
            take_numbers(&pencil, word);
        }
    }
    while (paths->begins.num > 0 && last_begin(paths) == paths->points.num)
        paths->begins.num--;
    if (!pencil.was_closed && is_open(paths))
        csg_svg_stroke_path(paths);
}
