/* SPDX-License-Identifier: MIT */
/*
 * Plain arguments are stepped over where others are read: in both ways the lexer ends in the same
 * place, with the same lines and numbers counted, and nothing malformed is stepped over.
 */
#define DICE_SEED 23

#include <stdio.h>
#include <string.h>

#include "check.h"
#include "dice.h"
#include "document/arguments.h"
#include "document/plain.h"

enum { NUM_TEXTS = 200000, MAX_PIECES = 24 };

static const char *const pieces[] = {
    "(",    ")",     "[",       "]",         ",",      ",",     " ",        "\n",    "=",
    "-",    "+",     "true",    "false",     "undef",  "inf",   "nan",      "nano",  "r",
    "$fn",  "0",     "12.5",    "1e-07",     "1e",     ".5",    "5.",       "..",    "1.2.3",
    "12x",  "12345", "123456",  "123.4560",  "1e400",  "/",     "/* \n */", "// \n", "\"s\"",
    "0.00", "00120", "1234567", "0.0012345", "100000", "99999", "\xc3\xbc", "3",     "0123.450",
};

enum { NUM_PIECES = sizeof pieces / sizeof pieces[0] };

static void put_value(char *text, int depth)
{
    static const int numbers[] = {19, 20, 21, 23, 24, 28, 29, 30, 31, 36, 37, 38, 39, 40, 41};
    if (random_below(3) == 0 && depth < 4) {
        strcat(text, "[");
        for (unsigned i = random_below(4); i > 0; i--) {
            put_value(text, depth + 1);
            strcat(text, i > 1 || random_below(8) == 0 ? "," : "");
        }
        strcat(text, "]");
    } else if (random_below(6) == 0) {
        strcat(text, pieces[11 + random_below(5)]);
    } else {
        strcat(text, random_below(3) ? "" : " -");
        strcat(text, pieces[numbers[random_below(sizeof numbers / sizeof numbers[0])]]);
    }
    strcat(text, random_below(6) ? "" : "\n");
}

static void make_plain(char *text)
{
    strcpy(text, "cube(");
    for (unsigned i = random_below(4); i > 0; i--) {
        strcat(text, random_below(2) ? "" : "$fn =");
        put_value(text, 0);
        strcat(text, i > 1 ? ", " : "");
    }
    strcat(text, ") ");
}

static void make_any(char *text)
{
    strcpy(text, "cube(");
    for (unsigned i = random_below(MAX_PIECES); i > 0; i--)
        strcat(text, pieces[random_below(NUM_PIECES)]);
    strcat(text, random_below(2) ? ")" : "");
}

/* One character more or less. */
static void damage(char *text)
{
    const size_t length = strlen(text), at = 5 + random_below((unsigned)length - 4);
    if (at < length && random_below(2))
        memmove(text + at, text + at + 1, length - at);
    else if (at < length)
        text[at] = "()[],=-.5e r/\""[random_below(14)];
}

static void check(const char *text, bool must_be_plain, struct csg_arguments *arguments)
{
    struct csg_report report;
    struct csg_lexer lexer, skipped;
    struct csg_token token;
    csg_report_init(&report, &csg_log_silent, "plain");
    csg_lexer_init(&lexer, text, strlen(text), 0, (struct csg_place){1, 1});
    lexer.has_all_digits = random_below(4) == 0;
    csg_lexer_next(&lexer, &token);
    skipped = lexer;
    const bool is_plain = csg_plain_skip(&skipped);
    const bool is_read = csg_arguments_read(arguments, &lexer, &token, &report) == CSG_DONE;
    const struct csg_lexer *behind = &arguments->behind;
    CHECK(is_plain || !must_be_plain, "%s is plain", text);
    CHECK(is_read || !is_plain, "%s is malformed", text);
    CHECK(!is_plain || (behind->at == skipped.at && behind->line == skipped.line &&
                        behind->line_begin == skipped.line_begin &&
                        behind->num_rounded == skipped.num_rounded),
          "%s: %zu, line %u, %zu rounded, not %zu, %u, %zu", text, skipped.at,
          (unsigned)skipped.line, skipped.num_rounded, behind->at, (unsigned)behind->line,
          behind->num_rounded);
    csg_report_finish(&report);
}

int main(void)
{
    struct csg_arguments arguments = {0};
    char text[4096];
    for (int i = 0; i < NUM_TEXTS; i++) {
        if (i % 3 == 0)
            make_any(text);
        else
            make_plain(text);
        if (i % 3 == 2)
            damage(text);
        check(text, i % 3 == 1, &arguments);
    }
    csg_arguments_finish(&arguments);
    return num_failed != 0;
}
