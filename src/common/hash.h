/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_HASH_H
#define CSG_COMMON_HASH_H

/* Hashes that go on from an earlier one. */

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define CSG_HASH_START 0xcbf29ce484222325u

/* Of bytes, from CSG_HASH_START: FNV-1a (Fowler, Noll, Vo), 64 bits; also for what is kept on
 * disk. */
static inline uint64_t csg_hash(uint64_t hash, const void *data, size_t size)
{
    const unsigned char *bytes = data;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ bytes[i]) * 0x100000001b3u;
    return hash;
}

/* Of eight bytes in one step, from any number. The shifts let all bits reach the lowest ones, which
 * tables look at: doubles of few digits differ in their highest bits only. */
static inline uint64_t csg_hash_number(uint64_t hash, uint64_t number)
{
    hash ^= number;
    hash = (hash ^ hash >> 32) * 0x9e3779b97f4a7c15u;
    return hash ^ hash >> 29;
}

static inline uint64_t csg_hash_double(uint64_t hash, double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return csg_hash_number(hash, bits);
}

#endif
