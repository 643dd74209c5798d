/* SPDX-License-Identifier: MIT */
#include "scene/report.h"

#include <stdarg.h>
#include <stdio.h>

static void count_and_pass_on(void *user, enum csgcast_log_level level, enum csgcast_message id,
                              const char *text)
{
    struct csg_report *report = user;
    if (report->num[level]++ < CSG_REPORT_SHOWN || level == CSGCAST_LOG_INFO)
        csg_log_print(&report->to, level, id, "%s", text);
}

void csg_report_init(struct csg_report *report, const struct csg_log *to, const char *file)
{
    *report = (struct csg_report){.to = *to, .file = file};
    report->log = (struct csg_log){count_and_pass_on, report};
}

void csg_report_print(struct csg_report *report, enum csgcast_log_level level,
                      enum csgcast_message id, struct csg_place place, const char *format, ...)
{
    char text[512];
    va_list args;
    if (level != CSGCAST_LOG_INFO && report->num[level] >= CSG_REPORT_SHOWN) {
        report->num[level]++;
        return;
    }
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    csg_log_print(&report->log, level, id, "%s:%u:%u: %s", report->file, (unsigned)place.line,
                  (unsigned)place.column, text);
}

static void print_rest(struct csg_report *report, enum csgcast_log_level level, const char *what)
{
    if (report->num[level] > CSG_REPORT_SHOWN)
        csg_log_print(&report->to, level, CSGCAST_MESSAGE_SCENE, "%s: %zu more %s", report->file,
                      report->num[level] - CSG_REPORT_SHOWN, what);
}

bool csg_report_finish(struct csg_report *report)
{
    print_rest(report, CSGCAST_LOG_ERROR, "errors");
    print_rest(report, CSGCAST_LOG_WARNING, "warnings");
    return report->num[CSGCAST_LOG_ERROR] == 0;
}
