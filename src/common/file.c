/* SPDX-License-Identifier: MIT */
#include "common/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/array.h"
#include "common/join.h"

/* Room asked for at a time where the size is not known. */
static const size_t chunk_size = 1 << 16;

bool csg_bytes_append(struct csg_bytes *bytes, const void *data, size_t size)
{
    if (!csg_array_reserve(bytes, size))
        return false;
    if (size > 0)
        memcpy(bytes->data + bytes->num, data, size);
    bytes->num += size;
    return true;
}

bool csg_bytes_append_text(struct csg_bytes *bytes, const char *text)
{
    return csg_bytes_append(bytes, text, strlen(text));
}

/* To its end. false, with errno set, on failure. */
static bool read_all(int fd, struct csg_bytes *bytes)
{
    for (;;) {
        if (!csg_array_reserve(bytes, chunk_size)) {
            errno = ENOMEM;
            return false;
        }
        const ssize_t got = read(fd, bytes->data + bytes->num, bytes->capacity - bytes->num);
        if (got == 0)
            return true;
        if (got > 0)
            bytes->num += (size_t)got;
        else if (errno != EINTR)
            return false;
    }
}

/* A regular file's size is known: one allocation. */
static bool read_sized(int fd, struct csg_bytes *bytes)
{
    struct stat info;
    if (fstat(fd, &info) != 0)
        return false;
    if (S_ISREG(info.st_mode) && info.st_size > 0 &&
        !csg_array_reserve(bytes, (size_t)info.st_size + chunk_size)) {
        errno = ENOMEM;
        return false;
    }
    return read_all(fd, bytes);
}

static char *current_folder(void)
{
    char *name = NULL;
    size_t size = 256;
    do {
        free(name);
        size *= 2;
        name = malloc(size);
    } while (name && !getcwd(name, size) && errno == ERANGE);
    return name;
}

char *csg_path_absolute(const char *path)
{
    if (path[0] == '/')
        return csg_join("", path);
    char *here = current_folder();
    char *absolute = here ? csg_join_three(here, "/", path) : NULL;
    free(here);
    return absolute;
}

bool csg_path_ends(const char *path, const char *ending)
{
    const size_t length = strlen(path), ending_length = strlen(ending);
    if (length < ending_length)
        return false;
    for (size_t i = 0; i < ending_length; i++) {
        const char c = path[length - ending_length + i];
        if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != ending[i])
            return false;
    }
    return true;
}

bool csg_file_read(const char *path, struct csg_bytes *bytes, const struct csg_log *log)
{
    const bool is_input = strcmp(path, "-") == 0;
    const int fd = is_input ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    *bytes = (struct csg_bytes){0};
    const bool done = fd >= 0 && read_sized(fd, bytes);
    if (!done) {
        csg_log_error(log, CSGCAST_MESSAGE_FILE, "cannot read %s: %s",
                      is_input ? "standard input" : path, strerror(errno));
        free(bytes->data);
        *bytes = (struct csg_bytes){0};
    }
    if (fd >= 0 && !is_input)
        close(fd);
    return done;
}

bool csg_file_read_regular(const char *path, struct csg_bytes *bytes)
{
    struct stat info;
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    bool ok = fd >= 0 && fstat(fd, &info) == 0;
    if (ok && !S_ISREG(info.st_mode)) {
        errno = EINVAL;
        ok = false;
    }
    ok = ok && read_all(fd, bytes);
    const int reason = errno;
    if (fd >= 0)
        close(fd);
    errno = reason;
    return ok;
}
