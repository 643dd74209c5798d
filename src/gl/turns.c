/* SPDX-License-Identifier: MIT */
#include "gl/turns.h"

#include <pthread.h>

static pthread_once_t once = PTHREAD_ONCE_INIT;
static pthread_mutex_t turn;

/* Recursive: a thread may enter a context inside of another one. */
static void init(void)
{
    pthread_mutexattr_t attributes;
    pthread_mutexattr_init(&attributes);
    pthread_mutexattr_settype(&attributes, PTHREAD_MUTEX_RECURSIVE);
    pthread_mutex_init(&turn, &attributes);
    pthread_mutexattr_destroy(&attributes);
}

void csg_gl_turn_begin(void)
{
    pthread_once(&once, init);
    pthread_mutex_lock(&turn);
}

void csg_gl_turn_end(void)
{
    pthread_mutex_unlock(&turn);
}
