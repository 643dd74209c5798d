/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_PLANE_TABLE_H
#define CSG_CSG_PLANE_TABLE_H

#include "csg/carrier.h"

/*
 * Planes by their very numbers, either way round, and the carriers they got. Faces of one plane,
 * such as those of the solids that a node is cut into, must get one carrier even where it is
 * another leaf's and a smaller face by itself would be too far from it: what lies between would be
 * a skin.
 */
struct csg_plane_slot {
    struct csg_plane plane; /* its first number that is not 0 is positive */
    struct csg_face face;
    bool is_used;
};

/* Zero-initialise it. */
struct csg_plane_table {
    struct csg_plane_slot *slots;
    size_t room, num;
};

void csg_plane_table_finish(struct csg_plane_table *table);

/* Whether the plane is there; face gets the plane's. */
bool csg_plane_table_find(const struct csg_plane_table *table, const struct csg_plane *plane,
                          struct csg_face *face);

/* Adds a plane that is not there. false: out of memory. */
bool csg_plane_table_add(struct csg_plane_table *table, const struct csg_plane *plane,
                         const struct csg_face *face);

#endif
