/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_KEYS_H
#define CSG_COMMON_KEYS_H

/* Sorts places of an array by numbers that belong to them. */

#include <stdint.h>
#include <string.h>

#include "common/array.h"

struct csg_key {
    uint64_t key;
    uint32_t index;
};

/* Zero-initialise it; free list.data and room.data. */
struct csg_keys {
    CSG_ARRAY(struct csg_key) list, room;
};

/* In the order of doubles that are no NaN; 0 and -0 are equal. */
static inline uint64_t csg_key_of(double number)
{
    const double own = number + 0.0;
    uint64_t bits;
    memcpy(&bits, &own, sizeof bits);
    return bits >> 63 ? ~bits : bits | (uint64_t)1 << 63;
}

/* The list by key; equal ones stay in their order. false: out of memory. */
bool csg_keys_sort(struct csg_keys *keys);

#endif
