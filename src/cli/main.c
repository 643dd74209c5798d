/* SPDX-License-Identifier: MIT */

/* csgcast COMMAND ARGUMENTS: finds the command, reads its options, prints the help texts. */

#include "commands.h"
#include "common/spelling.h"
#include "csgcast/csgcast.h"
#include "ending.h"
#include "messages.h"
#include "option_table.h"
#include "options.h"
#include "scene_options.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

static const struct csg_cli_command *const commands[] = {
    &csg_command_render, &csg_command_info,   &csg_command_export, &csg_command_compare,
    &csg_command_bench,  &csg_command_report, &csg_command_cache,  &csg_command_warm};

#define NUM_COMMANDS (sizeof commands / sizeof *commands)
#define MAX_SUGGESTION_DISTANCE 3

static void print_names(const char *title, const char *(*name)(size_t index))
{
    printf("\n%s\n ", title);
    for (size_t i = 0; name(i); i++)
        printf("%s %s", i ? "," : "", name(i));
    printf("\n");
}

static void print_exit_codes(const char *exits)
{
    printf("\nExit codes\n%s", exits ? exits
                                     : "  0  all went well\n"
                                       "  1  the scene cannot be read or rendered\n"
                                       "  2  the command line makes no sense\n"
                                       "  3  the result cannot be written\n");
}

static void print_overview(void)
{
    printf("csgcast renders constructive solid geometry exactly: OpenSCAD's .csg and .scad files\n"
           "and docs/scene-format.md's.\n"
           "\n"
           "Usage\n"
           "  csgcast COMMAND FILE [OPTION...]\n"
           "  csgcast help COMMAND\n"
           "  csgcast --version\n"
           "\n"
           "Commands\n");
    for (size_t i = 0; i < NUM_COMMANDS; i++)
        printf("  %-8s %s\n", commands[i]->name, commands[i]->summary);
    printf("  %-8s %s\n", "help", "explain a command");
    printf("\n"
           "Examples\n"
           "  csgcast render part.scad -o part.png\n"
           "  csgcast info part.scad\n"
           "  csgcast help render\n");
    print_exit_codes(NULL);
}

static bool takes(const struct csg_cli_command *command, const char *name)
{
    const struct csg_option *option = csg_option_table;
    while (option->name && strcmp(option->name, name) != 0)
        option++;
    return option->commands & (unsigned)command->bit;
}

static void print_command_help(const struct csg_cli_command *command)
{
    printf("Usage\n  csgcast %s %s\n\n%s\nOptions (--name=value or --name value)\n", command->name,
           command->usage, command->text);
    csg_options_print(stdout, command);
    if (takes(command, "colorscheme"))
        print_names("Colour schemes", csgcast_colorscheme_name);
    if (takes(command, "variant"))
        print_names("Variants", csgcast_variant_name);
    printf("\nExamples\n%s", command->tail);
    print_exit_codes(command->exits);
}

static const struct csg_cli_command *find_command(const char *name)
{
    for (size_t i = 0; i < NUM_COMMANDS; i++) {
        if (!strcmp(commands[i]->name, name))
            return commands[i];
    }
    return NULL;
}

static enum csg_cli_exit complain_command(const char *name)
{
    if (strchr(name, '.') && !access(name, R_OK)) {
        csg_cli_error("%s is no command; did you mean `csgcast render %s`?", name, name);
        return CSG_EXIT_USAGE;
    }
    for (size_t i = 0; i < NUM_COMMANDS; i++) {
        if (csg_spelling_distance(name, strlen(name), commands[i]->name,
                                  strlen(commands[i]->name)) <= MAX_SUGGESTION_DISTANCE) {
            csg_cli_error("unknown command %s; did you mean %s?", name, commands[i]->name);
            return CSG_EXIT_USAGE;
        }
    }
    csg_cli_error("unknown command %s; see `csgcast help`", name);
    return CSG_EXIT_USAGE;
}

static enum csg_cli_exit run_help(int num, char **argv)
{
    if (num == 0) {
        print_overview();
        return csg_cli_end_output(CSG_EXIT_OK, CSG_EXIT_OUTPUT);
    }
    const struct csg_cli_command *command = find_command(argv[0]);
    if (!command)
        return complain_command(argv[0]);
    print_command_help(command);
    return csg_cli_end_output(CSG_EXIT_OK, CSG_EXIT_OUTPUT);
}

static enum csg_cli_exit run_version(void)
{
    printf("csgcast %s\n", csgcast_version());
    return csg_cli_end_output(CSG_EXIT_OK, CSG_EXIT_OUTPUT);
}

static enum csg_cli_exit run_command(const struct csg_cli_command *command, int num, char **argv)
{
    struct csg_cli_options options;
    enum csg_cli_exit result = CSG_EXIT_USAGE;
    if (csg_options_parse(&options, command, num, argv)) {
        if (options.help)
            print_command_help(command);
        else
            csg_warn_unheeded(&options);
        result = options.help ? csg_cli_end_output(CSG_EXIT_OK, CSG_EXIT_OUTPUT)
                              : command->run(&options);
    }
    csg_options_finish(&options);
    return result;
}

/* glibc gives threads heaps that grow by the page, each a system call: a tenth of a first
 * picture. */
static void share_heap(void)
{
#ifdef M_ARENA_MAX
    mallopt(M_ARENA_MAX, 1);
#endif
}

/* A closed one among standard input, output and error would be the next file that is opened, and
 * take what is meant for it. What is opened here in its place fails as it would. */
static void hold_closed_streams(void)
{
    for (int file = STDIN_FILENO; file <= STDERR_FILENO; file++)
        if (fcntl(file, F_GETFD) < 0)
            open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int main(int argc, char **argv)
{
    hold_closed_streams();
    if (argc < 2) {
        csg_cli_error("which command? see `csgcast help`");
        return CSG_EXIT_USAGE;
    }
    const char *name = argv[1];
    if (!strcmp(name, "help") || !strcmp(name, "--help") || !strcmp(name, "-h"))
        return (int)run_help(argc - 2, argv + 2);
    if (!strcmp(name, "--version") || !strcmp(name, "-v") || !strcmp(name, "version"))
        return (int)run_version();
    const struct csg_cli_command *command = find_command(name);
    if (!command)
        return (int)complain_command(name);
    share_heap();
    csg_ending_begin();
    return (int)run_command(command, argc - 2, argv + 2);
}
