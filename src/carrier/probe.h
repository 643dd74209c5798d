/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_PROBE_H
#define CSG_CARRIER_PROBE_H

#include "carrier/index.h"

/* Walks the entries of the cells around a face. */
struct csg_index_probe {
    uint64_t keys[8];
    int num_keys, key;
    uint32_t entry;
    int64_t without; /* the number of a normal that is not asked for; 0: none */
    bool is_placed;  /* only what is near this place is: */
    uint16_t place[3];
};

/* Planes with that normal or its reverse, to the last bit, and nearly that offset. */
void csg_index_probe_parallel(const struct csg_carrier_index *index, const struct csg_plane *plane,
                              struct csg_index_probe *probe);
/* One plane at least of each other normal that a plane could have that is in one cell of that width
 * with it, or in cells that are near. */
void csg_index_probe_normals(const struct csg_carrier_index *index, int width,
                             const struct csg_plane *plane, struct csg_index_probe *probe);
void csg_index_probe_quadric(const struct csg_carrier_index *index,
                             const struct csg_quadric *quadric, struct csg_index_probe *probe);

/* The next candidate, UINT32_MAX when there are no more. May repeat one. */
uint32_t csg_index_next(const struct csg_carrier_index *index, struct csg_index_probe *probe);

/* The next plane with the normal of one that csg_index_probe_normals found, in its cell of that
 * width; UINT32_MAX: no more. */
uint32_t csg_index_next_member(const struct csg_carrier_index *index, int width, uint32_t carrier);

#endif
