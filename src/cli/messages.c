/* SPDX-License-Identifier: MIT */
#include "messages.h"

#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

static void print(const char *prefix, const char *format, va_list args)
{
    fprintf(stderr, "csgcast: %s: ", prefix);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
}

void csg_cli_error(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    print("error", format, args);
    va_end(args);
}

void csg_cli_warning(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    print("warning", format, args);
    va_end(args);
}

enum csg_cli_exit csg_cli_end_output(enum csg_cli_exit result, enum csg_cli_exit failed)
{
    if (!fflush(stdout) && !ferror(stdout))
        return result;
    csg_cli_error("cannot write to standard output");
    return failed;
}

void csg_cli_log(void *user, enum csgcast_log_level level, enum csgcast_message id,
                 const char *text)
{
    static const char *const prefix[] = {"error: ", "warning: ", ""};
    const bool *quiet = user;
    if (id == CSGCAST_MESSAGE_PROGRESS && !isatty(STDERR_FILENO))
        return;
    if (level == CSGCAST_LOG_ERROR || !*quiet)
        fprintf(stderr, "csgcast: %s%s\n", prefix[level], text);
}
