/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_OPTION_TABLE_H
#define CSG_CLI_OPTION_TABLE_H

#include "options.h"

enum csg_option_argument {
    CSG_ARGUMENT_NONE,
    CSG_ARGUMENT_REQUIRED, /* --name=value or --name value */
    CSG_ARGUMENT_OPTIONAL, /* --name or --name=value */
};

/* One option that we have. */
struct csg_option {
    const char *name; /* without the dashes */
    char letter;      /* 0: none */
    enum csg_option_argument argument;
    unsigned commands;   /* csg_cli_command_bit, ORed */
    const char *metavar; /* how the help names its value; NULL: it has none */
    const char *help;    /* lines separated by \n; NULL: an alias that the help does not list */
    csg_option_set_fn *set;
};

/* One of OpenSCAD's options that scripts pass and that we do not have. */
struct csg_foreign_option {
    const char *name;
    char letter;
    enum csg_option_argument argument;
    bool refuse;        /* ignoring it would give another picture than the one asked for */
    const char *reason; /* "has no effect: ..." or "is not supported: ..." */
};

/* Both end with a NULL name. */
extern const struct csg_option csg_option_table[];
extern const struct csg_foreign_option csg_foreign_option_table[];

#endif
