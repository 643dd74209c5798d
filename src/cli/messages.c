/* SPDX-License-Identifier: MIT */
#include "messages.h"

#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

void csg_cli_error(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fputs("csgcast: error: ", stderr);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
}

void csg_cli_warning(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fputs("csgcast: warning: ", stderr);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
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
