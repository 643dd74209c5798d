/* SPDX-License-Identifier: MIT */
#include "common/log.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static void print_to_stderr(enum csgcast_log_level level, enum csgcast_message id,
                            const char *text)
{
    static const char *const prefix[] = {"error: ", "warning: ", ""};
    if (id != CSGCAST_MESSAGE_PROGRESS || isatty(STDERR_FILENO))
        fprintf(stderr, "csgcast: %s%s\n", prefix[level], text);
}

void csg_log_print(const struct csg_log *log, enum csgcast_log_level level,
                   enum csgcast_message id, const char *format, ...)
{
    char small[512];
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    const int length = vsnprintf(small, sizeof small, format, args);
    char *large = NULL;
    if (length >= (int)sizeof small && (large = malloc((size_t)length + 1)))
        vsnprintf(large, (size_t)length + 1, format, again);
    const char *text = large ? large : small;
    if (log && log->fn)
        log->fn(log->user, level, id, text);
    else
        print_to_stderr(level, id, text);
    free(large);
    va_end(again);
    va_end(args);
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
