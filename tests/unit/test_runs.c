/* SPDX-License-Identifier: MIT */
/*
 * A large text that is parsed in runs, side by side, gives the nodes that one parser gives: places,
 * ends, twins, numbers that may be rounded; also where comments, unindented blocks and strings make
 * cuts that mean nothing.
 */
#define DICE_SEED 5

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "dice.h"
#include "document/runs.h"

#define ROOM ((size_t)4 << 20)

struct text {
    char *data;
    size_t num;
};

static void put(struct text *text, const char *what)
{
    const size_t length = strlen(what);
    if (text->num + length < ROOM) {
        memcpy(text->data + text->num, what, length);
        text->num += length;
    }
}

/* One of four long lists, over several lines. */
static void put_mesh(struct text *text)
{
    char line[100];
    const unsigned kind = random_below(4);
    put(text, "polyhedron(points = [");
    for (unsigned i = 0; i < 40; i++) {
        snprintf(line, sizeof line, "[%u, 1.2345, %u]%s", i * i, i == 39 ? kind : i,
                 i == 39       ? ""
                 : i % 10 == 9 ? ",\n"
                               : ", ");
        put(text, line);
    }
    put(text, "], faces = [[0, 1, 2]]);\n");
}

static void put_node(struct text *text)
{
    static const char *const nodes[] = {
        "sphere(r = 1.23456);\n",
        ("multmatrix([[1, 0, 0, 3.14159], [0, 1, 0, 2], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n"
         "\tcube();\n}\n"),
        "group() {\n\tdifference() {\n\t\tcube(size = 3);\n\t\t%sphere(r = 2);\n\t}\n}\n",
        "union() {\n}\n",
    };
    if (random_below(5) == 0)
        put_mesh(text);
    else
        put(text, nodes[random_below(4)]);
}

static bool is_same(const struct csg_parsed_node *a, const struct csg_parsed_node *b)
{
    return a->at == b->at && a->place.line == b->place.line && a->place.column == b->place.column &&
           a->name_length == b->name_length && a->end == b->end && a->twin == b->twin &&
           a->modifiers == b->modifiers && a->malformed == b->malformed;
}

static void compare(const struct text *text, const char *what)
{
    struct csg_report report;
    struct csg_document some;
    struct csg_run all = {.text = text->data, .size = text->num, .end = text->num};
    csg_report_init(&report, &csg_log_silent, what);
    csg_run_parse(&all, &report);
    CHECK(csg_document_parse(&some, text->data, text->num, 3, &report), "%s: memory", what);
    CHECK(some.nodes.num == all.document.nodes.num && some.num_rounded == all.document.num_rounded,
          "%s: %zu nodes, %zu rounded, not %zu, %zu", what, some.nodes.num, some.num_rounded,
          all.document.nodes.num, all.document.num_rounded);
    for (size_t i = 0; i < some.nodes.num && i < all.document.nodes.num; i++)
        if (!is_same(&some.nodes.data[i], &all.document.nodes.data[i])) {
            CHECK(false, "%s: node %zu", what, i);
            break;
        }
    csg_document_finish(&some);
    csg_run_finish(&all);
}

static void check(const char *what, const char *first, const char *last, bool is_for_runs)
{
    struct text text = {malloc(ROOM), 0};
    CHECK(text.data, "memory");
    if (!text.data)
        return;
    put(&text, first);
    while (text.num < ROOM / 2)
        put_node(&text);
    put(&text, last);
    compare(&text, what);
    struct csg_document document = {.text = text.data, .size = text.num};
    CHECK(csg_runs_parse(&document, what, 2) == is_for_runs, "%s: in runs", what);
    csg_document_finish(&document);
    free(text.data);
}

int main(void)
{
    check("plain", "", "", true);
    check("modifiers", "#sphere();\n", "*cube();\n", true);
    check("a comment", "/* {\n", "*/ sphere(r = 4);\n", false);
    check("a block", "union() {\n", "}\n", false);
    check("a string", "text(text = \"a\nsphere();\n", "\", size = 3);\n", false);
    check("an error", "", "sphere(;\n", false);
    return num_failed > 0;
}
