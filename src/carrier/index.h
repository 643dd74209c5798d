/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_INDEX_H
#define CSG_CARRIER_INDEX_H

/*
 * A hash over carriers: finds the few that a face could lie on. Planes are kept by their normal to
 * the last bit and their offset, which parts the thousands of parallel faces of a model finely, and
 * by the place of both in coarse cells of each width, which tells what normals there are that
 * nearly agree: there, those of one normal in one cell are one entry, or few.
 */

#include "carrier/key.h"
#include "common/array.h"

struct csg_index_entry {
    uint64_t key; /* hash of what it is found by; different ones may share it */
    union {
        int64_t normal;    /* the number of a plane's normal */
        uint16_t place[3]; /* of a quadric, more finely than its cell */
    };
    uint32_t carrier;
    uint32_t next; /* of the same bucket; UINT32_MAX ends */
};

struct csg_carrier_index {
    struct csg_carrier_space space;
    struct csg_directions directions; /* of the planes in it */
    CSG_ARRAY(uint32_t) buckets;
    CSG_ARRAY(struct csg_index_entry) entries;
    uint32_t free_entry;              /* the first of those that were removed; UINT32_MAX: none */
    CSG_ARRAY(uint64_t) quadric_keys; /* by quadric */
    /* By plane and, within, by width: the next of its normal and coarse cell. */
    CSG_ARRAY(uint32_t) members;
};

bool csg_index_start(struct csg_carrier_index *index, const struct csg_carrier_space *space);
void csg_index_finish(struct csg_carrier_index *index);

bool csg_index_add_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                         uint32_t carrier);
bool csg_index_add_quadric(struct csg_carrier_index *index, const struct csg_quadric *quadric,
                           uint32_t carrier);

/* Take out again what was added. */
void csg_index_remove_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                            uint32_t carrier);
void csg_index_remove_quadric(struct csg_carrier_index *index, uint32_t carrier);

/* A plane's place in members. */
static inline size_t csg_index_member(const struct csg_carrier_index *index, int width,
                                      uint32_t carrier)
{
    return carrier * (size_t)index->space.num_widths + (size_t)width;
}

static inline size_t csg_index_bucket(const struct csg_carrier_index *index, uint64_t key)
{
    return key & (index->buckets.num - 1);
}

#endif
