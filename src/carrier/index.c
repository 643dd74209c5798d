/* SPDX-License-Identifier: MIT */
#include "carrier/index.h"

#include <stdlib.h>

#define NO_ENTRY UINT32_MAX
#define INITIAL_BUCKETS 64

/* Entries of a bucket that are asked whether they are a normal's. */
#define MAX_MET 16

bool csg_index_start(struct csg_carrier_index *index, const struct csg_carrier_space *space)
{
    index->space = *space;
    index->directions = (struct csg_directions){{0}};
    index->entries.num = 0;
    index->members.num = index->quadric_keys.num = 0;
    index->free_entry = NO_ENTRY;
    index->buckets.num = 0;
    if (!csg_array_reserve(&index->buckets, INITIAL_BUCKETS))
        return false;
    for (index->buckets.num = 0; index->buckets.num < INITIAL_BUCKETS; index->buckets.num++)
        index->buckets.data[index->buckets.num] = NO_ENTRY;
    return true;
}

void csg_index_finish(struct csg_carrier_index *index)
{
    free(index->buckets.data);
    free(index->entries.data);
    free(index->members.data);
    free(index->quadric_keys.data);
}

/* ---- entries ------------------------------------------------------------------------------ */

static void link_entry(struct csg_carrier_index *index, uint32_t entry)
{
    uint32_t *bucket =
        &index->buckets.data[csg_index_bucket(index, index->entries.data[entry].key)];
    index->entries.data[entry].next = *bucket;
    *bucket = entry;
}

static bool double_buckets(struct csg_carrier_index *index)
{
    const size_t num = 2 * index->buckets.num;
    if (!csg_array_reserve(&index->buckets, index->buckets.num))
        return false;
    index->buckets.num = num;
    for (size_t i = 0; i < num; i++)
        index->buckets.data[i] = NO_ENTRY;
    for (uint32_t i = 0; i < index->entries.num; i++)
        link_entry(index, i); /* there are no free ones */
    return true;
}

static bool add(struct csg_carrier_index *index, const struct csg_index_entry *entry)
{
    const uint32_t free_entry = index->free_entry;
    if (free_entry != NO_ENTRY) {
        index->free_entry = index->entries.data[free_entry].next;
        index->entries.data[free_entry] = *entry;
        link_entry(index, free_entry);
        return true;
    }
    if (index->entries.num >= index->buckets.num && !double_buckets(index))
        return false;
    if (!csg_array_push(&index->entries, *entry))
        return false;
    link_entry(index, (uint32_t)index->entries.num - 1);
    return true;
}

/* The entry that *link leads to. */
static void remove_entry(struct csg_carrier_index *index, uint32_t *link)
{
    const uint32_t entry = *link;
    *link = index->entries.data[entry].next;
    index->entries.data[entry].next = index->free_entry;
    index->free_entry = entry;
}

/* Of the entries with that key the carrier's. */
static void remove_carrier(struct csg_carrier_index *index, uint64_t key, uint32_t carrier)
{
    uint32_t *link = &index->buckets.data[csg_index_bucket(index, key)];
    for (; *link != NO_ENTRY; link = &index->entries.data[*link].next)
        if (index->entries.data[*link].key == key &&
            index->entries.data[*link].carrier == carrier) {
            remove_entry(index, link);
            return;
        }
}

/* ---- planes ------------------------------------------------------------------------------- */

static bool add_with_normal(struct csg_carrier_index *index, uint64_t key, int64_t normal,
                            uint32_t carrier)
{
    const struct csg_index_entry entry = {
        .key = key, .normal = normal, .carrier = carrier, .next = NO_ENTRY};
    return add(index, &entry);
}

static bool is_same_entry(const struct csg_index_entry *a, uint64_t key, int64_t normal)
{
    return a->key == key && a->normal == normal;
}

/* An entry of a normal in a coarse cell, among the first ones that are met: wide cells may have
 * very many. NO_ENTRY: there is none; then it gets one more. */
static uint32_t find_normal(const struct csg_carrier_index *index, uint64_t key, int64_t normal)
{
    uint32_t entry = index->buckets.data[csg_index_bucket(index, key)];
    for (int i = 0; entry != NO_ENTRY && i < MAX_MET; i++) {
        if (is_same_entry(&index->entries.data[entry], key, normal))
            return entry;
        entry = index->entries.data[entry].next;
    }
    return NO_ENTRY;
}

static uint32_t *member(struct csg_carrier_index *index, int width, uint32_t carrier)
{
    return &index->members.data[csg_index_member(index, width, carrier)];
}

static bool add_normal(struct csg_carrier_index *index, int width, const struct csg_plane *plane,
                       int64_t normal, uint32_t carrier)
{
    const uint64_t key = csg_normal_key(&index->space, width, plane);
    const uint32_t entry = find_normal(index, key, normal);
    *member(index, width, carrier) = NO_ENTRY;
    if (entry == NO_ENTRY)
        return add_with_normal(index, key, normal, carrier);
    *member(index, width, carrier) = index->entries.data[entry].carrier;
    index->entries.data[entry].carrier = carrier;
    return true;
}

static bool add_normals(struct csg_carrier_index *index, const struct csg_plane *plane,
                        int64_t normal, uint32_t carrier)
{
    csg_directions_add(&index->directions, plane->normal);
    while (index->members.num < ((size_t)carrier + 1) * (size_t)index->space.num_widths)
        if (!csg_array_push(&index->members, NO_ENTRY))
            return false;
    for (int i = 0; i < index->space.num_widths; i++)
        if (!add_normal(index, i, plane, normal, carrier))
            return false;
    return true;
}

/* Whether the plane was among the members of an entry, and is no more. */
static bool remove_member(struct csg_carrier_index *index, int width, uint32_t entry,
                          uint32_t carrier)
{
    uint32_t *there = &index->entries.data[entry].carrier;
    while (*there != carrier && *there != NO_ENTRY)
        there = member(index, width, *there);
    if (*there != carrier)
        return false;
    *there = *member(index, width, carrier);
    return true;
}

static void remove_normal(struct csg_carrier_index *index, int width, const struct csg_plane *plane,
                          int64_t normal, uint32_t carrier)
{
    const uint64_t key = csg_normal_key(&index->space, width, plane);
    uint32_t *link = &index->buckets.data[csg_index_bucket(index, key)];
    while (*link != NO_ENTRY && !(is_same_entry(&index->entries.data[*link], key, normal) &&
                                  remove_member(index, width, *link, carrier)))
        link = &index->entries.data[*link].next;
    if (*link != NO_ENTRY && index->entries.data[*link].carrier == NO_ENTRY)
        remove_entry(index, link);
}

bool csg_index_add_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                         uint32_t carrier)
{
    const int64_t normal = csg_direction_number(plane->normal);
    return add_with_normal(index, csg_parallel_key(&index->space, plane, normal), normal,
                           carrier) &&
           add_normals(index, plane, normal, carrier);
}

void csg_index_remove_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                            uint32_t carrier)
{
    const int64_t normal = csg_direction_number(plane->normal);
    remove_carrier(index, csg_parallel_key(&index->space, plane, normal), carrier);
    for (int i = 0; i < index->space.num_widths; i++)
        remove_normal(index, i, plane, normal, carrier);
}

/* ---- quadrics ----------------------------------------------------------------------------- */

bool csg_index_add_quadric(struct csg_carrier_index *index, const struct csg_quadric *quadric,
                           uint32_t carrier)
{
    struct csg_index_entry entry = {.carrier = carrier, .next = NO_ENTRY};
    entry.key = csg_quadric_key(&index->space, quadric, entry.place);
    while (index->quadric_keys.num <= carrier)
        if (!csg_array_push(&index->quadric_keys, 0))
            return false;
    index->quadric_keys.data[carrier] = entry.key;
    return add(index, &entry);
}

void csg_index_remove_quadric(struct csg_carrier_index *index, uint32_t carrier)
{
    remove_carrier(index, index->quadric_keys.data[carrier], carrier);
}
