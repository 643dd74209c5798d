/* SPDX-License-Identifier: MIT */
#include "ending.h"

#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include "common/folder.h"

static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};

enum { NUM_NUMBERS = sizeof numbers / sizeof *numbers };

/* Signals that our parent has not set to be ignored, as nohup does. */
static void find_signals(sigset_t *signals)
{
    struct sigaction action;
    sigemptyset(signals);
    for (int i = 0; i < NUM_NUMBERS; i++)
        if (sigaction(numbers[i], NULL, &action) == 0 && action.sa_handler != SIG_IGN)
            sigaddset(signals, numbers[i]);
}

/* A thread waits for them, as a handler may not do what is to be done. */
static void *wait_for_signals(void *unused)
{
    sigset_t signals;
    int number;
    find_signals(&signals);
    if (sigwait(&signals, &number) != 0)
        return unused;
    if (isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr);
    csg_folder_remove_all();
    signal(number, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &signals, NULL);
    raise(number); /* the parent learns from it how we ended */
    return unused;
}

void csg_ending_begin(void)
{
    pthread_t thread;
    sigset_t signals;
    find_signals(&signals);
    pthread_sigmask(SIG_BLOCK, &signals, NULL);
    if (pthread_create(&thread, NULL, wait_for_signals, NULL) == 0)
        pthread_detach(thread);
    else
        pthread_sigmask(SIG_UNBLOCK, &signals, NULL);
}

void csg_ending_now(int code)
{
    fflush(NULL);
    _exit(code);
}
