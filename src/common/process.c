/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* execvpe, vfork */
#endif

#include "common/process.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/array.h"
#include "common/clock.h"

extern char **environ;

enum { status_not_started = 127 };

static const size_t chunk_size = 1 << 14;

/* What a child is to become; error is of the call by which it did not, else 0. */
struct program {
    char *const *argv, *const *environment;
    const char *input, *directory;
    struct rlimit memory, seconds;
    int output;
    pid_t parent;
    volatile int error;
};

/* The parent's handlers are none of the child's, and its threads may have blocked everything. */
static void reset_signals(void)
{
    struct sigaction action;
    sigset_t none;
    for (int number = 1; number < NSIG; number++) {
        if (sigaction(number, NULL, &action) || action.sa_handler == SIG_IGN ||
            action.sa_handler == SIG_DFL)
            continue;
        action.sa_flags = 0;
        action.sa_handler = SIG_DFL;
        sigaction(number, &action, NULL);
    }
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
}

static bool redirect(const struct program *program)
{
    const int input = open(program->input ? program->input : "/dev/null", O_RDONLY);
    const bool ok = input >= 0 && dup2(input, STDIN_FILENO) >= 0 &&
                    dup2(program->output, STDOUT_FILENO) >= 0 &&
                    dup2(program->output, STDERR_FILENO) >= 0 &&
                    (!program->directory || chdir(program->directory) == 0);
    if (input > STDERR_FILENO)
        close(input);
    return ok;
}

/* Memory that is only reserved, as threads and compilers have it, does not count. */
static void bound(const struct program *program)
{
    setrlimit(RLIMIT_DATA, &program->memory);
    setrlimit(RLIMIT_CPU, &program->seconds);
}

/* The parent's memory until exec: nothing is allocated or kept. It ends with the thread that waits
 * for it, however that ends. */
static void become(struct program *program)
{
    reset_signals();
    bound(program);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() == program->parent && redirect(program))
        execvpe(program->argv[0], program->argv, program->environment);
    program->error = errno;
    _exit(status_not_started);
}

/* As posix_spawnp, which cannot say that a child is to end with its parent. */
static int spawn(struct csg_process *process, struct program *program)
{
    sigset_t all, previous;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &previous);
    const pid_t child = vfork();
    if (child == 0)
        become(program);
    const int error = child < 0 ? errno : program->error;
    pthread_sigmask(SIG_SETMASK, &previous, NULL);
    if (child > 0 && error)
        waitpid(child, NULL, 0);
    process->pid = child;
    return error;
}

uint64_t csg_process_memory(const struct csg_process_bounds *bounds)
{
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
    if (bounds->memory > 0)
        return bounds->memory;
    return pages > 0 && size > 0 ? (uint64_t)pages / 2 * (uint64_t)size : UINT64_MAX;
}

static struct rlimit lowered(struct rlimit limit, uint64_t most)
{
    if (most < limit.rlim_cur)
        limit.rlim_cur = most;
    return limit;
}

int csg_process_start(struct csg_process *process, char *const *argv, const char *input,
                      const char *directory, char *const *environment,
                      const struct csg_process_bounds *bounds)
{
    const uint64_t memory = bounds ? csg_process_memory(bounds) : UINT64_MAX;
    const uint64_t seconds = bounds && bounds->seconds > 0 ? bounds->seconds : UINT64_MAX;
    struct rlimit own_memory = {RLIM_INFINITY, RLIM_INFINITY}, own_seconds = own_memory;
    int ends[2];
    getrlimit(RLIMIT_DATA, &own_memory);
    getrlimit(RLIMIT_CPU, &own_seconds);
    *process = (struct csg_process){.pipe = -1};
    if (pipe(ends) != 0)
        return errno;
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    struct program program = {.argv = argv,
                              .environment = environment ? environment : environ,
                              .input = input,
                              .directory = directory,
                              .memory = lowered(own_memory, memory),
                              .seconds = lowered(own_seconds, seconds),
                              .output = ends[1],
                              .parent = getpid()};
    const int error = spawn(process, &program);
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
