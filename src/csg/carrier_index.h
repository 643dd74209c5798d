/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_CARRIER_INDEX_H
#define CSG_CSG_CARRIER_INDEX_H

/*
 * A hash over carriers: finds the few that a face could lie on. Planes are kept twice: by their
 * normal to the last bit and their offset, which parts the thousands of parallel faces of a model
 * finely, and by the place of both in coarse cells, which tells what normals there are that nearly
 * agree: there, those of one normal in one cell are one entry.
 */

#include <stdint.h>

#include "common/array.h"
#include "solids/shape.h"

struct csg_index_entry {
    uint64_t key;   /* hash of what it is found by; different ones may share it */
    union {
        int64_t normal;    /* the number of a plane's normal */
        uint16_t place[3]; /* of a quadric, more finely than its cell */
    };
    uint32_t carrier;
    uint32_t next; /* of the same bucket; UINT32_MAX ends */
};

/* Cells of directions a side, one more on each. */
#define CSG_NUM_DIRECTIONS 36

/* By direction: 0, the number of the only normal that lies there, or -1 for several. */
struct csg_directions {
    int64_t normals[CSG_NUM_DIRECTIONS * CSG_NUM_DIRECTIONS];
};

struct csg_carrier_index {
    struct csg_vec3 center; /* where offsets are measured */
    double radius;          /* of the finite part of the scene */
    struct csg_vec3 probes[3]; /* where quadrics are measured */
    double cell; /* length; coincident faces differ by less than a quarter of it, where measured */
    double fine; /* the same for parallel planes, which differ by as much everywhere */
    struct csg_directions directions; /* of the planes in it */
    CSG_ARRAY(uint32_t) buckets;
    CSG_ARRAY(struct csg_index_entry) entries;
    uint32_t free_entry; /* the first of those that were removed; UINT32_MAX: none */
    CSG_ARRAY(uint64_t) quadric_keys; /* by quadric */
    CSG_ARRAY(uint32_t) members; /* by plane: the next of its normal and coarse cell */
};

/* Walks the entries of the cells around a face. */
struct csg_index_probe {
    uint64_t keys[8];
    int num_keys, key;
    uint32_t entry;
    int64_t without; /* the number of a normal that is not asked for; 0: none */
    bool is_placed;  /* only what is near this place is: */
    uint16_t place[3];
};

/* slack: how far coincident faces may be apart where they are measured; tolerance: on the leaf. */
bool csg_index_start(struct csg_carrier_index *index, struct csg_vec3 center, double radius,
                     double slack, double tolerance);
void csg_index_finish(struct csg_carrier_index *index);

bool csg_index_add_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                         uint32_t carrier);
bool csg_index_add_quadric(struct csg_carrier_index *index, const struct csg_quadric *quadric,
                           uint32_t carrier);

/* Take out again what was added. */
void csg_index_remove_plane(struct csg_carrier_index *index, const struct csg_plane *plane,
                            uint32_t carrier);
void csg_index_remove_quadric(struct csg_carrier_index *index, uint32_t carrier);

/* Planes with that normal or its reverse, to the last bit, and nearly that offset. */
void csg_index_probe_parallel(const struct csg_carrier_index *index, const struct csg_plane *plane,
                              struct csg_index_probe *probe);
/* One plane at least of each other normal that a coincident plane could have. */
void csg_index_probe_normals(const struct csg_carrier_index *index, const struct csg_plane *plane,
                             struct csg_index_probe *probe);
/* The next plane with the normal of one that this found, in its cell; UINT32_MAX: no more. */
uint32_t csg_index_next_member(const struct csg_carrier_index *index, uint32_t carrier);
void csg_index_probe_quadric(const struct csg_carrier_index *index,
                             const struct csg_quadric *quadric, struct csg_index_probe *probe);

/* The same in numbers, for those who only ask whether anything is there: the keys of all cells that
 * the probes above would look at, and how many they are. A plane's hold where no other normal is
 * about, as csg_directions_are_shared tells once it knows all planes. */
int csg_index_plane_keys(const struct csg_carrier_index *index, const struct csg_plane *plane,
                         uint64_t keys[8]);
int csg_index_quadric_keys(const struct csg_carrier_index *index,
                           const struct csg_quadric *quadric, uint64_t keys[8]);

/* Zero-initialise it. */
void csg_directions_add(struct csg_directions *directions, const struct csg_plane *plane);
void csg_directions_merge(struct csg_directions *to, const struct csg_directions *from);
/* Whether other normals are in the plane's cell or one next to it. */
bool csg_directions_are_shared(const struct csg_directions *directions,
                               const struct csg_plane *plane);

/* The next candidate, UINT32_MAX when there are no more. May repeat one. */
uint32_t csg_index_next(const struct csg_carrier_index *index, struct csg_index_probe *probe);

#endif
