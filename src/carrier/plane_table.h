/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_PLANE_TABLE_H
#define CSG_CARRIER_PLANE_TABLE_H

#include "carrier/carrier.h"
#include "common/array.h"

/*
 * Planes that got the carrier of another one, nearly the same, by their very numbers, either way
 * round. Faces of one plane, such as those of the solids that a node is cut into, must get one
 * carrier even where it is another leaf's and a smaller face by itself would be too far from it:
 * what lies between would be a skin. Planes that are a carrier's own are in csg_carrier_index.
 */
struct csg_other_plane {
    struct csg_plane plane; /* its first number that is not 0 is positive */
    struct csg_face face;
};

struct csg_plane_slot {
    uint32_t tag;   /* of the plane's hash */
    uint32_t place; /* in planes, + 1; 0: free */
};

/* Zero-initialise it. */
struct csg_plane_table {
    struct csg_plane_slot *slots;
    size_t room, num;
    CSG_ARRAY(struct csg_other_plane) planes;
    CSG_ARRAY(uint32_t) free; /* places of those that were removed */
};

void csg_plane_table_finish(struct csg_plane_table *table);

/* Whether the plane is there; face gets the plane's. */
bool csg_plane_table_find(const struct csg_plane_table *table, const struct csg_plane *plane,
                          struct csg_face *face);

/* Takes the plane out, if it is there. */
void csg_plane_table_remove(struct csg_plane_table *table, const struct csg_plane *plane);

/* Adds a plane that is not there. false: out of memory. */
bool csg_plane_table_add(struct csg_plane_table *table, const struct csg_plane *plane,
                         const struct csg_face *face);

#endif
