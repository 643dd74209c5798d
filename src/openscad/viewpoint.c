/* SPDX-License-Identifier: MIT */
#include "openscad/viewpoint.h"

#include <math.h>
#include <string.h>

#include "common/number.h"

const char csg_viewpoint_define[] = "echo(csgcast_view = [$vpt, $vpr, $vpd, $vpf])";

static const char echo_begin[] = "ECHO: csgcast_view = [";
static const char warning_begin[] = "WARNING: Viewall and autocenter disabled in favor of $vp*";

/* One of the variables. Where none is assigned, openscad has other numbers for them than its
 * camera: what equals these is not assigned, unless the text says so. */
struct variable {
    const char *name;
    size_t num;       /* of numbers */
    double unset[3];  /* what an echo shows */
    double camera[3]; /* what the camera has then */
};

static const struct variable variables[] = {
    {"$vpt", 3, {0, 0, 0}, {0, 0, 0}},
    {"$vpr", 3, {0, 0, 0}, {55, 0, 25}},
    {"$vpd", 1, {500}, {140}},
    {"$vpf", 1, {22.5}, {22.5}},
};

#define NUM_VARIABLES (sizeof variables / sizeof variables[0])

/* ---- the text ------------------------------------------------------------------------------- */

/* Behind the comment or string that begins at text, or text. */
static const char *skip_opaque(const char *text, const char *end)
{
    const bool line = end - text > 1 && text[0] == '/' && text[1] == '/';
    const bool block = end - text > 1 && text[0] == '/' && text[1] == '*';
    if (line) {
        const char *newline = memchr(text, '\n', (size_t)(end - text));
        return newline ? newline : end;
    }
    if (block) {
        for (text += 2; end - text > 1 && !(text[0] == '*' && text[1] == '/'); text++)
            ;
        return end - text > 1 ? text + 2 : end;
    }
    if (*text != '"')
        return text;
    for (text++; text < end && *text != '"'; text++)
        text += *text == '\\' && end - text > 1;
    return text < end ? text + 1 : end;
}

static bool begins(const char *text, const char *end, const char *word)
{
    const size_t length = strlen(word);
    return (size_t)(end - text) >= length && memcmp(text, word, length) == 0;
}

static bool assigns_here(const char *text, const char *end, const char *name)
{
    if (!begins(text, end, name))
        return false;
    for (text += strlen(name); text < end && strchr(" \t\r\n", *text); text++)
        ;
    return text < end && *text == '=' && !begins(text, end, "==");
}

/* Which variables the text assigns, as bits. */
static unsigned find_assigned(const struct csg_bytes *source)
{
    const char *text = source->data, *const end = text + source->num;
    unsigned assigned = 0;
    while (text < end) {
        const char *behind = skip_opaque(text, end);
        for (size_t i = 0; *text == '$' && i < NUM_VARIABLES; i++)
            assigned |= assigns_here(text, end, variables[i].name) ? 1U << i : 0;
        text = behind > text ? behind : text + 1;
    }
    return assigned;
}

/* ---- the echoes ----------------------------------------------------------------------------- */

/* The number at *text, which moves behind it; false: there is none. */
static bool read_number(const char **text, const char *end, double *value)
{
    const size_t length = (size_t)(end - *text);
    size_t num = 0;
    while (num < length && memchr("0123456789.e+-", (*text)[num], 14))
        num++;
    if (!csg_number_read_signed(*text, num, value))
        return false;
    *text += num;
    return true;
}

static bool read_vector(const char **text, const char *end, double values[3])
{
    size_t num = 0;
    values[2] = 0; /* openscad takes two numbers, too */
    if (!begins(*text, end, "["))
        return false;
    do {
        *text += num > 0 ? 2 : 1;
        if (num == 3 || !read_number(text, end, &values[num++]))
            return false;
    } while (begins(*text, end, ", "));
    return num >= 2 && begins((*text)++, end, "]");
}

/* To the next variable: behind the comma that is in no bracket or string. */
static const char *next_value(const char *text, const char *end)
{
    int depth = 0;
    for (; text < end && (depth > 0 || *text != ','); text++) {
        if (*text == '"')
            text = skip_opaque(text, end) - 1;
        else
            depth += (*text == '[') - (*text == ']');
    }
    return end - text > 2 ? text + 2 : end;
}

/* A value that is no camera's is left out; openscad has said so. */
static bool read_variable(const char *text, const char *end, size_t num, double values[3])
{
    return num == 1 ? read_number(&text, end, values) : read_vector(&text, end, values);
}

static struct csgcast_camera read_camera(const char *text, const char *end, unsigned assigned)
{
    double values[NUM_VARIABLES][3] = {{0}};
    for (size_t i = 0; i < NUM_VARIABLES; i++) {
        const struct variable *variable = &variables[i];
        const size_t size = variable->num * sizeof(double);
        const bool read = read_variable(text, end, variable->num, values[i]);
        const bool is_set = assigned & 1U << i || memcmp(values[i], variable->unset, size) != 0;
        if (!read || !is_set)
            memcpy(values[i], variable->camera, sizeof values[i]);
        text = next_value(text, end);
    }
    struct csgcast_camera camera = {
        .kind = CSGCAST_CAMERA_GIMBAL, .distance = values[2][0], .fov = values[3][0]};
    memcpy(camera.translate, values[0], sizeof camera.translate);
    memcpy(camera.rotate, values[1], sizeof camera.rotate);
    return camera;
}

/* ---- the messages --------------------------------------------------------------------------- */

bool csg_viewpoint_is_asked(const struct csg_bytes *messages)
{
    const char *line = messages->data, *const end = line + messages->num;
    while (line < end && !begins(line, end, warning_begin)) {
        const char *newline = memchr(line, '\n', (size_t)(end - line));
        line = newline ? newline + 1 : end;
    }
    return line < end;
}

bool csg_viewpoint_take(struct csg_flattened *flattened, struct csg_bytes *messages,
                        const struct csg_bytes *source)
{
    const bool asked = csg_viewpoint_is_asked(messages);
    const unsigned assigned = asked ? find_assigned(source) : 0;
    const char *line = messages->data, *const end = line + messages->num;
    char *kept = messages->data;
    bool enough = true;
    while (line < end && enough) {
        const char *newline = memchr(line, '\n', (size_t)(end - line));
        const char *next = newline ? newline + 1 : end;
        const bool echo = begins(line, end, echo_begin), warning = begins(line, end, warning_begin);
        if (echo)
            enough = csg_array_push(&flattened->cameras,
                                    read_camera(line + sizeof echo_begin - 1, next, assigned));
        if (!echo && !warning) {
            memmove(kept, line, (size_t)(next - line));
            kept += next - line;
        }
        line = next;
    }
    if (enough)
        messages->num = (size_t)(kept - messages->data);
    for (size_t i = 0; i < flattened->cameras.num && !asked; i++)
        flattened->cameras.data[i] = (struct csgcast_camera){.kind = CSGCAST_CAMERA_DEFAULT};
    return enough;
}
