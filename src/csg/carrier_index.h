/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_CARRIER_INDEX_H
#define CSG_CSG_CARRIER_INDEX_H

/* A hash over the carriers of one object: finds the few that a face could lie on. */

#include <stdint.h>

#include "common/array.h"
#include "solids/shape.h"

struct csg_index_key {
    int64_t cell[3];
    int64_t kind; /* plane or quadric */
};

struct csg_index_entry {
    struct csg_index_key key;
    uint32_t carrier;
    uint32_t next; /* of the same bucket; UINT32_MAX ends */
};

struct csg_carrier_index {
    struct csg_vec3 center; /* where offsets are measured */
    struct csg_vec3 probe;  /* where quadrics are measured */
    double cell;            /* length; two coincident faces differ by less than half of it */
    CSG_ARRAY(uint32_t) buckets;
    CSG_ARRAY(struct csg_index_entry) entries;
};

/* Walks the entries of the cells around a face. */
struct csg_index_probe {
    struct csg_index_key keys[8];
    int num_keys, key;
    uint32_t entry;
};

bool csg_index_start(struct csg_carrier_index *index, struct csg_vec3 center, double radius,
                     double slack);
void csg_index_finish(struct csg_carrier_index *index);

bool csg_index_add_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                         uint32_t carrier);
bool csg_index_add_quadric(struct csg_carrier_index *index, const struct csg_quadric *quadric,
                           uint32_t carrier);

void csg_index_probe_plane(const struct csg_carrier_index *index, const struct csg_plane *plane,
                           struct csg_index_probe *probe);
void csg_index_probe_quadric(const struct csg_carrier_index *index,
                             const struct csg_quadric *quadric, struct csg_index_probe *probe);

/* The next candidate, UINT32_MAX when there are no more. May repeat one. */
uint32_t csg_index_next(const struct csg_carrier_index *index, struct csg_index_probe *probe);

#endif
