/* SPDX-License-Identifier: MIT */
#include "csg/carrier_index.h"

#include <stdlib.h>

#define NO_ENTRY UINT32_MAX
#define INITIAL_BUCKETS 64

/* Side of a cell of directions: faces that coincide over a leaf are turned by far less. */
#define DIRECTION_CELL (1.0 / 32)

enum { KEY_PLANE, KEY_QUADRIC };

/* Directions no face of a real model is aligned with. */
static const struct csg_vec3 generic[2] = {{0.4370160, 0.6180340, 0.6535291},
                                           {0.7236068, -0.5257311, 0.4472136}};

bool csg_index_start(struct csg_carrier_index *index, struct csg_vec3 center, double radius,
                     double slack)
{
    index->center = center;
    index->probe = csg_add(center, csg_scale(radius, csg_vec3(0.3719, 0.2113, 0.5931)));
    index->cell = fmax(4 * slack, 1e-9 * radius);
    index->entries.num = 0;
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
}

/* Coordinates in cells. A plane and its reverse get the same ones: those of the normal that leans
 * towards the first generic direction. */
static void plane_coordinates(const struct csg_carrier_index *index, const struct csg_plane *plane,
                              double coordinates[3])
{
    const double along = csg_dot(plane->normal, generic[0]);
    const double s = along < 0 ? -1 : 1;
    coordinates[0] = s * along / DIRECTION_CELL;
    /* A normal across the generic direction may flip under rounding: its sign says nothing. */
    coordinates[1] = fabs(csg_dot(plane->normal, generic[1])) / DIRECTION_CELL;
    const double offset = plane->offset - csg_dot(plane->normal, index->center);
    coordinates[2] = fabs(offset) / index->cell;
}

static void quadric_coordinates(const struct csg_carrier_index *index,
                                const struct csg_quadric *quadric, double coordinates[3])
{
    const double slope = csg_length(csg_quadric_gradient(quadric, index->probe));
    const double distance =
        fabs(csg_quadric_value(quadric, index->probe)) / (slope > 0 ? slope : 1);
    coordinates[0] = coordinates[1] = 0.5;
    /* f/|grad f| follows a small change of the surface only to first order: wider cells. */
    coordinates[2] = distance / (8 * index->cell);
}

static int64_t cell_of(double coordinate)
{
    const double limit = 1e15;
    return (int64_t)floor(fmin(coordinate, limit));
}

static size_t bucket_of(const struct csg_carrier_index *index, const struct csg_index_key *key)
{
    uint64_t hash = (uint64_t)key->kind + 0x9e3779b97f4a7c15u;
    for (int i = 0; i < 3; i++) {
        hash ^= (uint64_t)key->cell[i];
        hash *= 0xbf58476d1ce4e5b9u;
        hash ^= hash >> 29;
    }
    return hash & (index->buckets.num - 1);
}

static void link_entry(struct csg_carrier_index *index, uint32_t entry)
{
    uint32_t *bucket = &index->buckets.data[bucket_of(index, &index->entries.data[entry].key)];
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
        link_entry(index, i);
    return true;
}

static bool add(struct csg_carrier_index *index, int64_t kind, const double coordinates[3],
                uint32_t carrier)
{
    const struct csg_index_entry entry = {
        {{cell_of(coordinates[0]), cell_of(coordinates[1]), cell_of(coordinates[2])}, kind},
        carrier,
        NO_ENTRY};
    if (index->entries.num >= index->buckets.num && !double_buckets(index))
        return false;
    if (!csg_array_push(&index->entries, entry))
        return false;
    link_entry(index, (uint32_t)index->entries.num - 1);
    return true;
}

bool csg_index_add_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                         uint32_t carrier)
{
    double coordinates[3];
    plane_coordinates(index, plane, coordinates);
    return add(index, KEY_PLANE, coordinates, carrier);
}

bool csg_index_add_quadric(struct csg_carrier_index *index, const struct csg_quadric *quadric,
                           uint32_t carrier)
{
    double coordinates[3];
    quadric_coordinates(index, quadric, coordinates);
    return add(index, KEY_QUADRIC, coordinates, carrier);
}

/* The face's cell and, in each coordinate, the neighbour it is nearer to. */
static void start_probe(int64_t kind, const double coordinates[3], struct csg_index_probe *probe)
{
    int64_t near[3], far[3];
    for (int i = 0; i < 3; i++) {
        near[i] = cell_of(coordinates[i]);
        far[i] = coordinates[i] - floor(coordinates[i]) < 0.5 ? near[i] - 1 : near[i] + 1;
    }
    probe->num_keys = 8;
    probe->key = -1;
    probe->entry = NO_ENTRY;
    for (int k = 0; k < 8; k++)
        probe->keys[k] = (struct csg_index_key){
            {k & 1 ? far[0] : near[0], k & 2 ? far[1] : near[1], k & 4 ? far[2] : near[2]}, kind};
}

void csg_index_probe_plane(const struct csg_carrier_index *index, const struct csg_plane *plane,
                           struct csg_index_probe *probe)
{
    double coordinates[3];
    plane_coordinates(index, plane, coordinates);
    start_probe(KEY_PLANE, coordinates, probe);
}

void csg_index_probe_quadric(const struct csg_carrier_index *index,
                             const struct csg_quadric *quadric, struct csg_index_probe *probe)
{
    double coordinates[3];
    quadric_coordinates(index, quadric, coordinates);
    start_probe(KEY_QUADRIC, coordinates, probe);
}

static bool same_key(const struct csg_index_key *a, const struct csg_index_key *b)
{
    return a->cell[0] == b->cell[0] && a->cell[1] == b->cell[1] && a->cell[2] == b->cell[2] &&
           a->kind == b->kind;
}

uint32_t csg_index_next(const struct csg_carrier_index *index, struct csg_index_probe *probe)
{
    for (;;) {
        while (probe->entry == NO_ENTRY) {
            if (++probe->key >= probe->num_keys)
                return UINT32_MAX;
            probe->entry = index->buckets.data[bucket_of(index, &probe->keys[probe->key])];
        }
        const struct csg_index_entry *entry = &index->entries.data[probe->entry];
        probe->entry = entry->next;
        if (same_key(&entry->key, &probe->keys[probe->key]))
            return entry->carrier;
    }
}
