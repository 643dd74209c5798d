/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_PLANE_TABLE_H
#define CSG_CSG_PLANE_TABLE_H

#include "common/array.h"
#include "csg/carrier.h"

/*
 * Planes by their very numbers, either way round, and the carriers they got. Faces of one plane,
 * such as those of the solids that a node is cut into, must get one carrier even where it is
 * another leaf's and a smaller face by itself would be too far from it: what lies between would be
 * a skin.
 */
struct csg_plane_slot {
    uint32_t tag;   /* of the plane's hash */
    uint32_t place; /* 0: free; carrier + 1: its own plane; from CSG_PLANE_OTHER on: others */
};

#define CSG_PLANE_OTHER 0x80000000u

/* A plane that got the carrier of another, nearly the same. */
struct csg_other_plane {
    struct csg_plane plane; /* its first number that is not 0 is positive */
    struct csg_face face;
};

/* Zero-initialise it. */
struct csg_plane_table {
    struct csg_plane_slot *slots;
    size_t room, num;
    CSG_ARRAY(struct csg_other_plane) others;
    CSG_ARRAY(uint32_t) free_others; /* of those that were removed */
};

void csg_plane_table_finish(struct csg_plane_table *table);

/* Whether the plane is there; face gets the plane's. planes: of the carriers. */
bool csg_plane_table_find(const struct csg_plane_table *table, const struct csg_plane *planes,
                          const struct csg_plane *plane, struct csg_face *face);

/* Takes the plane out, if it is there. */
void csg_plane_table_remove(struct csg_plane_table *table, const struct csg_plane *planes,
                            const struct csg_plane *plane);

/* Adds a plane that is not there. false: out of memory. */
bool csg_plane_table_add(struct csg_plane_table *table, const struct csg_plane *planes,
                         const struct csg_plane *plane, const struct csg_face *face);

#endif
