/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "common/spelling.h"
#include "instrument_options.h"
#include "messages.h"
#include "option_table.h"
#include "values.h"

#include <stdlib.h>
#include <string.h>

#define HELP_COLUMN 24

/* A name further away than this from what was typed is no help. */
#define MAX_SUGGESTION_DISTANCE 4

/* One argument of the command line taken apart: --name=value, -Lvalue. */
struct spelled {
    const char *text; /* the whole argument */
    const char *name; /* long: behind the dashes; short: the letter */
    size_t name_length;
    const char *value; /* NULL: none in this argument */
    bool is_letter;
};

struct parser {
    struct csg_cli_options *options;
    const struct csg_cli_command *command;
    char **argv;
    int num, next;
};

static struct spelled take_apart(const char *text)
{
    struct spelled spelled = {.text = text};
    if (text[1] == '-') {
        const char *equals = strchr(text, '=');
        spelled.name = text + 2;
        spelled.name_length = equals ? (size_t)(equals - spelled.name) : strlen(spelled.name);
        spelled.value = equals ? equals + 1 : NULL;
    } else {
        spelled.is_letter = true;
        spelled.name = text + 1;
        spelled.name_length = 1;
        spelled.value = text[2] ? text + 2 : NULL;
    }
    return spelled;
}

static bool matches(const struct spelled *spelled, const char *name, char letter)
{
    if (spelled->is_letter)
        return letter && *spelled->name == letter;
    return strlen(name) == spelled->name_length &&
           !strncmp(name, spelled->name, spelled->name_length);
}

static const struct csg_option *find_option(const struct parser *parser,
                                            const struct spelled *spelled)
{
    for (const struct csg_option *option = csg_option_table; option->name; option++) {
        if ((option->commands & (unsigned)parser->command->bit) &&
            matches(spelled, option->name, option->letter))
            return option;
    }
    return NULL;
}

static const struct csg_foreign_option *find_foreign(const struct spelled *spelled)
{
    const struct csg_foreign_option *option = csg_foreign_option_table;
    while (option->name && !matches(spelled, option->name, option->letter))
        option++;
    return option->name ? option : NULL;
}

/* Whether the option belongs to another command: a better answer than "unknown". */
static bool is_elsewhere(const struct spelled *spelled)
{
    for (const struct csg_option *option = csg_option_table; option->name; option++) {
        if (matches(spelled, option->name, option->letter))
            return true;
    }
    return false;
}

static const char *closest_name(const struct parser *parser, const struct spelled *spelled)
{
    const char *closest = NULL;
    size_t least = MAX_SUGGESTION_DISTANCE + 1;
    if (spelled->is_letter)
        return NULL;
    for (const struct csg_option *option = csg_option_table; option->name; option++) {
        if (!(option->commands & (unsigned)parser->command->bit) || !option->help)
            continue;
        const size_t distance = csg_spelling_distance(spelled->name, spelled->name_length,
                                                      option->name, strlen(option->name));
        if (distance < least) {
            least = distance;
            closest = option->name;
        }
    }
    return closest;
}

static bool complain_unknown(const struct parser *parser, const struct spelled *spelled)
{
    const char *command = parser->command->name;
    const char *dashes = spelled->is_letter ? "-" : "--";
    const int length = (int)spelled->name_length;
    const char *closest = closest_name(parser, spelled);
    if (is_elsewhere(spelled))
        csg_cli_error("`csgcast %s` has no option %s%.*s; see `csgcast help`", command, dashes,
                      length, spelled->name);
    else if (closest)
        csg_cli_error("unknown option %s%.*s; did you mean --%s?", dashes, length, spelled->name,
                      closest);
    else
        csg_cli_error("unknown option %s%.*s; see `csgcast help %s`", dashes, length, spelled->name,
                      command);
    return false;
}

/* Finds the option's value, in the argument itself or in the next one. false after a message. */
static bool find_value(struct parser *parser, struct spelled *spelled,
                       enum csg_option_argument argument)
{
    if (argument == CSG_ARGUMENT_REQUIRED && !spelled->value) {
        if (parser->next == parser->num) {
            csg_cli_error("%s needs a value", spelled->text);
            return false;
        }
        spelled->value = parser->argv[parser->next++];
    } else if (argument == CSG_ARGUMENT_NONE && spelled->value) {
        csg_cli_error("%s takes no value", spelled->text);
        return false;
    }
    return true;
}

static bool skip_foreign(struct parser *parser, struct spelled *spelled,
                         const struct csg_foreign_option *option)
{
    if (!find_value(parser, spelled, option->argument))
        return false;
    if (option->refuse) {
        csg_cli_error("%s is not supported: %s", spelled->text, option->reason);
        return false;
    }
    if (!parser->options->quiet)
        csg_cli_warning("%s has no effect: %s", spelled->text, option->reason);
    return true;
}

static bool parse_option(struct parser *parser, const char *text)
{
    struct spelled spelled = take_apart(text);
    const struct csg_option *option = find_option(parser, &spelled);
    if (!option) {
        const struct csg_foreign_option *foreign = find_foreign(&spelled);
        return foreign ? skip_foreign(parser, &spelled, foreign)
                       : complain_unknown(parser, &spelled);
    }
    if (!find_value(parser, &spelled, option->argument))
        return false;
    const char *expected = option->set(parser->options, spelled.value);
    if (expected)
        csg_cli_error("%s%.*s%s%s: expected %s", spelled.is_letter ? "-" : "--",
                      (int)spelled.name_length, spelled.name, spelled.value ? " " : "",
                      spelled.value ? spelled.value : "", expected);
    return !expected;
}

static bool parse_input(struct csg_cli_options *options, bool many, const char *path)
{
    if (options->input && !many) {
        csg_cli_error("more than one scene: %s and %s", options->input, path);
        return false;
    }
    if (!*path) {
        csg_cli_error("the name of the scene is empty");
        return false;
    }
    options->input = options->input ? options->input : path;
    options->inputs[options->num_inputs++] = path;
    return true;
}

static bool parse_arguments(struct parser *parser)
{
    bool only_paths = false;
    while (parser->next < parser->num) {
        const char *text = parser->argv[parser->next++];
        const bool is_option = text[0] == '-' && text[1] && !only_paths;
        if (is_option && !strcmp(text, "--"))
            only_paths = true;
        else if (!(is_option ? parse_option(parser, text)
                             : parse_input(parser->options, parser->command->many, text)))
            return false;
    }
    return true;
}

bool csg_options_parse(struct csg_cli_options *options, const struct csg_cli_command *command,
                       int num, char **argv)
{
    struct parser parser = {.options = options, .command = command, .argv = argv, .num = num};
    *options = (struct csg_cli_options){.facets = "auto",
                                        .compare = csg_compare_defaults,
                                        .report = {.limit = CSG_REPORT_LIMIT},
                                        .antialias = 1,
                                        .num_frames = 20,
                                        .edited_leaf = -1};
    /* One more than can be needed, so that the size is never 0. */
    options->defines = calloc((size_t)num + 1, sizeof *options->defines);
    options->inputs = calloc((size_t)num + 1, sizeof *options->inputs);
    options->fonts = calloc((size_t)num + 1, sizeof *options->fonts);
    if (!options->defines || !options->inputs || !options->fonts) {
        csg_cli_error("out of memory");
        return false;
    }
    if (!parse_arguments(&parser))
        return false;
    if (options->input && command->no_scene) {
        csg_cli_error("csgcast %s takes no scene: %s", command->name, options->input);
        return false;
    }
    if (!options->input && !options->help && !command->no_scene) {
        csg_cli_error("which %s? usage: csgcast %s %s",
                      command->bit == CSG_COMMAND_REPORT ? "folder" : "scene", command->name,
                      command->usage);
        return false;
    }
    options->scene.defines = options->defines;
    options->scene.fonts = options->fonts;
    options->scene.fixed = true;
    options->scene.log = options->renderer.log = options->write.log = csg_cli_log;
    options->scene.log_user = options->renderer.log_user = options->write.log_user =
        &options->quiet;
    return true;
}

void csg_options_finish(struct csg_cli_options *options)
{
    free(options->defines);
    free(options->inputs);
    free(options->fonts);
    options->fonts = NULL;
    options->defines = NULL;
    options->inputs = NULL;
}

/* The first line of an option's help, and its width. */
static int print_option_name(FILE *file, const struct csg_option *option)
{
    const char *metavar = option->metavar;
    const bool is_letter = option->letter && option->name[1] == '\0';
    if (is_letter || option->letter == 'D' || option->letter == 'o')
        return fprintf(file, "  -%c %s", option->letter, metavar);
    if (option->letter)
        return fprintf(file, "  -%c, --%s", option->letter, option->name);
    return fprintf(file, "  --%s%s%s", option->name, metavar ? "=" : "", metavar ? metavar : "");
}

static void print_option_text(FILE *file, const char *text, int width)
{
    if (width >= HELP_COLUMN) {
        fputc('\n', file);
        width = 0;
    }
    fprintf(file, "%*s", HELP_COLUMN - width, "");
    for (; *text; text++) {
        fputc(*text, file);
        if (*text == '\n')
            fprintf(file, "%*s", HELP_COLUMN, "");
    }
    fputc('\n', file);
}

void csg_options_print(FILE *file, const struct csg_cli_command *command)
{
    for (const struct csg_option *option = csg_option_table; option->name; option++) {
        if ((option->commands & (unsigned)command->bit) && option->help)
            print_option_text(file, option->help, print_option_name(file, option));
    }
}
