/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_OUTPUT_H
#define CSG_CLI_OUTPUT_H

/* Where a command's file goes. */

#include "options.h"

typedef enum csg_cli_exit csg_cli_output_fn(const struct csg_cli_options *options,
                                            const char *output, void *user);

/*
 * Calls run with options->output or, without -o, the input's name with the extension of
 * options->write.format (NULL: the one given) in the current directory. Finds out before the work,
 * and not after it, that the file has nowhere to go.
 */
enum csg_cli_exit csg_cli_with_output(const struct csg_cli_options *options, const char *extension,
                                      csg_cli_output_fn *run, void *user);

/* Whether several inputs have a file each to go to; says which have not. */
bool csg_cli_check_outputs(const struct csg_cli_options *options, const char *extension);

#endif
