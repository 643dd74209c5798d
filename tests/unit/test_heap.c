/* SPDX-License-Identifier: MIT */

/* Blocks come from the heap's huge pages, those that it is too small for do not. */

#include "common/heap.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "check.h"

static const char *const huge_pages = "/sys/kernel/mm/transparent_hugepage/enabled";

/* A sanitizer has a heap of its own. */
static bool is_of_glibc(void)
{
#if defined(__SANITIZE_ADDRESS__) || !defined(__GLIBC__)
    return false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
    return false;
#endif
#endif
    return true;
}

/* Whether the mapping that the address is in is advised to be of huge pages. */
static bool is_advised(const void *address)
{
    char line[4096];
    bool is_inside = false, advised = false;
    FILE *maps = fopen("/proc/self/smaps", "r");
    while (maps && fgets(line, sizeof line, maps)) {
        unsigned long begin, end;
        if (sscanf(line, "%lx-%lx ", &begin, &end) == 2)
            is_inside = begin <= (uintptr_t)address && (uintptr_t)address < end;
        else if (is_inside && strncmp(line, "VmFlags:", 8) == 0)
            advised |= strstr(line, " hg") != NULL;
    }
    if (maps)
        fclose(maps);
    return advised;
}

int main(void)
{
    csg_heap_begin();
    if (!is_of_glibc() || access(huge_pages, R_OK) != 0) {
        printf("no huge pages here\n");
        return 0;
    }
    char *small = malloc(100), *middling = malloc(3 << 20), *large = malloc(400 << 20);
    CHECK(small && is_advised(small), "a small block");
    CHECK(middling && is_advised(middling), "a block of 3 MB");
    CHECK(large && !is_advised(large), "a block of 400 MB");
    free(large);
    free(middling);
    free(small);
    return num_failed != 0;
}
