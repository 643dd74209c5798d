/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_PROCESS_H
#define CSG_CLI_PROCESS_H

/* Other programs, run to their end or to a time limit, and a folder for what they write. */

#include <stdbool.h>
#include <stdint.h>

#include "common/folder.h"

enum csg_process_end {
    CSG_PROCESS_DONE,      /* exit status 0 */
    CSG_PROCESS_FAILED,    /* another status, or a signal */
    CSG_PROCESS_MISSING,   /* no such program */
    CSG_PROCESS_TIMED_OUT, /* killed */
};

/*
 * Runs argv, found on the path, without a shell. What it prints goes to the file log (NULL: to
 * /dev/null). limit: seconds, 0 for none. memory: as in struct csg_process_bounds. seconds: how long
 * it took; may be NULL.
 */
enum csg_process_end csg_process_run(const char *const *argv, const char *log, double limit,
                                     uint64_t memory, double *seconds);

/* Whether a program of that name is on the path. */
bool csg_process_exists(const char *program);

/* csg_folder_make, with a message where it fails. */
bool csg_process_make_folder(struct csg_folder *folder);

#endif
