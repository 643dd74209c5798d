/* SPDX-License-Identifier: MIT */
#ifndef CSG_TESTS_SOLID_ARGS_H
#define CSG_TESTS_SOLID_ARGS_H

/* Reads a solid from "r=[1, 2, 3] h=4 center=true" without the scene parser. */

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "dice.h"
#include "messages.h"
#include "solids/solid.h"

#define MAX_VALUES 64
#define MAX_ARGS 8
#define MAX_DEPTH 3

struct solid_text {
    struct csg_value values[MAX_VALUES]; /* of vectors */
    size_t num_values;
    struct csg_arg args[MAX_ARGS];
    char names[MAX_ARGS][16];
    size_t num_args;
    const char *at;
};

static struct csg_value parse_value(struct solid_text *text, int depth)
{
    struct csg_value value = {.type = CSG_VALUE_UNDEF};
    struct csg_value items[16];
    size_t num = 0;
    char *end;
    if (*text->at != '[' || depth >= MAX_DEPTH) {
        value.number = strtod(text->at, &end);
        value.type = end > text->at ? CSG_VALUE_NUMBER : CSG_VALUE_STRING;
        if (end == text->at)
            value.string = text->at;
        text->at = end > text->at ? end : text->at + strcspn(text->at, " ,]");
        return value;
    }
    for (text->at++; *text->at && *text->at != ']'; text->at += strspn(text->at, ", "))
        if (num < 16)
            items[num++] = parse_value(text, depth + 1);
    text->at += *text->at == ']';
    value.type = CSG_VALUE_VECTOR;
    value.num = num;
    value.items = &text->values[text->num_values];
    memcpy(&text->values[text->num_values], items, num * sizeof *items);
    text->num_values += num;
    return value;
}

static void parse_args(struct solid_text *text, const char *args)
{
    memset(text, 0, sizeof *text);
    for (text->at = args; *text->at; text->at += strspn(text->at, " ")) {
        const size_t length = strcspn(text->at, "=");
        char *name = text->names[text->num_args];
        snprintf(name, sizeof text->names[0], "%.*s", (int)length, text->at);
        text->at += length + 1;
        text->args[text->num_args].name = name;
        text->args[text->num_args++].value = parse_value(text, 0);
    }
}

/* The kind's read() for these arguments. */
static enum csg_read_result read_solid(const char *kind, const char *args,
                                       enum csgcast_facets facets, struct csg_shape *shape,
                                       struct messages *messages)
{
    const struct csg_log log = {keep_message, messages};
    const enum csg_kind found = csg_solid_find(kind, strlen(kind));
    struct solid_text text;
    parse_args(&text, args);
    *messages = (struct messages){0};
    *shape = (struct csg_shape){.frame = csg_map_identity};
    if (found == CSG_NUM_KINDS)
        return CSG_READ_ERROR;
    const struct csg_args read_args = {.args = text.args,
                                       .num = text.num_args,
                                       .parameters = csg_solids[found]->parameters,
                                       .facets = facets,
                                       .log = &log,
                                       .file = "test",
                                       .line = 3,
                                       .column = 5,
                                       .node = kind};
    return csg_solids[found]->read(&read_args, shape);
}

static inline const double *components(const struct csg_vec3 *v)
{
    return &v->x;
}

static inline bool same_point(const struct csg_vec3 *a, const struct csg_vec3 *b)
{
    bool same = true;
    for (int i = 0; i < 3; i++) {
        const double x = components(a)[i], y = components(b)[i];
        same &= x == y || fabs(x - y) < 1e-9;
    }
    return same;
}

static inline bool same_box(const struct csg_box *a, const struct csg_box *b)
{
    return same_point(&a->lo, &b->lo) && same_point(&a->hi, &b->hi);
}

#endif
