/* SPDX-License-Identifier: MIT */
#include "common/log.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static void print_to_stderr(enum csgcast_log_level level, enum csgcast_message id, const char *text)
{
    static const char *const prefix[] = {"error: ", "warning: ", ""};
    if (id != CSGCAST_MESSAGE_PROGRESS || isatty(STDERR_FILENO))
        fprintf(stderr, "csgcast: %s%s\n", prefix[level], text);
}

char *csg_log_format(char small[CSG_LOG_SMALL], const char *format, va_list args)
{
    va_list again;
    va_copy(again, args);
    const int length = vsnprintf(small, CSG_LOG_SMALL, format, args);
    char *large = length >= CSG_LOG_SMALL ? malloc((size_t)length + 1) : NULL;
    if (large)
        vsnprintf(large, (size_t)length + 1, format, again);
    va_end(again);
    return large;
}

void csg_log_print(const struct csg_log *log, enum csgcast_log_level level, enum csgcast_message id,
                   const char *format, ...)
{
    char small[CSG_LOG_SMALL];
    va_list args;
    va_start(args, format);
    char *large = csg_log_format(small, format, args);
    va_end(args);
    const char *text = large ? large : small;
    if (log && log->fn)
        log->fn(log->user, level, id, text);
    else
        print_to_stderr(level, id, text);
    free(large);
}

static void ignore(void *user, enum csgcast_log_level level, enum csgcast_message id,
                   const char *text)
{
    (void)user;
    (void)level;
    (void)id;
    (void)text;
}

const struct csg_log csg_log_silent = {ignore, NULL};

bool csg_log_memory(const struct csg_log *log)
{
    csg_log_error(log, CSGCAST_MESSAGE_MEMORY, "out of memory");
    return false;
}
