/* SPDX-License-Identifier: MIT */
#include "carrier/plane_table.h"

#include <stdlib.h>

#include "common/hash.h"

void csg_plane_table_finish(struct csg_plane_table *table)
{
    free(table->slots);
    free(table->planes.data);
    free(table->free.data);
    *table = (struct csg_plane_table){0};
}

/* Turns the plane so that one plane has one form; -0 becomes 0. Whether it was turned. */
static bool turn(struct csg_plane *plane)
{
    const double n[3] = {plane->normal.x, plane->normal.y, plane->normal.z};
    const bool is_turned = n[0] != 0 ? n[0] < 0 : n[1] != 0 ? n[1] < 0 : n[2] < 0;
    const double sign = is_turned ? -1 : 1;
    plane->normal = csg_vec3(sign * n[0] + 0.0, sign * n[1] + 0.0, sign * n[2] + 0.0);
    plane->offset = sign * plane->offset + 0.0;
    return is_turned;
}

static size_t hash_of(const struct csg_plane *plane)
{
    const double numbers[4] = {plane->normal.x, plane->normal.y, plane->normal.z, plane->offset};
    uint64_t hash = 0;
    for (int i = 0; i < 4; i++)
        hash = csg_hash_double(hash, numbers[i]);
    return (size_t)hash;
}

static size_t place_of(const struct csg_plane_table *table, size_t hash)
{
    return (hash >> 32 ^ hash) & (table->room - 1);
}

static const struct csg_plane *plane_in(const struct csg_plane_table *table,
                                        const struct csg_plane_slot *slot)
{
    return &table->planes.data[slot->place - 1].plane;
}

/* Where the turned plane is, or would be: there is always a free slot. */
static struct csg_plane_slot *slot_of(const struct csg_plane_table *table,
                                      const struct csg_plane *plane)
{
    const size_t hash = hash_of(plane);
    const uint32_t tag = (uint32_t)hash;
    for (size_t i = place_of(table, hash);; i = (i + 1) & (table->room - 1)) {
        struct csg_plane_slot *slot = &table->slots[i];
        if (slot->place == 0 ||
            (slot->tag == tag && csg_plane_is_same(plane_in(table, slot), plane)))
            return slot;
    }
}

bool csg_plane_table_find(const struct csg_plane_table *table, const struct csg_plane *plane,
                          struct csg_face *face)
{
    struct csg_plane turned = *plane;
    const bool is_turned = turn(&turned);
    const struct csg_plane_slot *slot = table->room ? slot_of(table, &turned) : NULL;
    if (!slot || slot->place == 0)
        return false;
    *face = table->planes.data[slot->place - 1].face;
    face->flipped = face->flipped != is_turned;
    return true;
}

/* The slots of different planes; which plane is asked again. */
static bool grow(struct csg_plane_table *table)
{
    struct csg_plane_table old = *table;
    table->room = old.room ? 2 * old.room : 64;
    table->slots = calloc(table->room, sizeof *table->slots);
    if (!table->slots) {
        *table = old;
        return false;
    }
    for (size_t i = 0; i < old.room; i++)
        if (old.slots[i].place != 0)
            *slot_of(table, plane_in(table, &old.slots[i])) = old.slots[i];
    free(old.slots);
    return true;
}

/* What stands behind a slot that becomes free moves up, where it is looked for from there or
 * before (Knuth, TAOCP 6.4, algorithm R). */
static void close_gap(struct csg_plane_table *table, size_t gap)
{
    const size_t mask = table->room - 1;
    for (size_t i = (gap + 1) & mask; table->slots[i].place != 0; i = (i + 1) & mask) {
        const size_t wanted = place_of(table, hash_of(plane_in(table, &table->slots[i])));
        if (((i - wanted) & mask) < ((i - gap) & mask))
            continue;
        table->slots[gap] = table->slots[i];
        gap = i;
    }
    table->slots[gap] = (struct csg_plane_slot){0};
}

void csg_plane_table_remove(struct csg_plane_table *table, const struct csg_plane *plane)
{
    struct csg_plane turned = *plane;
    turn(&turned);
    struct csg_plane_slot *slot = table->room ? slot_of(table, &turned) : NULL;
    if (!slot || slot->place == 0)
        return;
    /* Without memory for that the place is lost until the table ends. */
    (void)!csg_array_push(&table->free, slot->place);
    table->num--;
    close_gap(table, (size_t)(slot - table->slots));
}

static bool put(struct csg_plane_table *table, const struct csg_other_plane *other, uint32_t *place)
{
    if (table->free.num == 0) {
        *place = (uint32_t)table->planes.num + 1;
        return csg_array_push(&table->planes, *other);
    }
    *place = table->free.data[--table->free.num];
    table->planes.data[*place - 1] = *other;
    return true;
}

bool csg_plane_table_add(struct csg_plane_table *table, const struct csg_plane *plane,
                         const struct csg_face *face)
{
    struct csg_other_plane other = {*plane, *face};
    if (2 * table->num >= table->room && !grow(table))
        return false;
    other.face.flipped = turn(&other.plane) != face->flipped;
    uint32_t place;
    if (!put(table, &other, &place))
        return false;
    *slot_of(table, &other.plane) = (struct csg_plane_slot){(uint32_t)hash_of(&other.plane), place};
    table->num++;
    return true;
}
