/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_MESSAGES_H
#define CSG_CLI_MESSAGES_H

#include "commands.h"
#include "csgcast/csgcast.h"

#if defined(__GNUC__)
#define CSG_CLI_PRINTF(fmt, args) __attribute__((format(printf, fmt, args)))
#else
#define CSG_CLI_PRINTF(fmt, args)
#endif

/* "csgcast: error: ..." on standard error. */
void csg_cli_error(const char *format, ...) CSG_CLI_PRINTF(1, 2);
void csg_cli_warning(const char *format, ...) CSG_CLI_PRINTF(1, 2);

/* What was printed counts as written only when standard output took it: result, or with a message
 * the exit code for when it did not. */
enum csg_cli_exit csg_cli_end_output(enum csg_cli_exit result, enum csg_cli_exit failed);

/* The library's messages in the same form. user: a const bool, true to print errors only. */
void csg_cli_log(void *user, enum csgcast_log_level level, enum csgcast_message id,
                 const char *text);

#endif
