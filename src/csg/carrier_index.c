/* SPDX-License-Identifier: MIT */
#include "csg/carrier_index.h"

#include <stdlib.h>
#include <string.h>

#define NO_ENTRY UINT32_MAX
#define INITIAL_BUCKETS 64

/* Side of a cell of directions: faces that coincide over a leaf are turned by far less. */
#define DIRECTION_CELL (1.0 / 32)

/* Neighbours are looked at where they are as near as this, in cells. Lengths: coincident faces
 * differ by less, so that most of the time one cell of two does. Directions: the nearer one always.
 */
#define NEAR_LENGTH 0.25
#define NEAR_DIRECTION 0.5

/* Places of quadrics are counted in parts of a cell; a part more for their rounding. */
#define PARTS 64
#define NEAR_PARTS 17

enum { KEY_PARALLEL, KEY_NORMAL, KEY_QUADRIC };

/* Directions no face of a real model is aligned with. */
static const struct csg_vec3 generic[2] = {{0.4370160, 0.6180340, 0.6535291},
                                           {0.7236068, -0.5257311, 0.4472136}};

/* Quadrics are told apart by their distances from three points, in radii of the scene from its
 * center, that have no model's symmetry. */
static const struct csg_vec3 probes[3] = {
    {0.3719, 0.2113, 0.5931}, {-0.5623, 0.4417, 0.1279}, {0.2371, -0.6127, -0.3343}};

bool csg_index_start(struct csg_carrier_index *index, struct csg_vec3 center, double radius,
                     double slack, double tolerance)
{
    index->center = center;
    index->radius = radius;
    for (int i = 0; i < 3; i++)
        index->probes[i] = csg_add(center, csg_scale(radius, probes[i]));
    index->cell = fmax(8 * slack, 2e-9 * radius);
    index->fine = fmax(4 * tolerance, 1e-12 * radius);
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

/* Coordinates in cells. A plane and its reverse get the same ones: those of the normal that leans
 * towards the first generic direction. */
static void direction_coordinates(struct csg_vec3 normal, double coordinates[2])
{
    /* A normal across the generic direction may flip under rounding: its sign says nothing. */
    for (int i = 0; i < 2; i++)
        coordinates[i] = fabs(csg_dot(normal, generic[i])) / DIRECTION_CELL;
}

static void plane_coordinates(const struct csg_carrier_index *index, const struct csg_plane *plane,
                              double coordinates[3])
{
    const double offset = plane->offset - csg_dot(plane->normal, index->center);
    direction_coordinates(plane->normal, coordinates);
    coordinates[2] = fabs(offset) / index->cell;
}

/* A third of the norm of f's second derivatives, squared: what it is of a sphere. */
static double curvature(const struct csg_quadric *quadric)
{
    double sum = 0;
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++) {
            double entry = 0;
            for (int i = 0; i < 3; i++)
                entry += quadric->diag[i] * quadric->to_canon.m[i][j] * quadric->to_canon.m[i][k];
            sum += entry * entry;
        }
    return sqrt(sum / 3);
}

/*
 * How far p is from the surface, nearly: exactly for a sphere, and bounded wherever the gradient
 * vanishes (Taubin 1994, Distance approximations for rasterizing implicit curves, eq. 9, with one
 * norm for all second derivatives). It does not depend on how the surface was brought to its
 * normal form.
 */
static double distance_of(const struct csg_quadric *quadric, double curved, struct csg_vec3 p)
{
    const double value = fabs(csg_quadric_value(quadric, p));
    const double slope = csg_length(csg_quadric_gradient(quadric, p));
    const double sum = slope + sqrt(slope * slope + 4 * value * curved);
    return sum > 0 ? 2 * value / sum : value;
}

static void quadric_coordinates(const struct csg_carrier_index *index,
                                const struct csg_quadric *quadric, double coordinates[3])
{
    const double curved = curvature(quadric);
    /* The distance follows a small change of the surface only to first order: wider cells. */
    for (int i = 0; i < 3; i++)
        coordinates[i] = distance_of(quadric, curved, index->probes[i]) / (8 * index->cell);
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

static bool add_with_normal(struct csg_carrier_index *index, uint64_t key, int64_t normal,
                            uint32_t carrier)
{
    const struct csg_index_entry entry = {
        .key = key, .normal = normal, .carrier = carrier, .next = NO_ENTRY};
    return add(index, &entry);
}

/* Of a cell, for one of the three ways to look, which must not meet: small numbers of cells would
 * make up for kinds that follow each other. */
static uint64_t key_of_cell(uint64_t kind, const int64_t cell[3])
{
    uint64_t hash = (kind + 1) * 0x9e3779b97f4a7c15u;
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

static void note_direction(struct csg_directions *directions, const double coordinates[2],
                           int64_t normal)
{
    int64_t *there =
        &directions->normals[direction_of(cell_of(coordinates[0]), cell_of(coordinates[1]))];
    if (*there != normal)
        *there = *there == 0 ? normal : -1;
}

void csg_directions_add(struct csg_directions *directions, const struct csg_plane *plane)
{
    double coordinates[2];
    direction_coordinates(plane->normal, coordinates);
    note_direction(directions, coordinates, number_of(plane->normal));
}

void csg_directions_merge(struct csg_directions *to, const struct csg_directions *from)
{
    for (size_t i = 0; i < CSG_NUM_DIRECTIONS * CSG_NUM_DIRECTIONS; i++)
        if (from->normals[i] != 0 && from->normals[i] != to->normals[i])
            to->normals[i] = to->normals[i] == 0 ? from->normals[i] : -1;
}

bool csg_directions_are_shared(const struct csg_directions *directions,
                               const struct csg_plane *plane)
{
    const int64_t normal = number_of(plane->normal);
    double coordinates[2];
    direction_coordinates(plane->normal, coordinates);
    for (int k = 0; k < 9; k++) {
        const int64_t x = cell_of(coordinates[0]) + k % 3 - 1;
        const int64_t y = cell_of(coordinates[1]) + k / 3 - 1;
        const int64_t there = directions->normals[direction_of(x, y)];
        if (there != 0 && there != normal)
            return true;
    }
    return false;
}

static bool is_same_entry(const struct csg_index_entry *a, uint64_t key, int64_t normal)
{
    return a->key == key && a->normal == normal;
}

/* The link to the entry of a normal in a coarse cell, or the end of its bucket. */
static uint32_t *normal_link(struct csg_carrier_index *index, uint64_t key, int64_t normal)
{
    uint32_t *link = &index->buckets.data[bucket_of(index, key)];
    while (*link != NO_ENTRY && !is_same_entry(&index->entries.data[*link], key, normal))
        link = &index->entries.data[*link].next;
    return link;
}

static bool add_normal(struct csg_carrier_index *index, const struct csg_plane *plane,
                       int64_t normal, uint32_t carrier)
{
    double coordinates[3];
    plane_coordinates(index, plane, coordinates);
    note_direction(&index->directions, coordinates, normal);
    const uint64_t key = key_of(KEY_NORMAL, coordinates);
    const uint32_t entry = *normal_link(index, key, normal);
    while (index->members.num <= carrier)
        if (!csg_array_push(&index->members, NO_ENTRY))
            return false;
    index->members.data[carrier] = NO_ENTRY;
    if (entry == NO_ENTRY)
        return add_with_normal(index, key, normal, carrier);
    index->members.data[carrier] = index->entries.data[entry].carrier;
    index->entries.data[entry].carrier = carrier;
    return true;
}

static void remove_normal(struct csg_carrier_index *index, const struct csg_plane *plane,
                          int64_t normal, uint32_t carrier)
{
    double coordinates[3];
    plane_coordinates(index, plane, coordinates);
    uint32_t *link = normal_link(index, key_of(KEY_NORMAL, coordinates), normal);
    if (*link == NO_ENTRY)
        return;
    uint32_t *member = &index->entries.data[*link].carrier;
    while (*member != carrier && *member != NO_ENTRY)
        member = &index->members.data[*member];
    if (*member == carrier)
        *member = index->members.data[carrier];
    if (index->entries.data[*link].carrier == NO_ENTRY)
        remove_entry(index, link);
}

bool csg_index_add_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                         uint32_t carrier)
{
    const int64_t normal = number_of(plane->normal);
    const uint64_t key = parallel_key(normal, cell_of(parallel_coordinate(index, plane)));
    return add_with_normal(index, key, normal, carrier) &&
           add_normal(index, plane, normal, carrier);
}

/* Of the entries with that key the carrier's. */
static void remove_carrier(struct csg_carrier_index *index, uint64_t key, uint32_t carrier)
{
    uint32_t *link = &index->buckets.data[bucket_of(index, key)];
    for (; *link != NO_ENTRY; link = &index->entries.data[*link].next)
        if (index->entries.data[*link].key == key &&
            index->entries.data[*link].carrier == carrier) {
            remove_entry(index, link);
            return;
        }
}

void csg_index_remove_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                            uint32_t carrier)
{
    const int64_t normal = number_of(plane->normal);
    remove_carrier(index, parallel_key(normal, cell_of(parallel_coordinate(index, plane))),
                   carrier);
    remove_normal(index, plane, normal, carrier);
}

uint32_t csg_index_next_member(const struct csg_carrier_index *index, uint32_t carrier)
{
    return index->members.data[carrier];
}

/* Only quadrics of equal normal forms, up to their sign, can be the same surface. */
static uint64_t quadric_kind(const struct csg_quadric *quadric)
{
    int code = 0, negated = 0;
    for (int i = 0; i < 4; i++) {
        code = 3 * code + (int)quadric->diag[i] + 1;
        negated = 3 * negated - (int)quadric->diag[i] + 1;
    }
    return KEY_QUADRIC + (uint64_t)(code < negated ? code : negated);
}

/* Modulo 2^16: only what is in one cell or in neighbours is compared. */
static void put_place(const double coordinates[3], uint16_t place[3])
{
    for (int i = 0; i < 3; i++)
        place[i] = (uint16_t)(uint64_t)cell_of(PARTS * coordinates[i]);
}

static bool is_near_place(const uint16_t a[3], const uint16_t b[3])
{
    for (int i = 0; i < 3; i++) {
        const uint16_t apart = (uint16_t)(a[i] - b[i] + NEAR_PARTS);
        if (apart > 2 * NEAR_PARTS)
            return false;
    }
    return true;
}

bool csg_index_add_quadric(struct csg_carrier_index *index, const struct csg_quadric *quadric,
                           uint32_t carrier)
{
    struct csg_index_entry entry = {.carrier = carrier, .next = NO_ENTRY};
    double coordinates[3];
    quadric_coordinates(index, quadric, coordinates);
    entry.key = key_of(quadric_kind(quadric), coordinates);
    put_place(coordinates, entry.place);
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

/* The neighbour of a coordinate's cell that it is nearer to. */
static int64_t neighbour_of(double coordinate)
{
    const int64_t cell = cell_of(coordinate);
    return coordinate - floor(coordinate) < 0.5 ? cell - 1 : cell + 1;
}

static bool is_near(double coordinate, double near)
{
    const double part = coordinate - floor(coordinate);
    return !(fmin(part, 1 - part) > near);
}

/* The keys of a face's cell and of the neighbours that it is near to in some coordinates. */
static int keys_around(uint64_t kind, const double coordinates[3], const double near[3],
                       uint64_t keys[8])
{
    int num = 0, far = 0;
    for (int i = 0; i < 3; i++)
        far |= is_near(coordinates[i], near[i]) << i;
    for (int k = 0; k < 8; k++) {
        int64_t cell[3];
        for (int i = 0; i < 3; i++)
            cell[i] = k >> i & 1 ? neighbour_of(coordinates[i]) : cell_of(coordinates[i]);
        if ((k & ~far) == 0)
            keys[num++] = key_of_cell(kind, cell);
    }
    return num;
}

int csg_index_plane_keys(const struct csg_carrier_index *index, const struct csg_plane *plane,
                         uint64_t keys[8])
{
    const double coordinate = parallel_coordinate(index, plane);
    const int64_t normal = number_of(plane->normal);
    keys[0] = parallel_key(normal, cell_of(coordinate));
    if (!is_near(coordinate, NEAR_LENGTH))
        return 1;
    keys[1] = parallel_key(normal, neighbour_of(coordinate));
    return 2;
}

static const double near_lengths[3] = {NEAR_LENGTH, NEAR_LENGTH, NEAR_LENGTH};

int csg_index_quadric_keys(const struct csg_carrier_index *index,
                           const struct csg_quadric *quadric, uint64_t keys[8])
{
    double coordinates[3];
    quadric_coordinates(index, quadric, coordinates);
    return keys_around(quadric_kind(quadric), coordinates, near_lengths, keys);
}

/* Before its first cell. */
static void rewind_probe(struct csg_index_probe *probe)
{
    probe->without = 0;
    probe->is_placed = false;
    probe->key = -1;
    probe->entry = NO_ENTRY;
}

void csg_index_probe_parallel(const struct csg_carrier_index *index, const struct csg_plane *plane,
                              struct csg_index_probe *probe)
{
    rewind_probe(probe);
    probe->num_keys = csg_index_plane_keys(index, plane, probe->keys);
}

/* Whether some other normal lies about there: in most models there is none. */
static bool has_neighbours(const struct csg_carrier_index *index, const double coordinates[3],
                           int64_t normal)
{
    for (int k = 0; k < 4; k++) {
        const int64_t x = k & 1 ? neighbour_of(coordinates[0]) : cell_of(coordinates[0]);
        const int64_t y = k & 2 ? neighbour_of(coordinates[1]) : cell_of(coordinates[1]);
        const int64_t there = index->directions.normals[direction_of(x, y)];
        if (there != 0 && there != normal)
            return true;
    }
    return false;
}

void csg_index_probe_normals(const struct csg_carrier_index *index, const struct csg_plane *plane,
                             struct csg_index_probe *probe)
{
    static const double near[3] = {NEAR_DIRECTION, NEAR_DIRECTION, NEAR_LENGTH};
    double coordinates[3];
    plane_coordinates(index, plane, coordinates);
    rewind_probe(probe);
    probe->without = number_of(plane->normal);
    probe->num_keys = has_neighbours(index, coordinates, probe->without)
                          ? keys_around(KEY_NORMAL, coordinates, near, probe->keys)
                          : 0;
}

void csg_index_probe_quadric(const struct csg_carrier_index *index,
                             const struct csg_quadric *quadric, struct csg_index_probe *probe)
{
    double coordinates[3];
    quadric_coordinates(index, quadric, coordinates);
    rewind_probe(probe);
    probe->num_keys = keys_around(quadric_kind(quadric), coordinates, near_lengths, probe->keys);
    probe->is_placed = true;
    put_place(coordinates, probe->place);
}

static bool is_asked_for(const struct csg_index_probe *probe, const struct csg_index_entry *entry)
{
    if (entry->key != probe->keys[probe->key])
        return false;
    if (probe->is_placed)
        return is_near_place(probe->place, entry->place);
    return probe->without == 0 || entry->normal != probe->without;
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
        if (is_asked_for(probe, entry))
            return entry->carrier;
    }
}
