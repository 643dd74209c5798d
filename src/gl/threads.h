/* SPDX-License-Identifier: MIT */
#ifndef CSG_GL_THREADS_H
#define CSG_GL_THREADS_H

/*
 * llvmpipe's threads wake all at once, when a frame is drawn, while the thread that wakes them
 * still has a core. Where there are as many of them as cores, Linux puts two on one core then, and
 * frames of some milliseconds are over before it moves one. So each gets a core of its own. They
 * take blocks of the picture one by one: one whose core has other work to do takes fewer.
 */

#include <stddef.h>
#include <sys/types.h>

enum { CSG_GL_MAX_THREADS = 64 };

/* Those of the process; more than there is room for are not looked at. */
struct csg_gl_threads {
    pid_t ids[CSG_GL_MAX_THREADS];
    size_t num;
};

void csg_gl_threads_list(struct csg_gl_threads *threads);

/* Gives a core to each that is not among others, which the program started for itself, where there
 * is one for each core that the process may use. They have to be running. */
void csg_gl_threads_spread(const struct csg_gl_threads *others);

#endif
