/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_FILE_H
#define CSG_COMMON_FILE_H

#include <stddef.h>

#include "common/log.h"

/* The bytes of a file; the caller frees data. */
struct csg_bytes {
    char *data;
    size_t num, capacity;
};

/* false: out of memory. */
bool csg_bytes_append(struct csg_bytes *bytes, const void *data, size_t size);
bool csg_bytes_append_text(struct csg_bytes *bytes, const char *text);

/* Reads a whole file of any size, "-" being standard input. false: a message was given. */
bool csg_file_read(const char *path, struct csg_bytes *bytes, const struct csg_log *log);

/* The same for what must be a file, not a pipe that may never end, without a message: false, with
 * errno set. */
bool csg_file_read_regular(const char *path, struct csg_bytes *bytes);

/* The path from the root on, for the caller to free. NULL: out of memory. */
char *csg_path_absolute(const char *path);

/* Whether the path has that ending, such as ".scad", in upper or lower case. */
bool csg_path_ends(const char *path, const char *ending);

#endif
