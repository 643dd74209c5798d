/* SPDX-License-Identifier: MIT */
#include "render/start.h"

#include <pthread.h>
#include <signal.h>
#include <stdlib.h>

#include "common/join.h"

struct csg_start {
    pthread_t thread;
    struct csgcast_renderer *renderer;
    enum csgcast_backend backend;
    enum csgcast_message id;
    char *message; /* the first one of making the context; NULL: none */
};

static void keep_message(void *user, enum csgcast_log_level level, enum csgcast_message id,
                         const char *text)
{
    struct csg_start *start = user;
    (void)level;
    if (start->message)
        return;
    start->id = id;
    start->message = csg_join(text, "");
}

static void *run(void *user)
{
    struct csg_start *start = user;
    struct csgcast_renderer *renderer = start->renderer;
    const struct csg_log log = {keep_message, start};
    renderer->gl = csg_gl_create(start->backend, &log);
    renderer->programs.gl = renderer->gl;
    if (renderer->gl) {
        renderer->gl->log = csg_log_silent; /* what fails here fails again in a picture */
        csg_warm_up(renderer);
        renderer->gl->log = renderer->log;
    }
    return NULL;
}

struct csg_start *csg_start_begin(struct csgcast_renderer *renderer, enum csgcast_backend backend)
{
    sigset_t all, previous;
    struct csg_start *start = calloc(1, sizeof *start);
    if (!start)
        return NULL;
    start->renderer = renderer;
    start->backend = backend;
    sigfillset(&all); /* the program's signals are no business of this thread */
    pthread_sigmask(SIG_SETMASK, &all, &previous);
    const bool started = pthread_create(&start->thread, NULL, run, start) == 0;
    pthread_sigmask(SIG_SETMASK, &previous, NULL);
    if (started)
        return start;
    free(start);
    return NULL;
}

bool csg_start_join(struct csgcast_renderer *renderer)
{
    struct csg_start *start = renderer->start;
    pthread_join(start->thread, NULL);
    renderer->start = NULL;
    if (!renderer->gl && start->message)
        csg_log_error(&renderer->log, start->id, "%s", start->message);
    else if (!renderer->gl)
        csg_log_memory(&renderer->log);
    free(start->message);
    free(start);
    return renderer->gl != NULL;
}
