/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_START_H
#define CSG_RENDER_START_H

#include "render/renderer.h"

/*
 * A renderer's beginning on a thread of its own: loading the driver, making the context and what
 * every picture needs take longer than most scenes take to load. The thread has the renderer's
 * OpenGL members to itself until it is joined, and gives no messages: the first one waits for the
 * join.
 */
struct csg_start;

/* NULL: there is no thread to be had; do it at once. */
struct csg_start *csg_start_begin(struct csgcast_renderer *renderer, enum csgcast_backend backend);

/* Waits, frees, and sets renderer->start to NULL. false, with the message, where there is no
 * context. */
bool csg_start_join(struct csgcast_renderer *renderer);

#endif
