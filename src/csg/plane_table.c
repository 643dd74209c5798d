/* SPDX-License-Identifier: MIT */
#include "csg/plane_table.h"

#include <stdlib.h>
#include <string.h>

void csg_plane_table_finish(struct csg_plane_table *table)
{
    free(table->slots);
    free(table->others.data);
    free(table->free_others.data);
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

static bool is_same(const struct csg_plane *a, const struct csg_plane *b)
{
    return a->normal.x == b->normal.x && a->normal.y == b->normal.y && a->normal.z == b->normal.z &&
           a->offset == b->offset;
}

/* Offsets of few digits differ in a double's highest bits only: they must reach the lowest ones. */
static size_t hash_of(const struct csg_plane *plane)
{
    const double numbers[4] = {plane->normal.x, plane->normal.y, plane->normal.z, plane->offset};
    uint64_t hash = 0;
    for (int i = 0; i < 4; i++) {
        uint64_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        hash ^= bits;
        hash = (hash ^ (hash >> 32)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 29;
    }
    return (size_t)hash;
}

static bool is_other(const struct csg_plane_slot *slot)
{
    return slot->place >= CSG_PLANE_OTHER;
}

/* The turned plane of a slot that is not free; its face is that of the plane so turned. */
static struct csg_plane plane_in(const struct csg_plane_table *table,
                                 const struct csg_plane *planes, const struct csg_plane_slot *slot,
                                 struct csg_face *face)
{
    if (is_other(slot)) {
        const struct csg_other_plane *other = &table->others.data[slot->place - CSG_PLANE_OTHER];
        *face = other->face;
        face->is_other = true;
        return other->plane;
    }
    struct csg_plane plane = planes[slot->place - 1];
    const bool is_turned = turn(&plane);
    *face = (struct csg_face){.carrier = slot->place - 1, .flipped = is_turned};
    return plane;
}

static size_t place_of(const struct csg_plane_table *table, size_t hash)
{
    return (hash >> 32 ^ hash) & (table->room - 1);
}

/* Where the turned plane is, or would be: there is always a free slot. */
static struct csg_plane_slot *slot_of(const struct csg_plane_table *table,
                                      const struct csg_plane *planes, const struct csg_plane *plane,
                                      struct csg_face *face)
{
    const size_t hash = hash_of(plane);
    const uint32_t tag = (uint32_t)hash;
    for (size_t i = place_of(table, hash);; i = (i + 1) & (table->room - 1)) {
        struct csg_plane_slot *slot = &table->slots[i];
        if (slot->place == 0)
            return slot;
        if (slot->tag != tag)
            continue;
        const struct csg_plane there = plane_in(table, planes, slot, face);
        if (is_same(&there, plane))
            return slot;
    }
}

bool csg_plane_table_find(const struct csg_plane_table *table, const struct csg_plane *planes,
                          const struct csg_plane *plane, struct csg_face *face)
{
    struct csg_plane turned = *plane;
    struct csg_face there;
    const bool is_turned = turn(&turned);
    if (!table->room || slot_of(table, planes, &turned, &there)->place == 0)
        return false;
    *face = (struct csg_face){there.carrier, there.flipped != is_turned, there.is_other};
    return true;
}

/* The slots of different planes; which plane is asked again. */
static bool grow(struct csg_plane_table *table, const struct csg_plane *planes)
{
    struct csg_plane_table old = *table;
    table->room = old.room ? 2 * old.room : 64;
    table->slots = calloc(table->room, sizeof *table->slots);
    if (!table->slots) {
        *table = old;
        return false;
    }
    for (size_t i = 0; i < old.room; i++) {
        struct csg_face face;
        if (old.slots[i].place == 0)
            continue;
        const struct csg_plane plane = plane_in(table, planes, &old.slots[i], &face);
        size_t to = place_of(table, hash_of(&plane));
        while (table->slots[to].place)
            to = (to + 1) & (table->room - 1);
        table->slots[to] = old.slots[i];
    }
    free(old.slots);
    return true;
}

/* The plane that one of the slots holds. */
static struct csg_plane plane_at(const struct csg_plane_table *table,
                                 const struct csg_plane *planes, size_t slot)
{
    struct csg_face face;
    return plane_in(table, planes, &table->slots[slot], &face);
}

/* What stands behind a slot that becomes free moves up, where it is looked for from there or
 * before (Knuth, TAOCP 6.4, algorithm R). */
static void close_gap(struct csg_plane_table *table, const struct csg_plane *planes, size_t gap)
{
    const size_t mask = table->room - 1;
    for (size_t i = (gap + 1) & mask; table->slots[i].place != 0; i = (i + 1) & mask) {
        const struct csg_plane plane = plane_at(table, planes, i);
        const size_t wanted = place_of(table, hash_of(&plane));
        if (((i - wanted) & mask) < ((i - gap) & mask))
            continue;
        table->slots[gap] = table->slots[i];
        gap = i;
    }
    table->slots[gap] = (struct csg_plane_slot){0};
}

void csg_plane_table_remove(struct csg_plane_table *table, const struct csg_plane *planes,
                            const struct csg_plane *plane)
{
    struct csg_plane turned = *plane;
    struct csg_face face;
    turn(&turned);
    struct csg_plane_slot *slot = table->room ? slot_of(table, planes, &turned, &face) : NULL;
    if (!slot || slot->place == 0)
        return;
    /* Without memory for that the place is lost until the table ends. */
    if (is_other(slot))
        (void)!csg_array_push(&table->free_others, slot->place - CSG_PLANE_OTHER);
    table->num--;
    close_gap(table, planes, (size_t)(slot - table->slots));
}

static bool add_other(struct csg_plane_table *table, const struct csg_other_plane *other,
                      uint32_t *place)
{
    if (table->free_others.num == 0) {
        *place = CSG_PLANE_OTHER + (uint32_t)table->others.num;
        return csg_array_push(&table->others, *other);
    }
    const uint32_t free_place = table->free_others.data[--table->free_others.num];
    table->others.data[free_place] = *other;
    *place = CSG_PLANE_OTHER + free_place;
    return true;
}

bool csg_plane_table_add(struct csg_plane_table *table, const struct csg_plane *planes,
                         const struct csg_plane *plane, const struct csg_face *face)
{
    struct csg_plane turned = *plane, own = planes[face->carrier];
    struct csg_face there;
    const bool is_turned = turn(&turned);
    if (2 * table->num >= table->room && !grow(table, planes))
        return false;
    struct csg_plane_slot *slot = slot_of(table, planes, &turned, &there);
    turn(&own);
    slot->tag = (uint32_t)hash_of(&turned);
    slot->place = face->carrier + 1;
    table->num++;
    if (is_same(&own, &turned) && slot->place < CSG_PLANE_OTHER)
        return true;
    const struct csg_other_plane other = {
        turned, {.carrier = face->carrier, .flipped = face->flipped != is_turned}};
    return add_other(table, &other, &slot->place);
}
