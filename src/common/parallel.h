/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_PARALLEL_H
#define CSG_COMMON_PARALLEL_H

#include <stdbool.h>
#include <stddef.h>

typedef void csg_task_fn(void *user, size_t task);

/*
 * Runs tasks 0 .. num - 1 on num_threads threads, the caller's one of them, and waits for them; 0:
 * as many as there are cores. The order is not defined: for equal
 * results on every machine a task writes only to places that depend on its number alone. Where no
 * thread can be started the caller's does all of the work.
 */
void csg_parallel(int num_threads, size_t num, csg_task_fn *task, void *user);

/* The tasks that no thread has taken yet. */
struct csg_tasks;
typedef void csg_worker_fn(void *user, struct csg_tasks *tasks);

/* The same for tasks that need memory, which threads would wait for each other to get: each thread
 * calls the worker once, which takes tasks for as long as there are any. */
void csg_parallel_workers(int num_threads, size_t num, csg_worker_fn *worker, void *user);
bool csg_take_task(struct csg_tasks *tasks, size_t *task);

/*
 * Calls task(user, 0) with a stack of its own, and waits for it: for what goes as deep as the input
 * and has gone deep already. false: not called, for want of memory or threads.
 */
bool csg_call_on_new_stack(csg_task_fn *task, void *user);

#endif
