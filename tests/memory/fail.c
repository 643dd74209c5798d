/* SPDX-License-Identifier: MIT */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* RTLD_NEXT, dl_iterate_phdr */
#endif

/*
 * Loaded by LD_PRELOAD: of the allocations that csgcast's own code asks for, the one with the
 * number FAIL_AT fails, counted from 1. At the end the file FAIL_COUNT gets how many there were.
 * Those of the driver and of other libraries do not count.
 */

#include <dlfcn.h>
#include <link.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { max_ranges = 16 };

/* The code of the tool, the library and its modules. */
static struct {
    uintptr_t begin, end;
} ranges[max_ranges];
static size_t num_ranges;

static long fail_at;
static atomic_long count;

static void *(*next_malloc)(size_t size);
static void *(*next_calloc)(size_t num, size_t size);
static void *(*next_realloc)(void *block, size_t size);

static int add_ranges(struct dl_phdr_info *info, size_t size, void *user)
{
    const char *slash = strrchr(info->dlpi_name, '/');
    const bool is_program = info->dlpi_name[0] == '\0';
    (void)size, (void)user;
    if (!is_program && !(slash && strncmp(slash, "/libcsgcast", 11) == 0))
        return 0;
    for (int i = 0; i < info->dlpi_phnum && num_ranges < max_ranges; i++) {
        const uintptr_t begin = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
        if (info->dlpi_phdr[i].p_type == PT_LOAD && (info->dlpi_phdr[i].p_flags & PF_X)) {
            ranges[num_ranges].begin = begin;
            ranges[num_ranges++].end = begin + info->dlpi_phdr[i].p_memsz;
        }
    }
    return 0;
}

/* memcpy: ISO C converts no pointer to data into one to a function. */
static void find(const char *name, void *function, size_t size)
{
    void *found = dlsym(RTLD_NEXT, name);
    memcpy(function, &found, size);
}

__attribute__((constructor)) static void begin(void)
{
    const char *number = getenv("FAIL_AT");
    fail_at = number ? strtol(number, NULL, 10) : 0;
    find("malloc", &next_malloc, sizeof next_malloc);
    find("realloc", &next_realloc, sizeof next_realloc);
    find("calloc", &next_calloc, sizeof next_calloc);
    dl_iterate_phdr(add_ranges, NULL);
}

__attribute__((destructor)) static void finish(void)
{
    const char *path = getenv("FAIL_COUNT");
    FILE *file = path ? fopen(path, "w") : NULL;
    if (!file)
        return;
    fprintf(file, "%ld\n", atomic_load(&count));
    fclose(file);
}

/* `render` ends so, without destructors. */
_Noreturn void _exit(int status)
{
    void (*next_exit)(int status);
    finish();
    find("_exit", &next_exit, sizeof next_exit);
    next_exit(status);
    abort();
}

static bool fails(const void *caller)
{
    for (size_t i = 0; i < num_ranges; i++)
        if ((uintptr_t)caller >= ranges[i].begin && (uintptr_t)caller < ranges[i].end)
            return atomic_fetch_add(&count, 1) + 1 == fail_at;
    return false;
}

void *malloc(size_t size)
{
    if (!next_malloc)
        find("malloc", &next_malloc, sizeof next_malloc);
    return fails(__builtin_return_address(0)) ? NULL : next_malloc(size);
}

void *realloc(void *block, size_t size)
{
    if (!next_realloc)
        find("realloc", &next_realloc, sizeof next_realloc);
    return fails(__builtin_return_address(0)) ? NULL : next_realloc(block, size);
}

/* dlsym may ask for memory itself, before there is a next one: it does without. */
void *calloc(size_t num, size_t size)
{
    return !next_calloc || fails(__builtin_return_address(0)) ? NULL : next_calloc(num, size);
}
