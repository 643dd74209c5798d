/* SPDX-License-Identifier: MIT */
#include "document/report.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* When memory is out the message is passed on at once: late is worse than early. */
static bool keep(struct csg_report *report, enum csgcast_log_level level, enum csgcast_message id,
                 const char *text)
{
    const size_t size = strlen(text) + 1;
    const struct csg_held_message message = {level, id, malloc(size)};
    if (!message.text)
        return false;
    memcpy(message.text, text, size);
    if (csg_array_push(&report->held, message))
        return true;
    free(message.text);
    return false;
}

static void count_and_pass_on(void *user, enum csgcast_log_level level, enum csgcast_message id,
                              const char *text)
{
    struct csg_report *report = user;
    if (report->num[level]++ >= CSG_REPORT_SHOWN && level != CSGCAST_LOG_INFO)
        return;
    if (!report->is_holding || !keep(report, level, id, text))
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
    char small[CSG_LOG_SMALL];
    va_list args;
    if (level != CSGCAST_LOG_INFO && report->num[level] >= CSG_REPORT_SHOWN) {
        report->num[level]++;
        return;
    }
    va_start(args, format);
    char *large = csg_log_format(small, format, args);
    va_end(args);
    csg_log_print(&report->log, level, id, "%s:%u:%u: %s", report->file, (unsigned)place.line,
                  (unsigned)place.column, large ? large : small);
    free(large);
}

void csg_report_hold(struct csg_report *report)
{
    report->is_holding = true;
    memcpy(report->num_before, report->num, sizeof report->num);
}

static void end_holding(struct csg_report *report)
{
    for (size_t i = 0; i < report->held.num; i++)
        free(report->held.data[i].text);
    free(report->held.data);
    report->held.data = NULL;
    report->held.num = report->held.capacity = 0;
    report->is_holding = false;
}

void csg_report_release(struct csg_report *report)
{
    for (size_t i = 0; i < report->held.num; i++)
        csg_log_print(&report->to, report->held.data[i].level, report->held.data[i].id, "%s",
                      report->held.data[i].text);
    end_holding(report);
}

void csg_report_drop(struct csg_report *report)
{
    memcpy(report->num, report->num_before, sizeof report->num);
    end_holding(report);
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
