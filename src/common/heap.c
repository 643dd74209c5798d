/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* madvise, sbrk */
#endif

#include "common/heap.h"

#include <stdint.h>
#include <stdlib.h>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

/* Addresses, of which only what is touched becomes memory; beyond that it grows by less at a time,
 * as that must not fail where addresses are limited. */
enum { heap_size = 64 << 20, heap_growth = 1 << 20 };

/* Where the heap is full, larger blocks are mapped: growing, they move without being copied. */
enum { largest_grown_for = 4 << 20 };

/* More than llvmpipe and an edit free in most frames, twice this. */
enum { largest_freed = 16 << 20 };

static void use_huge_pages(const char *begin, const char *end)
{
    const uintptr_t page = (uintptr_t)sysconf(_SC_PAGESIZE);
    const size_t skipped = (page - (uintptr_t)begin % page) % page;
    if (end > begin + skipped)
        madvise((char *)(uintptr_t)begin + skipped, (size_t)(end - begin) - skipped, MADV_HUGEPAGE);
}
#endif

/*
 * A third of the processor time of a first picture is the kernel's, for pages that are touched the
 * first time, 62 MB of them in a small scene, most of them the driver's. A huge page is made in the
 * time of some tens.
 */
void csg_heap_begin(void)
{
#ifdef __GLIBC__
    const char *const begin = sbrk(0);
    mallopt(M_MMAP_THRESHOLD, largest_grown_for);
    mallopt(M_TRIM_THRESHOLD, -1);
    mallopt(M_TOP_PAD, heap_size);
    void *volatile block = malloc(largest_grown_for / 2); /* more than there is: the heap grows */
    mallopt(M_TOP_PAD, heap_growth);
    free(block);
    use_huge_pages(begin, sbrk(0));
#endif
}

/*
 * llvmpipe frees a frame's triangles when it is drawn, and edits what they have worked with. glibc
 * gives back what is free at the heap's end where it is more than 128 kB, or twice the largest
 * mapped block that was ever freed: each frame then touched the same pages for the first time, some
 * thousand of them, which took up to a third of its processor time.
 */
void csg_heap_keep(void)
{
#ifdef __GLIBC__
    void *volatile block = malloc(largest_freed);
    free(block);
#endif
}
