/* SPDX-License-Identifier: MIT */
/*
 * Faces of four corners that cross themselves. libtess2 makes only triangles with a new corner of
 * them, where they cross, and OpenSCAD 2021.01 throws these away. What then is left, the loop of
 * the face's edges, is cut by EdgeDict::triangulateLoops (GeometryUtils.cc), which begins with the
 * first vertex of a hash table, so only the order of that table says which diagonal it is: of
 * libstdc++'s unordered_map, over keys in the order of another one, of the edges, by the hash of
 * Boost before 1.81. For eleven entries and fewer both have 13 buckets.
 */
#include "polyhedra/cut.h"

enum { num_edges = 4, num_buckets = 13 };

/* boost::hash_combine, of 64 bits. */
static uint64_t combine(uint64_t hash, uint64_t key)
{
    const uint64_t factor = 0xc6a4a7935bd1e995u;
    key *= factor;
    key ^= key >> 47;
    key *= factor;
    hash ^= key;
    hash *= factor;
    return hash + 0xe6546b64u;
}

/* A new entry goes before the others of its bucket, or before all. */
static void insert(int *order, int num, int entry, const uint64_t *hashes)
{
    int at = 0;
    for (int i = 0; i < num; i++)
        if (hashes[order[i]] % num_buckets == hashes[entry] % num_buckets) {
            at = i;
            break;
        }
    for (int i = num; i > at; i--)
        order[i] = order[i - 1];
    order[at] = entry;
}

int csg_crossed_corner(const uint32_t numbers[4])
{
    uint64_t edges[num_edges], corners[num_edges];
    int edge_order[num_edges], order[num_edges];
    for (int i = 0; i < num_edges; i++) {
        edges[i] = combine(combine(0, numbers[i]), numbers[(i + 1) % num_edges]);
        corners[i] = numbers[i];
        insert(edge_order, i, i, edges);
    }
    for (int i = 0; i < num_edges; i++)
        insert(order, i, edge_order[i], corners);
    return order[0];
}
