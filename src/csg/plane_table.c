/* SPDX-License-Identifier: MIT */
#include "csg/plane_table.h"

#include <stdlib.h>
#include <string.h>

void csg_plane_table_finish(struct csg_plane_table *table)
{
    free(table->slots);
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

/* Where the turned plane is, or would be: there is always a free slot. */
static struct csg_plane_slot *slot_of(const struct csg_plane_table *table,
                                      const struct csg_plane *plane)
{
    size_t i = hash_of(plane) & (table->room - 1);
    while (table->slots[i].is_used && !is_same(&table->slots[i].plane, plane))
        i = (i + 1) & (table->room - 1);
    return &table->slots[i];
}

bool csg_plane_table_find(const struct csg_plane_table *table, const struct csg_plane *plane,
                          struct csg_face *face)
{
    struct csg_plane turned = *plane;
    const bool is_turned = turn(&turned);
    const struct csg_plane_slot *slot = table->room ? slot_of(table, &turned) : NULL;
    if (!slot || !slot->is_used)
        return false;
    *face = (struct csg_face){slot->face.carrier, slot->face.flipped != is_turned};
    return true;
}

static bool grow(struct csg_plane_table *table)
{
    const struct csg_plane_table old = *table;
    table->room = old.room ? 2 * old.room : 64;
    table->slots = calloc(table->room, sizeof *table->slots);
    if (!table->slots) {
        *table = old;
        return false;
    }
    for (size_t i = 0; i < old.room; i++)
        if (old.slots[i].is_used)
            *slot_of(table, &old.slots[i].plane) = old.slots[i];
    free(old.slots);
    return true;
}

bool csg_plane_table_add(struct csg_plane_table *table, const struct csg_plane *plane,
                         const struct csg_face *face)
{
    struct csg_plane turned = *plane;
    const bool is_turned = turn(&turned);
    if (2 * table->num >= table->room && !grow(table))
        return false;
    *slot_of(table, &turned) =
        (struct csg_plane_slot){turned, {face->carrier, face->flipped != is_turned}, true};
    table->num++;
    return true;
}
