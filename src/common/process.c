/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* posix_spawn_file_actions_addchdir_np */
#endif

#include "common/process.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/array.h"
#include "common/clock.h"

extern char **environ;

enum { status_not_started = 127 };

static const size_t chunk_size = 1 << 14;

static int add_actions(posix_spawn_file_actions_t *actions, int output, const char *input,
                       const char *directory)
{
    int error = posix_spawn_file_actions_addopen(actions, STDIN_FILENO, input ? input : "/dev/null",
                                                 O_RDONLY, 0);
    if (!error)
        error = posix_spawn_file_actions_adddup2(actions, output, STDOUT_FILENO);
    if (!error)
        error = posix_spawn_file_actions_adddup2(actions, output, STDERR_FILENO);
    if (!error && directory)
        error = posix_spawn_file_actions_addchdir_np(actions, directory);
    return error;
}

static int spawn(struct csg_process *process, char *const *argv, int output, const char *input,
                 const char *directory, char *const *environment)
{
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);
    if (error)
        return error;
    error = add_actions(&actions, output, input, directory);
    if (!error)
        error = posix_spawnp(&process->pid, argv[0], &actions, NULL, argv,
                             environment ? environment : environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

int csg_process_start(struct csg_process *process, char *const *argv, const char *input,
                      const char *directory, char *const *environment)
{
    int ends[2];
    *process = (struct csg_process){.pipe = -1};
    if (pipe(ends) != 0)
        return errno;
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    const int error = spawn(process, argv, ends[1], input, directory, environment);
    close(ends[1]);
    if (error) {
        close(ends[0]);
        return error;
    }
    process->pipe = ends[0];
    process->is_running = true;
    return 0;
}

/* A child that still writes gets a broken pipe, not a hang. */
static void reap(struct csg_process *process)
{
    close(process->pipe);
    process->pipe = -1;
    process->is_running = false;
    while (waitpid(process->pid, &process->status, 0) < 0) {
        if (errno != EINTR) {
            process->error = errno;
            return;
        }
    }
}

static void read_some(struct csg_process *process)
{
    struct csg_bytes *output = &process->output;
    if (!csg_array_reserve(output, chunk_size)) {
        process->error = ENOMEM;
        reap(process);
        return;
    }
    const ssize_t got = read(process->pipe, output->data + output->num, chunk_size);
    if (got > 0) {
        output->num += (size_t)got;
    } else if (got == 0 || (errno != EINTR && errno != EAGAIN)) {
        process->error = got < 0 ? errno : 0;
        reap(process);
    }
}

/* false: neither a process has ended nor the time. */
static bool wait_once(struct csg_process *processes, size_t num, int ms, struct pollfd *fds)
{
    bool has_ended = false;
    for (size_t i = 0; i < num; i++)
        fds[i] = (struct pollfd){.fd = processes[i].is_running ? processes[i].pipe : -1,
                                 .events = POLLIN};
    const int ready = poll(fds, (nfds_t)num, ms);
    for (size_t i = 0; i < num && ready > 0; i++) {
        if (fds[i].fd < 0 || fds[i].revents == 0)
            continue;
        read_some(&processes[i]);
        has_ended |= !processes[i].is_running;
    }
    return has_ended || ready == 0;
}

static bool any_runs(const struct csg_process *processes, size_t num)
{
    bool any = false;
    for (size_t i = 0; i < num; i++)
        any |= processes[i].is_running;
    return any;
}

void csg_process_wait(struct csg_process *processes, size_t num, int ms)
{
    struct pollfd *fds = malloc((num + 1) * sizeof *fds);
    if (!fds) { /* then one after the other */
        for (size_t i = 0; i < num; i++)
            while (processes[i].is_running)
                read_some(&processes[i]);
        return;
    }
    const double end = csg_clock_ms() + ms;
    for (int left = ms; any_runs(processes, num) && !wait_once(processes, num, left, fds) && left;)
        left = ms < 0 ? ms : (int)fmax(end - csg_clock_ms(), 0);
    free(fds);
}

void csg_process_finish(struct csg_process *process)
{
    if (process->is_running) {
        kill(process->pid, SIGKILL);
        reap(process);
    }
    free(process->output.data);
    process->output = (struct csg_bytes){0};
}

bool csg_process_is_missing(const struct csg_process *process)
{
    return WIFEXITED(process->status) && WEXITSTATUS(process->status) == status_not_started;
}
