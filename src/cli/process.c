/* SPDX-License-Identifier: MIT */
#include "process.h"

#include "messages.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <spawn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "common/clock.h"

extern char **environ;

/* How often a running program is looked at: its time is measured no finer. */
static const struct timespec poll_interval = {.tv_nsec = 2000000};

/* The exit status by which some systems say that a program could not be started. */
enum { STATUS_NOT_STARTED = 127 };

static double now(void)
{
    return csg_clock_ms() / 1000;
}

/* Returns an error number. */
static int start(const char *const *argv, const char *log, pid_t *child)
{
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);
    if (error)
        return error;
    error = posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (!error)
        error = posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log ? log : "/dev/null",
                                                 O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (!error)
        error = posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    if (!error)
        error =
            posix_spawnp(child, argv[0], &actions, NULL, (char *const *)(uintptr_t)argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

/* false: the limit came first, and the child is dead. */
static bool wait_for(pid_t child, double begun, double limit, int *status)
{
    for (;;) {
        const pid_t ended = waitpid(child, status, limit > 0 ? WNOHANG : 0);
        if (ended == child)
            return true;
        if (ended < 0 && errno != EINTR)
            return true;
        if (limit > 0 && now() - begun > limit) {
            kill(child, SIGKILL);
            while (waitpid(child, status, 0) < 0 && errno == EINTR)
                continue;
            return false;
        }
        if (limit > 0)
            nanosleep(&poll_interval, NULL);
    }
}

enum csg_process_end csg_process_run(const char *const *argv, const char *log, double limit,
                                     double *seconds)
{
    pid_t child;
    int status = -1;
    const double begun = now();
    if (start(argv, log, &child))
        return CSG_PROCESS_MISSING;
    const bool ended = wait_for(child, begun, limit, &status);
    if (seconds)
        *seconds = now() - begun;
    if (!ended)
        return CSG_PROCESS_TIMED_OUT;
    if (WIFEXITED(status) && WEXITSTATUS(status) == STATUS_NOT_STARTED)
        return CSG_PROCESS_MISSING;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? CSG_PROCESS_DONE : CSG_PROCESS_FAILED;
}

static bool is_in(const char *folder, size_t length, const char *program)
{
    char path[PATH_MAX];
    const int num = snprintf(path, sizeof path, "%.*s/%s", (int)length, folder, program);
    return num > 0 && (size_t)num < sizeof path && access(path, X_OK) == 0;
}

bool csg_process_exists(const char *program)
{
    const char *path = getenv("PATH");
    if (strchr(program, '/'))
        return access(program, X_OK) == 0;
    while (path && *path) {
        const size_t length = strcspn(path, ":");
        if (is_in(path, length, program))
            return true;
        path += length + (path[length] == ':');
    }
    return false;
}

bool csg_process_make_folder(char *text, int size)
{
    const char *parent = getenv("TMPDIR");
    const int num = snprintf(text, (size_t)size, "%s/csgcast-XXXXXX",
                             parent && parent[0] == '/' ? parent : "/tmp");
    if (num > 0 && num < size && mkdtemp(text))
        return true;
    csg_cli_error("cannot make the folder %s: %s", text, strerror(errno));
    text[0] = 0;
    return false;
}

void csg_process_remove_folder(const char *folder)
{
    DIR *dir = folder[0] ? opendir(folder) : NULL;
    char path[PATH_MAX];
    for (struct dirent *entry = dir ? readdir(dir) : NULL; entry; entry = readdir(dir)) {
        const int num = snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (num > 0 && (size_t)num < sizeof path)
            unlink(path); /* fails for . and .. */
    }
    if (dir) {
        closedir(dir);
        rmdir(folder);
    }
}
