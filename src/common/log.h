/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_LOG_H
#define CSG_COMMON_LOG_H

#include <stdarg.h>

#include "csgcast/csgcast.h"

/* Where the messages of one scene, renderer or call go. Copied by value. */
struct csg_log {
    csgcast_log_fn *fn; /* NULL: standard error */
    void *user;
};

#if defined(__GNUC__)
#define CSG_PRINTF(fmt, args) __attribute__((format(printf, fmt, args)))
#else
#define CSG_PRINTF(fmt, args)
#endif

enum { CSG_LOG_SMALL = 512 };

/* Formats a text of any length: into small, or where that does not hold it into a new string, which
 * the caller frees; else, and without memory, NULL. */
char *csg_log_format(char small[CSG_LOG_SMALL], const char *format, va_list args) CSG_PRINTF(2, 0);

/* Formats one message of any length and hands it to the callback. */
void csg_log_print(const struct csg_log *log, enum csgcast_log_level level, enum csgcast_message id,
                   const char *format, ...) CSG_PRINTF(4, 5);

#define csg_log_error(log, id, ...) csg_log_print(log, CSGCAST_LOG_ERROR, id, __VA_ARGS__)
#define csg_log_warning(log, id, ...) csg_log_print(log, CSGCAST_LOG_WARNING, id, __VA_ARGS__)

/* Where messages go that nobody needs. */
extern const struct csg_log csg_log_silent;

/* The one message for a failed allocation. Always returns false. */
bool csg_log_memory(const struct csg_log *log);

#endif
