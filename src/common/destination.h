/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_DESTINATION_H
#define CSG_COMMON_DESTINATION_H

/*
 * Where a file goes that must appear whole or not at all: it is written without a name, or under
 * another one beside its target, and gets its own when it is finished. "-", devices and pipes get a
 * copy of the finished file instead.
 *
 *     struct csg_destination to = {.path = path, .log = &log};
 *     bool ok = csg_destination_open(&to, "png") && ... write the file to.temporary ... &&
 *               csg_destination_commit(&to);
 *     csg_destination_close(&to);
 */

#include <limits.h>
#include <sys/types.h>

#include "common/log.h"

#define CSG_DESTINATION_MAX (PATH_MAX + 64)

struct csg_destination {
    const char *path; /* as the caller names it, for messages */
    const struct csg_log *log;
    char target[PATH_MAX];               /* what it becomes; empty: a stream */
    char temporary[CSG_DESTINATION_MAX]; /* to be written; empty when there is none */
    bool is_nameless;                    /* it leads to file, which has no other name */
    int file, stream;                    /* file descriptors: of temporary, to copy to; or -1 */
    mode_t mode;                         /* of a file that is replaced; 0: a new one */
};

/* Makes the empty file to.temporary; where it has a name, that ends with the given extension.
 * false, with a message, where there is no place for it. */
bool csg_destination_open(struct csg_destination *to, const char *extension);

/* Puts the file in its place. false, with a message, on failure: what was there before stays. */
bool csg_destination_commit(struct csg_destination *to);

/* Removes what was not committed. To be called whatever happened. */
void csg_destination_close(struct csg_destination *to);

/* "PATH: REASON" as an error about a file. Always returns false. */
bool csg_destination_fail(const struct csg_destination *to, const char *reason);

#endif
