/* SPDX-License-Identifier: MIT */
#ifndef _DEFAULT_SOURCE
#define _DEFAULT_SOURCE /* flock, mkdtemp */
#endif

/*
 * Whoever uses a folder holds a lock on it, which the system takes away however the process ends:
 * a folder that can be locked belongs to nobody. File systems without locks keep what was left.
 */
#include "common/folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/join.h"

/* Not what a script's mktemp may be told, nor a csgcast that holds no locks. */
#define PREFIX "csgcast-run-"
#define PATTERN PREFIX "XXXXXX"

static const int folder_flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

static const char *parent_folder(void)
{
    const char *named = getenv("TMPDIR");
    return named && named[0] == '/' ? named : "/tmp";
}

/* Fails for folders in it, which are none of ours, and leaves them. */
static void remove_files(int folder)
{
    const int copy = dup(folder); /* the other one goes on holding the lock */
    DIR *stream = copy >= 0 ? fdopendir(copy) : NULL;
    for (struct dirent *item = stream ? readdir(stream) : NULL; item; item = readdir(stream))
        unlinkat(folder, item->d_name, 0);
    if (stream)
        closedir(stream);
    else if (copy >= 0)
        close(copy);
}

static bool is_ours(int folder)
{
    struct stat status;
    return fstat(folder, &status) == 0 && status.st_uid == geteuid() &&
           (status.st_mode & 0777) == 0700;
}

static void remove_if_left(int parent, const char *name)
{
    const int folder = openat(parent, name, folder_flags);
    if (folder < 0)
        return;
    if (is_ours(folder) && flock(folder, LOCK_EX | LOCK_NB) == 0) {
        remove_files(folder);
        unlinkat(parent, name, AT_REMOVEDIR);
    }
    close(folder);
}

static void remove_left_ones(void)
{
    DIR *stream = opendir(parent_folder());
    for (struct dirent *item = stream ? readdir(stream) : NULL; item; item = readdir(stream)) {
        if (strlen(item->d_name) == strlen(PATTERN) &&
            strncmp(item->d_name, PREFIX, strlen(PREFIX)) == 0)
            remove_if_left(dirfd(stream), item->d_name);
    }
    if (stream)
        closedir(stream);
}

/* false, with errno ENOENT: another process took it for left, before we had its lock. */
static bool hold(struct csg_folder *folder)
{
    folder->lock = open(folder->path, folder_flags);
    if (folder->lock < 0)
        return false;
    flock(folder->lock, LOCK_EX); /* where there are no locks, nobody removes it either */
    if (access(folder->path, F_OK) == 0)
        return true;
    close(folder->lock);
    errno = ENOENT;
    return false;
}

/* false, with errno set: there is none. */
static bool make_held(struct csg_folder *folder)
{
    folder->path = csg_join(parent_folder(), "/" PATTERN);
    if (folder->path && mkdtemp(folder->path) && hold(folder))
        return true;
    const int error = errno;
    if (folder->path)
        rmdir(folder->path);
    free(folder->path);
    *folder = (struct csg_folder){0};
    errno = error;
    return false;
}

bool csg_folder_make(struct csg_folder *folder)
{
    enum { max_tries = 100 };
    remove_left_ones();
    for (int i = 0; i < max_tries; i++) {
        if (make_held(folder))
            return true;
        if (errno != ENOENT)
            return false;
    }
    return false;
}

char *csg_folder_file(const struct csg_folder *folder, const char *name)
{
    return csg_join_three(folder->path, "/", name);
}

bool csg_folder_has_room(const struct csg_folder *folder)
{
    static const char some[16384]; /* more than what is left in a file's last block */
    const int file = openat(folder->lock, "room", O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0)
        return false;
    const ssize_t written = write(file, some, sizeof some);
    const int error = written < 0 ? errno : ENOSPC;
    const bool closed = close(file) == 0;
    unlinkat(folder->lock, "room", 0);
    if (written == sizeof some && closed)
        return true;
    errno = closed ? error : errno;
    return false;
}

void csg_folder_remove(struct csg_folder *folder)
{
    if (!folder->path)
        return;
    remove_files(folder->lock);
    rmdir(folder->path);
    close(folder->lock);
    free(folder->path);
    *folder = (struct csg_folder){0};
}

/* The folders that this process holds are among its open files. */
void csg_folder_remove_all(void)
{
    DIR *stream = opendir("/proc/self/fd");
    for (struct dirent *item = stream ? readdir(stream) : NULL; item; item = readdir(stream)) {
        char path[PATH_MAX];
        const ssize_t length = readlinkat(dirfd(stream), item->d_name, path, sizeof path - 1);
        path[length > 0 ? length : 0] = '\0';
        const char *name = strrchr(path, '/');
        if (name && strncmp(name + 1, PREFIX, strlen(PREFIX)) == 0) {
            remove_files((int)strtol(item->d_name, NULL, 10));
            rmdir(path);
        }
    }
    if (stream)
        closedir(stream);
}
