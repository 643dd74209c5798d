/* SPDX-License-Identifier: MIT */
/*
 * test_stress [SCALE]
 *
 * Large, deep and hostile texts, made here. SCALE (default 1) multiplies their size. Each must be
 * read, or refused with messages, in time and memory proportional to its size.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "document/report.h"
#include "scene/load.h"
#include "scene_print.h"

struct counts {
    size_t errors, warnings;
    char first[256]; /* message */
};

struct expectation {
    const char *name;
    bool is_scene;
    size_t num_leaves;
    size_t num_errors;   /* shown */
    const char *message; /* part of the first one; NULL: none is expected */
};

static size_t scale = 1;

static void count_message(void *user, enum csgcast_log_level level, enum csgcast_message id,
                          const char *text)
{
    struct counts *counts = user;
    (void)id;
    if (counts->errors + counts->warnings == 0)
        snprintf(counts->first, sizeof counts->first, "%s", text);
    counts->errors += level == CSGCAST_LOG_ERROR;
    counts->warnings += level == CSGCAST_LOG_WARNING;
}

static void add_bytes(struct text *text, const char *bytes, size_t num)
{
    if (!csg_array_reserve(text, num))
        abort();
    memcpy(text->data + text->num, bytes, num);
    text->num += num;
}

static void repeat(struct text *text, const char *piece, size_t times)
{
    for (size_t i = 0; i < times; i++)
        add_bytes(text, piece, strlen(piece));
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Frees text. */
static int check(struct text *text, const struct expectation *expected)
{
    struct counts counts = {0};
    const struct csgcast_scene_params params = {
        .name = "text", .no_handoff = true, .log = count_message, .log_user = &counts};
    const double start = seconds();
    struct csgcast_scene *scene = csg_scene_read(text->data, text->num, &params);
    const size_t num_leaves = scene ? scene->num_leaves : 0;
    printf("%-24s %9zu bytes %7zu leaves %3zu errors %6.3f s  %s\n", expected->name, text->num,
           num_leaves, counts.errors, seconds() - start, counts.first);
    const bool passed =
        (scene != NULL) == expected->is_scene && num_leaves == expected->num_leaves &&
        counts.errors == expected->num_errors &&
        (expected->message ? strstr(counts.first, expected->message) != NULL : !counts.first[0]);
    if (!passed)
        fprintf(stderr, "%s: not as expected\n", expected->name);
    csgcast_scene_destroy(scene);
    free(text->data);
    *text = (struct text){0};
    return !passed;
}

static int check_many_leaves(void)
{
    struct text text = {0};
    const size_t num = 100000 * scale;
    text_add(&text, "difference() {\n");
    repeat(&text,
           "\tmultmatrix([[0.707107, -0.707107, 0, 12.3456], [0.707107, 0.707107, 0, -7.5], "
           "[0, 0, 1, 0], [0, 0, 0, 1]]) {\n\t\tcube(size = [1, 2, 3], center = false);\n\t}\n",
           num);
    text_add(&text, "}\n");
    return check(&text, &(struct expectation){"many leaves", true, num, 0, NULL});
}

/* A drawing of more corners than are swept is one surface all the same. */
static int check_corners(void)
{
    struct text text = {0};
    const int num = 300000;
    text_add(&text, "mirror([1, 0, 0]) linear_extrude(height = 2) mirror([1, 0, 0]) polygon([");
    for (int i = 0; i < num; i++) {
        const double angle = 2 * 3.14159265358979323846 * i / num;
        const double radius = 100 + 20 * sin(9 * angle);
        char corner[80];
        snprintf(corner, sizeof corner, "[%.17g,%.17g],", radius * cos(angle), radius * sin(angle));
        add_bytes(&text, corner, strlen(corner));
    }
    text_add(&text, "]);");
    return check(&text, &(struct expectation){"many corners", true, 1, 0, NULL});
}

static int check_depth(void)
{
    static const char *const openings[] = {
        "group(){",
        "difference(){",
        "%union(){",
        "#difference(){",
        "color([1,0,0,1]){",
        "translate([0,0,0])",
        "difference(){sphere(0);#union(){",
    };
    int num_failed = 0;
    const size_t depth = 10000 * scale;
    for (size_t i = 0; i < sizeof openings / sizeof openings[0]; i++) {
        struct text text = {0};
        const char *first = strchr(openings[i], '{'), *last = strrchr(openings[i], '{');
        repeat(&text, openings[i], depth);
        text_add(&text, "cube(size = [1, 1, 1]);");
        repeat(&text, !first ? "" : first == last ? "}" : "}}", depth);
        const bool is_limited = strstr(openings[i], ";#") != NULL;
        num_failed += check(&text, &(struct expectation){openings[i], true, 1, 0,
                                                         is_limited ? "too many '#'" : NULL});
    }
    return num_failed;
}

static int check_open(const char *piece, size_t num_errors, const char *message)
{
    struct text text = {0};
    repeat(&text, piece, 1000000);
    return check(&text, &(struct expectation){piece, false, 0, num_errors, message});
}

static int check_brackets(void)
{
    struct text text = {0};
    text_add(&text, "cube(size = ");
    repeat(&text, "[", 1000000);
    int num_failed = check(&text, &(struct expectation){"open [", false, 0, 1, "expected a value"});
    text_add(&text, "cube(size = ");
    repeat(&text, "[", 1000000);
    repeat(&text, "]", 1000000);
    text_add(&text, ");");
    return num_failed + check(&text, &(struct expectation){"balanced [", true, 1, 0, NULL});
}

static int check_long_tokens(void)
{
    struct text text = {0};
    repeat(&text, "a", 1000000);
    int num_failed = check(&text, &(struct expectation){"long name", false, 0, 2, "expected '('"});
    text_add(&text, "cube(size = ");
    repeat(&text, "1", 1000000);
    num_failed += check(&text, &(struct expectation){"long number", false, 0, 1, "1100"});
    text_add(&text, "sphere(name = \"");
    repeat(&text, "x", 1000000);
    return num_failed +
           check(&text, &(struct expectation){"open string", false, 0, 1, "closing quote"});
}

static int check_garbage(void)
{
    struct text text = {0};
    uint32_t random = 1;
    for (size_t i = 0; i < 1000000; i++) {
        const char byte = (char)(random >> 24);
        random = random * 1664525 + 1013904223;
        add_bytes(&text, &byte, 1);
    }
    int num_failed = check(
        &text, &(struct expectation){"random bytes", false, 0, CSG_REPORT_SHOWN + 1, "text:"});
    const char zeros[4096] = {0};
    add_bytes(&text, zeros, sizeof zeros);
    num_failed += check(&text, &(struct expectation){"zeros", false, 0, 1, "byte 0x00"});
    repeat(&text, "text(text = \"a\"b);\n", 100000);
    return num_failed +
           check(&text, &(struct expectation){"text", false, 0, CSG_REPORT_SHOWN + 1, "text:1:16"});
}

int main(int argc, char **argv)
{
    if (argc > 1)
        scale = strtoul(argv[1], NULL, 10);
    int num_failed = check_many_leaves() + check_corners() + check_depth() + check_brackets() +
                     check_long_tokens() + check_garbage();
    num_failed += check_open("{", 1, "never closed");
    num_failed += check_open("}", CSG_REPORT_SHOWN + 1, "closes nothing");
    num_failed += check_open("group(){", 1, "never closed");
    num_failed += check_open("translate()", CSG_REPORT_SHOWN + 1, "found the end");
    num_failed += check_open("roof();\n", CSG_REPORT_SHOWN + 1, "roof is not supported");
    num_failed += check_open("(", 1, "expected a node");
    num_failed += check_open("\"", 1, "found a string");
    num_failed += check_open("/* ", 1, "closing '*/'");
    num_failed += check_open("#%!", 1, "");
    return num_failed > 0;
}
