/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_COMMANDS_H
#define CSG_CLI_COMMANDS_H

#include <stdbool.h>

struct csg_cli_options;

/* What the process returns. Documented in docs/csgcast.1 and in the help text. */
enum csg_cli_exit {
    CSG_EXIT_OK = 0,
    CSG_EXIT_FAILED = 1, /* the scene cannot be read or rendered */
    CSG_EXIT_USAGE = 2,  /* the command line makes no sense */
    CSG_EXIT_OUTPUT = 3, /* the result cannot be written */
    CSG_EXIT_BEYOND = 1, /* compare: a threshold does not hold; every failure is 2 there */
};

/* Bits that say which commands take an option. */
enum csg_cli_command_bit {
    CSG_COMMAND_RENDER = 1,
    CSG_COMMAND_INFO = 2,
    CSG_COMMAND_EXPORT = 4,
    CSG_COMMAND_BENCH = 8,
    CSG_COMMAND_COMPARE = 16,
    CSG_COMMAND_REPORT = 32,
    CSG_COMMAND_CACHE = 64,
    CSG_COMMAND_WARM = 128,
};

struct csg_cli_command {
    const char *name;
    enum csg_cli_command_bit bit;
    bool no_scene;       /* takes none */
    const char *summary; /* one line for the list of commands */
    const char *usage;   /* what follows "csgcast NAME" */
    const char *text;    /* help between usage and options */
    const char *tail;    /* help after the options: examples */
    bool many;           /* takes more than one scene */
    const char *exits;   /* the exit codes in the help; NULL: those of enum csg_cli_exit */
    enum csg_cli_exit (*run)(const struct csg_cli_options *options);
};

extern const struct csg_cli_command csg_command_render, csg_command_info, csg_command_export,
    csg_command_compare, csg_command_bench, csg_command_cache, csg_command_report, csg_command_warm;

#endif
