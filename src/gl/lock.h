/* SPDX-License-Identifier: MIT */
#ifndef CSG_GL_LOCK_H
#define CSG_GL_LOCK_H

/*
 * The contexts that Mesa's llvmpipe makes in a process share one rasteriser. Two threads that draw
 * in contexts of their own at the same time crash in it (Mesa 22.3.6: a process in a hundred of
 * examples/threads.c), so a thread that draws in software, or makes any context, holds this lock.
 * Drawing in software takes all cores anyway.
 */

/* Waits for the thread that holds it; nests. */
void csg_gl_lock(void);
void csg_gl_unlock(void);

#endif
