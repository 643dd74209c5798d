/* SPDX-License-Identifier: MIT */
#ifndef CSG_DOCUMENT_ARENA_H
#define CSG_DOCUMENT_ARENA_H

#include <stddef.h>

/*
 * Memory that is given back all at once: the values of one argument list after the other.
 * Zero-initialise it.
 */
struct csg_arena {
    struct csg_arena_block *blocks; /* the one that is being filled first */
};

void csg_arena_finish(struct csg_arena *arena);

/* size bytes, aligned for any type; NULL when memory is out. */
void *csg_arena_alloc(struct csg_arena *arena, size_t size);

/* Gives everything back but keeps one block for the next use. */
void csg_arena_reset(struct csg_arena *arena);

#endif
