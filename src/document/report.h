/* SPDX-License-Identifier: MIT */
#ifndef CSG_DOCUMENT_REPORT_H
#define CSG_DOCUMENT_REPORT_H

/* The messages of one scene: each with its place, counted, and not more than anyone reads. */

#include <stddef.h>
#include <stdint.h>

#include "common/array.h"
#include "common/log.h"

/* Messages of one level that are shown; the others are counted. */
#define CSG_REPORT_SHOWN 50

struct csg_place {
    uint32_t line, column; /* from 1; a column is a byte */
};

struct csg_held_message {
    enum csgcast_log_level level;
    enum csgcast_message id;
    char *text;
};

struct csg_report {
    struct csg_log to;  /* where the messages go in the end */
    struct csg_log log; /* hands messages to the report, for code that only knows a log */
    const char *file;   /* borrowed; stands in front of each message */
    size_t num[CSGCAST_LOG_INFO + 1]; /* so far, by level */
    bool is_holding;
    size_t num_before[CSGCAST_LOG_INFO + 1]; /* num when the holding began */
    CSG_ARRAY(struct csg_held_message) held;
};

/* The report stays where it is: log points to it. */
void csg_report_init(struct csg_report *report, const struct csg_log *to, const char *file);

/* "file:line:column: text" */
void csg_report_print(struct csg_report *report, enum csgcast_log_level level,
                      enum csgcast_message id, struct csg_place place, const char *format, ...)
    CSG_PRINTF(5, 6);

#define csg_report_error(report, id, place, ...)                                                   \
    csg_report_print(report, CSGCAST_LOG_ERROR, id, place, __VA_ARGS__)
#define csg_report_warning(report, id, place, ...)                                                 \
    csg_report_print(report, CSGCAST_LOG_WARNING, id, place, __VA_ARGS__)

/* From now on messages are kept back, until they are passed on or, as if they had never been,
 * dropped. */
void csg_report_hold(struct csg_report *report);
void csg_report_release(struct csg_report *report);
void csg_report_drop(struct csg_report *report);

/* Says how many messages were not shown. false when there were errors. */
bool csg_report_finish(struct csg_report *report);

#endif
