/* SPDX-License-Identifier: MIT */
#include "common/parallel.h"

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <unistd.h>

enum { MAX_THREADS = 64 };

struct job {
    csg_task_fn *task;
    void *user;
    size_t num;
    atomic_size_t next;
};

static void *work(void *argument)
{
    struct job *job = argument;
    for (size_t i; (i = atomic_fetch_add(&job->next, 1)) < job->num;)
        job->task(job->user, i);
    return NULL;
}

/* The threads leave the process's signals to its own ones. */
static size_t start(struct job *job, pthread_t *threads, size_t num)
{
    sigset_t all, previous;
    size_t started = 0;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &previous);
    while (started < num && pthread_create(&threads[started], NULL, work, job) == 0)
        started++;
    pthread_sigmask(SIG_SETMASK, &previous, NULL);
    return started;
}

/* Besides the caller, for num tasks. */
static size_t num_helpers(int num_threads, size_t num)
{
    const long cores = num_threads > 0 ? num_threads : sysconf(_SC_NPROCESSORS_ONLN);
    size_t helpers = cores > 1 ? (size_t)cores - 1 : 0;
    helpers = helpers > MAX_THREADS ? MAX_THREADS : helpers;
    return helpers < num - 1 ? helpers : num - 1;
}

void csg_parallel(int num_threads, size_t num, csg_task_fn *task, void *user)
{
    struct job job = {.task = task, .user = user, .num = num};
    pthread_t threads[MAX_THREADS];
    size_t started = 0;
    if (num > 1) /* a single task is not worth the system's calls: some have one for each object */
        started = start(&job, threads, num_helpers(num_threads, num));
    work(&job);
    for (size_t i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
}

bool csg_call_on_new_stack(csg_task_fn *task, void *user)
{
    struct job job = {.task = task, .user = user, .num = 1};
    pthread_t thread;
    return start(&job, &thread, 1) == 1 && pthread_join(thread, NULL) == 0;
}
