/* SPDX-License-Identifier: MIT */
#include "csg/plane_table.h"

#include <stdlib.h>
#include <string.h>

void csg_plane_table_finish(struct csg_plane_table *table)
{
    free(table->slots);
    free(table->others.data);
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
        return other->plane;
    }
    struct csg_plane plane = planes[slot->place - 1];
    const bool is_turned = turn(&plane);
    *face = (struct csg_face){slot->place - 1, is_turned};
    return plane;
}

static size_t place_of(const struct csg_plane_table *table, size_t hash)
{
    return (hash >> 32 ^ hash) & (table->room - 1);
}

/* Where the turned plane is, or would be: there is always a free slot. */
static struct csg_plane_slot *slot_of(const struct csg_plane_table *table,
                                      const struct csg_plane *planes,
                                      const struct csg_plane *plane, struct csg_face *face)
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
    *face = (struct csg_face){there.carrier, there.flipped != is_turned};
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
    const struct csg_other_plane other = {turned, {face->carrier, face->flipped != is_turned}};
    slot->place = CSG_PLANE_OTHER + (uint32_t)table->others.num;
    return csg_array_push(&table->others, other);
}
