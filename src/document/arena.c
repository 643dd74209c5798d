/* SPDX-License-Identifier: MIT */
#include "document/arena.h"

#include <stdint.h>
#include <stdlib.h>

struct csg_arena_block {
    struct csg_arena_block *next;
    size_t used, size;
    max_align_t bytes[];
};

/* Holds a node of usual size, with its matrix, in one block. */
static const size_t block_size = 16384;

/* A block above this size is not kept for the next argument list. */
static const size_t kept_size = 1 << 20;

static void free_blocks(struct csg_arena_block *block)
{
    while (block) {
        struct csg_arena_block *next = block->next;
        free(block);
        block = next;
    }
}

void csg_arena_finish(struct csg_arena *arena)
{
    free_blocks(arena->blocks);
    arena->blocks = NULL;
}

static struct csg_arena_block *add_block(struct csg_arena *arena, size_t size)
{
    const size_t wanted = size > block_size ? size : block_size;
    struct csg_arena_block *block = malloc(sizeof *block + wanted);
    if (!block)
        return NULL;
    *block = (struct csg_arena_block){.next = arena->blocks, .size = wanted};
    arena->blocks = block;
    return block;
}

void *csg_arena_alloc(struct csg_arena *arena, size_t size)
{
    const size_t unit = sizeof(max_align_t);
    if (size > SIZE_MAX / 2)
        return NULL;
    size = (size + unit - 1) / unit * unit;
    struct csg_arena_block *block = arena->blocks;
    if (!block || block->size - block->used < size)
        block = add_block(arena, size);
    if (!block)
        return NULL;
    void *memory = (char *)block->bytes + block->used;
    block->used += size;
    return memory;
}

void csg_arena_reset(struct csg_arena *arena)
{
    struct csg_arena_block *block = arena->blocks;
    if (block && block->size > kept_size) {
        csg_arena_finish(arena);
    } else if (block) {
        free_blocks(block->next);
        block->next = NULL;
        block->used = 0;
    }
}
