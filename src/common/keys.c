/* SPDX-License-Identifier: MIT */
#include "common/keys.h"

#include <stdlib.h>

/* From so many keys on they are sorted by their bytes. */
#define MANY_KEYS 256

static int compare(const void *a, const void *b)
{
    const struct csg_key *x = a, *y = b;
    if (x->key != y->key)
        return x->key < y->key ? -1 : 1;
    return x->index < y->index ? -1 : x->index > y->index;
}

/* One pass of a radix sort: by one byte, keys with the same one stay as they are. false: all have
 * the same one, and nothing was done. */
static bool sort_by_byte(const struct csg_key *from, struct csg_key *to, size_t num, int shift)
{
    size_t begin[256] = {0}, sum = 0;
    for (size_t i = 0; i < num; i++)
        begin[from[i].key >> shift & 255]++;
    if (begin[from[0].key >> shift & 255] == num)
        return false;
    for (size_t i = 0; i < 256; i++) {
        const size_t own = begin[i];
        begin[i] = sum;
        sum += own;
    }
    for (size_t i = 0; i < num; i++)
        to[begin[from[i].key >> shift & 255]++] = from[i];
    return true;
}

static void swap(struct csg_keys *keys)
{
    const struct csg_keys old = *keys;
    memcpy(&keys->list, &old.room, sizeof keys->list);
    memcpy(&keys->room, &old.list, sizeof keys->room);
}

bool csg_keys_sort(struct csg_keys *keys)
{
    const size_t num = keys->list.num;
    if (num < MANY_KEYS) {
        if (num > 1)
            qsort(keys->list.data, num, sizeof *keys->list.data, compare);
        return true;
    }
    keys->room.num = 0;
    if (!csg_array_reserve(&keys->room, num))
        return false;
    keys->room.num = num;
    for (int shift = 0; shift < 64; shift += 8)
        if (sort_by_byte(keys->list.data, keys->room.data, num, shift))
            swap(keys);
    return true;
}
