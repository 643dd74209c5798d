/* SPDX-License-Identifier: MIT */
#include "common/parallel.h"

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <unistd.h>

enum { MAX_THREADS = 64 };

struct csg_tasks {
    csg_worker_fn *worker;
    void *user;
    size_t num;
    atomic_size_t next;
};

bool csg_take_task(struct csg_tasks *tasks, size_t *task)
{
    *task = atomic_fetch_add(&tasks->next, 1);
    return *task < tasks->num;
}

static void *work(void *argument)
{
    struct csg_tasks *tasks = argument;
    tasks->worker(tasks->user, tasks);
    return NULL;
}

/* The threads leave the process's signals to its own ones. */
static size_t start(struct csg_tasks *tasks, pthread_t *threads, size_t num)
{
    sigset_t all, previous;
    size_t started = 0;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &previous);
    while (started < num && pthread_create(&threads[started], NULL, work, tasks) == 0)
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

void csg_parallel_workers(int num_threads, size_t num, csg_worker_fn *worker, void *user)
{
    struct csg_tasks tasks = {.worker = worker, .user = user, .num = num};
    pthread_t threads[MAX_THREADS];
    size_t started = 0;
    if (num > 1) /* a single task is not worth the system's calls: some have one for each object */
        started = start(&tasks, threads, num_helpers(num_threads, num));
    work(&tasks);
    for (size_t i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
}

/* Tasks that need nothing but their number. */
struct plain {
    csg_task_fn *task;
    void *user;
};

static void run_plain(void *user, struct csg_tasks *tasks)
{
    const struct plain *plain = user;
    for (size_t i; csg_take_task(tasks, &i);)
        plain->task(plain->user, i);
}

void csg_parallel(int num_threads, size_t num, csg_task_fn *task, void *user)
{
    struct plain plain = {task, user};
    csg_parallel_workers(num_threads, num, run_plain, &plain);
}

bool csg_call_on_new_stack(csg_task_fn *task, void *user)
{
    struct plain plain = {task, user};
    struct csg_tasks tasks = {.worker = run_plain, .user = &plain, .num = 1};
    pthread_t thread;
    return start(&tasks, &thread, 1) == 1 && pthread_join(thread, NULL) == 0;
}
