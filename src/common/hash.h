/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_HASH_H
#define CSG_COMMON_HASH_H

/* Hashes by Fowler, Noll and Vo, going on from an earlier one or from CSG_HASH_START. */

#include <stddef.h>
#include <stdint.h>

#define CSG_HASH_START 0xcbf29ce484222325u
#define CSG_HASH_PRIME 0x100000001b3u

/* FNV-1a, 64 bits: also for what is kept on disk. */
static inline uint64_t csg_hash(uint64_t hash, const void *data, size_t size)
{
    const unsigned char *bytes = data;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ bytes[i]) * CSG_HASH_PRIME;
    return hash;
}

/* Eight bytes in one step; the shift spreads the high bits. */
static inline uint64_t csg_hash_number(uint64_t hash, uint64_t number)
{
    hash = (hash ^ number) * CSG_HASH_PRIME;
    return hash ^ hash >> 29;
}

#endif
