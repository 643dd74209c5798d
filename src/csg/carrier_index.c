/* SPDX-License-Identifier: MIT */
#include "csg/carrier_index.h"

#include <stdlib.h>
#include <string.h>

#define NO_ENTRY UINT32_MAX
#define INITIAL_BUCKETS 64

/* Side of a cell of directions: faces that coincide over a leaf are turned by far less. */
#define DIRECTION_CELL (1.0 / 32)

enum { KEY_PARALLEL, KEY_NORMAL, KEY_QUADRIC };

/* Directions no face of a real model is aligned with. */
static const struct csg_vec3 generic[2] = {{0.4370160, 0.6180340, 0.6535291},
                                           {0.7236068, -0.5257311, 0.4472136}};

/* Quadrics are told apart by their distances from two points, in radii of the scene from its
 * center, that have no model's symmetry. */
static const struct csg_vec3 probes[2] = {{0.3719, 0.2113, 0.5931}, {-0.5623, 0.4417, 0.1279}};

bool csg_index_start(struct csg_carrier_index *index, struct csg_vec3 center, double radius,
                     double slack, double tolerance)
{
    index->center = center;
    for (int i = 0; i < 2; i++)
        index->probes[i] = csg_add(center, csg_scale(radius, probes[i]));
    index->cell = fmax(4 * slack, 1e-9 * radius);
    index->fine = fmax(4 * tolerance, 1e-12 * radius);
    memset(index->normals, 0, sizeof index->normals);
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
    coordinates[2] = 0.5;
    for (int i = 0; i < 2; i++) {
        const double slope = csg_length(csg_quadric_gradient(quadric, index->probes[i]));
        const double distance =
            fabs(csg_quadric_value(quadric, index->probes[i])) / (slope > 0 ? slope : 1);
        /* f/|grad f| follows a small change of the surface only to first order: wider cells. */
        coordinates[i] = distance / (8 * index->cell);
    }
}

static int64_t cell_of(double coordinate)
{
    const double limit = 1e15;
    return (int64_t)floor(fmin(coordinate, limit));
}

static size_t bucket_of(const struct csg_carrier_index *index, uint64_t key)
{
    return key & (index->buckets.num - 1);
}

static void link_entry(struct csg_carrier_index *index, uint32_t entry)
{
    uint32_t *bucket = &index->buckets.data[bucket_of(index, index->entries.data[entry].key)];
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

static bool add(struct csg_carrier_index *index, uint64_t key, int64_t normal,
                uint32_t carrier)
{
    const struct csg_index_entry entry = {key, normal, carrier, NO_ENTRY};
    if (index->entries.num >= index->buckets.num && !double_buckets(index))
        return false;
    if (!csg_array_push(&index->entries, entry))
        return false;
    link_entry(index, (uint32_t)index->entries.num - 1);
    return true;
}

/* Of a cell, for one of the three ways to look. */
static uint64_t key_of_cell(uint64_t kind, const int64_t cell[3])
{
    uint64_t hash = kind + 0x9e3779b97f4a7c15u;
    for (int i = 0; i < 3; i++) {
        hash ^= (uint64_t)cell[i];
        hash *= 0xbf58476d1ce4e5b9u;
        hash ^= hash >> 29;
    }
    return hash;
}

static uint64_t key_of(uint64_t kind, const double coordinates[3])
{
    const int64_t cell[3] = {cell_of(coordinates[0]), cell_of(coordinates[1]),
                             cell_of(coordinates[2])};
    return key_of_cell(kind, cell);
}

static uint64_t parallel_key(int64_t normal, int64_t cell)
{
    return key_of_cell(KEY_PARALLEL, (const int64_t[3]){normal, cell, 0});
}

static bool is_reversed(struct csg_vec3 n)
{
    return n.x != 0 ? n.x < 0 : n.y != 0 ? n.y < 0 : n.z < 0;
}

/* A number, not 0, of a normal's bits, the same for its reverse. Different ones may share it. */
static int64_t number_of(struct csg_vec3 n)
{
    const double s = is_reversed(n) ? -1 : 1;
    const double v[3] = {s * n.x + 0.0, s * n.y + 0.0, s * n.z + 0.0}; /* no -0 */
    uint64_t hash = 0, bits;
    for (int i = 0; i < 3; i++) {
        memcpy(&bits, &v[i], sizeof bits);
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 31;
    }
    return (int64_t)(hash >> 2) + 1;
}

static double parallel_coordinate(const struct csg_carrier_index *index,
                                  const struct csg_plane *plane)
{
    const double offset = plane->offset - csg_dot(plane->normal, index->center);
    return (is_reversed(plane->normal) ? -offset : offset) / index->fine;
}

/* Cells are numbered from -1, a neighbour's; what is no direction goes to the last one. */
static size_t direction_of(int64_t x, int64_t y)
{
    const int64_t last = CSG_NUM_DIRECTIONS - 2;
    return (size_t)((x < last ? x : last) + 1) * CSG_NUM_DIRECTIONS +
           (size_t)((y < last ? y : last) + 1);
}

static void note_direction(struct csg_carrier_index *index, const double coordinates[3],
                           int64_t normal)
{
    int64_t *there =
        &index->normals[direction_of(cell_of(coordinates[0]), cell_of(coordinates[1]))];
    if (*there != normal)
        *there = *there == 0 ? normal : -1;
}

static bool add_normal(struct csg_carrier_index *index, const struct csg_plane *plane,
                       int64_t normal, uint32_t carrier)
{
    double coordinates[3];
    plane_coordinates(index, plane, coordinates);
    note_direction(index, coordinates, normal);
    const uint64_t key = key_of(KEY_NORMAL, coordinates);
    for (uint32_t i = index->buckets.data[bucket_of(index, key)]; i != NO_ENTRY;
         i = index->entries.data[i].next)
        if (index->entries.data[i].key == key && index->entries.data[i].normal == normal)
            return true;
    return add(index, key, normal, carrier);
}

bool csg_index_add_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                         uint32_t carrier)
{
    const int64_t normal = number_of(plane->normal);
    const uint64_t key = parallel_key(normal, cell_of(parallel_coordinate(index, plane)));
    return add(index, key, normal, carrier) && add_normal(index, plane, normal, carrier);
}

bool csg_index_add_quadric(struct csg_carrier_index *index, const struct csg_quadric *quadric,
                           uint32_t carrier)
{
    double coordinates[3];
    quadric_coordinates(index, quadric, coordinates);
    return add(index, key_of(KEY_QUADRIC, coordinates), 0, carrier);
}

/* The neighbour of a coordinate's cell that it is nearer to. */
static int64_t neighbour_of(double coordinate)
{
    const int64_t cell = cell_of(coordinate);
    return coordinate - floor(coordinate) < 0.5 ? cell - 1 : cell + 1;
}

/* The face's cell and, in each of the first num coordinates, the neighbour it is nearer to. */
static void start_probe(uint64_t kind, const double coordinates[3], int num,
                        struct csg_index_probe *probe)
{
    int64_t near[3], far[3];
    for (int i = 0; i < 3; i++) {
        near[i] = cell_of(coordinates[i]);
        far[i] = neighbour_of(coordinates[i]);
    }
    probe->num_keys = 1 << num;
    probe->without = 0;
    probe->key = -1;
    probe->entry = NO_ENTRY;
    for (int k = 0; k < probe->num_keys; k++)
        probe->keys[k] = key_of_cell(kind, (const int64_t[3]){k & 1 ? far[0] : near[0],
                                                              k & 2 ? far[1] : near[1],
                                                              k & 4 ? far[2] : near[2]});
}

void csg_index_probe_parallel(const struct csg_carrier_index *index, const struct csg_plane *plane,
                              struct csg_index_probe *probe)
{
    const double coordinate = parallel_coordinate(index, plane);
    const int64_t normal = number_of(plane->normal);
    *probe = (struct csg_index_probe){.num_keys = 2, .key = -1, .entry = NO_ENTRY};
    probe->keys[0] = parallel_key(normal, cell_of(coordinate));
    probe->keys[1] = parallel_key(normal, neighbour_of(coordinate));
}

/* Whether some other normal lies about there: in most models there is none. */
static bool has_neighbours(const struct csg_carrier_index *index, const double coordinates[3],
                           int64_t normal)
{
    for (int k = 0; k < 4; k++) {
        const int64_t x = k & 1 ? neighbour_of(coordinates[0]) : cell_of(coordinates[0]);
        const int64_t y = k & 2 ? neighbour_of(coordinates[1]) : cell_of(coordinates[1]);
        const int64_t there = index->normals[direction_of(x, y)];
        if (there != 0 && there != normal)
            return true;
    }
    return false;
}

void csg_index_probe_normals(const struct csg_carrier_index *index, const struct csg_plane *plane,
                             struct csg_index_probe *probe)
{
    double coordinates[3];
    plane_coordinates(index, plane, coordinates);
    start_probe(KEY_NORMAL, coordinates, 3, probe);
    probe->without = number_of(plane->normal);
    if (!has_neighbours(index, coordinates, probe->without))
        probe->num_keys = 0;
}

void csg_index_probe_quadric(const struct csg_carrier_index *index,
                             const struct csg_quadric *quadric, struct csg_index_probe *probe)
{
    double coordinates[3];
    quadric_coordinates(index, quadric, coordinates);
    start_probe(KEY_QUADRIC, coordinates, 2, probe);
}

uint32_t csg_index_next(const struct csg_carrier_index *index, struct csg_index_probe *probe)
{
    for (;;) {
        while (probe->entry == NO_ENTRY) {
            if (++probe->key >= probe->num_keys)
                return UINT32_MAX;
            probe->entry = index->buckets.data[bucket_of(index, probe->keys[probe->key])];
        }
        const struct csg_index_entry *entry = &index->entries.data[probe->entry];
        probe->entry = entry->next;
        if (entry->key == probe->keys[probe->key] &&
            (probe->without == 0 || entry->normal != probe->without))
            return entry->carrier;
    }
}
