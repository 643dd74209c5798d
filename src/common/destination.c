/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* O_TMPFILE, realpath */
#endif

/*
 * Where the file system can, the file has no name until it is finished, so that nothing is left of
 * it however the process ends. Elsewhere it has one beside its target.
 */

#include "common/destination.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Names tried before giving up. */
#define MAX_TEMPORARIES 100

bool csg_destination_fail(const struct csg_destination *to, const char *reason)
{
    csg_log_error(to->log, CSGCAST_MESSAGE_FILE, "%s: %s", to->path, reason);
    return false;
}

/* A device or pipe is written to: a rename would replace it by a file. */
static bool open_stream(struct csg_destination *to)
{
    to->stream = open(to->path, O_WRONLY | O_CLOEXEC);
    return to->stream >= 0 || csg_destination_fail(to, strerror(errno));
}

static bool find_existing(struct csg_destination *to, const struct stat *status)
{
    if (S_ISDIR(status->st_mode))
        return csg_destination_fail(to, "is a directory");
    if (!S_ISREG(status->st_mode))
        return open_stream(to);
    if (access(to->path, W_OK) != 0 || !realpath(to->path, to->target))
        return csg_destination_fail(to, strerror(errno));
    to->mode = status->st_mode & 0777;
    return true;
}

static bool find_target(struct csg_destination *to)
{
    struct stat status;
    if (!strcmp(to->path, "-")) {
        to->stream = STDOUT_FILENO;
        return true;
    }
    if (stat(to->path, &status) == 0)
        return find_existing(to, &status);
    if (errno != ENOENT)
        return csg_destination_fail(to, strerror(errno));
    if (strlen(to->path) >= sizeof to->target)
        return csg_destination_fail(to, strerror(ENAMETOOLONG));
    strcpy(to->target, to->path);
    return true;
}

/* The folder of the target, whose file system the rename needs; any for a stream. Ends with /. */
static void find_folder(const struct csg_destination *to, char folder[PATH_MAX])
{
    const char *slash = strrchr(to->target, '/');
    const char *temporary = getenv("TMPDIR");
    if (!to->target[0])
        snprintf(folder, PATH_MAX, "%s/", temporary && *temporary ? temporary : "/tmp");
    else if (slash)
        snprintf(folder, PATH_MAX, "%.*s", (int)(slash - to->target) + 1, to->target);
    else
        strcpy(folder, "./");
}

/* A name beside the target. It keeps the extension: some formats go by it. */
static void name_beside(char name[CSG_DESTINATION_MAX], const char *folder, int number,
                        const char *extension)
{
    snprintf(name, CSG_DESTINATION_MAX, "%s.csgcast-%ld-%d.%s", folder, (long)getpid(), number,
             extension);
}

static bool make_nameless(struct csg_destination *to, const char *folder, mode_t mode)
{
    to->file = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, mode);
    if (to->file < 0)
        return false;
    snprintf(to->temporary, sizeof to->temporary, "/proc/self/fd/%d", to->file);
    if (access(to->temporary, R_OK | W_OK) == 0)
        return true;
    close(to->file); /* there is no /proc */
    to->file = -1;
    return false;
}

static bool make_named(struct csg_destination *to, const char *folder, const char *extension,
                       mode_t mode)
{
    for (int i = 0; i < MAX_TEMPORARIES && to->file < 0; i++) {
        name_beside(to->temporary, folder, i, extension);
        to->file = open(to->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (to->file < 0 && errno != EEXIST)
            break;
    }
    return to->file >= 0;
}

static bool make_temporary(struct csg_destination *to, const char *extension)
{
    char folder[PATH_MAX];
    find_folder(to, folder);
    const mode_t mode = to->target[0] ? 0666 : 0600; /* less what umask takes away */
    to->is_nameless = make_nameless(to, folder, mode);
    if (to->is_nameless || make_named(to, folder, extension, mode)) {
        if (to->mode)
            fchmod(to->file, to->mode);
        return true;
    }
    to->temporary[0] = '\0';
    csg_log_error(to->log, CSGCAST_MESSAGE_FILE, "%s: cannot create a file in %s: %s", to->path,
                  folder, strerror(errno));
    return false;
}

bool csg_destination_open(struct csg_destination *to, const char *extension)
{
    to->stream = to->file = -1;
    return find_target(to) && make_temporary(to, extension);
}

static bool write_all(int file, const char *bytes, size_t size)
{
    while (size > 0) {
        const ssize_t written = write(file, bytes, size);
        if (written < 0 && errno != EINTR)
            return false;
        bytes += written > 0 ? written : 0;
        size -= written > 0 ? (size_t)written : 0;
    }
    return true;
}

static bool copy_to_stream(const struct csg_destination *to)
{
    char bytes[65536];
    const int file = open(to->temporary, O_RDONLY | O_CLOEXEC);
    bool ok = file >= 0;
    ssize_t size = 0;
    while (ok && (size = read(file, bytes, sizeof bytes)) > 0)
        ok = write_all(to->stream, bytes, (size_t)size);
    ok = ok && size == 0;
    if (!ok)
        csg_destination_fail(to, strerror(errno));
    if (file >= 0)
        close(file);
    return ok;
}

static bool link_to(const struct csg_destination *to, const char *name)
{
    return linkat(AT_FDCWD, to->temporary, AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
}

/* What is there already cannot be linked over, but renamed over. */
static bool give_name(struct csg_destination *to)
{
    char folder[PATH_MAX], beside[CSG_DESTINATION_MAX];
    bool linked = false;
    if (link_to(to, to->target))
        return true;
    find_folder(to, folder);
    for (int i = 0; i < MAX_TEMPORARIES && errno == EEXIST && !linked; i++) {
        name_beside(beside, folder, i, "part");
        linked = link_to(to, beside);
    }
    if (linked && rename(beside, to->target) == 0)
        return true;
    const int error = errno;
    if (linked)
        unlink(beside);
    errno = error;
    return false;
}

bool csg_destination_commit(struct csg_destination *to)
{
    if (to->stream >= 0)
        return copy_to_stream(to);
    if (!(to->is_nameless ? give_name(to) : rename(to->temporary, to->target) == 0))
        return csg_destination_fail(to, strerror(errno));
    to->temporary[0] = '\0';
    return true;
}

void csg_destination_close(struct csg_destination *to)
{
    if (to->temporary[0] && !to->is_nameless)
        unlink(to->temporary);
    if (to->file >= 0)
        close(to->file);
    if (to->stream >= 0 && to->stream != STDOUT_FILENO)
        close(to->stream);
}
