/* SPDX-License-Identifier: MIT */
#ifndef CSG_GL_TURNS_H
#define CSG_GL_TURNS_H

/*
 * The contexts that Mesa's llvmpipe makes in a process share one rasteriser. Two threads that draw
 * in contexts of their own at the same time crash in it (Mesa 22.3.6: a process in a hundred of
 * examples/threads.c), so software contexts take turns, and so does making any context. Drawing in
 * software takes all cores anyway.
 */

/* Waits for the thread whose turn it is; nests. */
void csg_gl_turn_begin(void);
void csg_gl_turn_end(void);

#endif
