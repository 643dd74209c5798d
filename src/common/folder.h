/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_FOLDER_H
#define CSG_COMMON_FOLDER_H

#include <stdbool.h>

/* A folder of our own for files in between. It starts as zeroes: no folder. */
struct csg_folder {
    char *path; /* absolute; NULL: none */
    int lock;   /* held as long as the folder is in use */
};

/*
 * Makes a folder below $TMPDIR or /tmp, and removes there what processes that were killed have
 * left: folders of the same user that nobody holds any more. false, with errno set, on failure.
 */
bool csg_folder_make(struct csg_folder *folder);

/* "FOLDER/NAME", for the caller to free. NULL: out of memory. */
char *csg_folder_file(const struct csg_folder *folder, const char *name);

/* Whether something can still be written there; false, with errno set, where the disk is full. */
bool csg_folder_has_room(const struct csg_folder *folder);

/* Removes the folder and the files in it. */
void csg_folder_remove(struct csg_folder *folder);

/* Removes all folders of this process, whatever uses them: it is about to end. */
void csg_folder_remove_all(void);

#endif
