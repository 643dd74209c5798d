/* SPDX-License-Identifier: MIT */
#ifndef CSG_POLYHEDRA_EDGES_H
#define CSG_POLYHEDRA_EDGES_H

/* Which faces of a mesh meet at its edges. */

#include "polyhedra/mesh.h"

/* An edge of a face, in the list of its end with the smaller number. */
struct csg_mesh_edge {
    uint32_t high, face;
    int8_t direction; /* 1: from low to high */
};

/* The list of point i is edges[begin[i]] to edges[begin[i + 1]], by high, then by face. */
struct csg_mesh_edges {
    uint32_t *begin;
    struct csg_mesh_edge *edges;
};

/* false: out of memory. */
bool csg_mesh_edges_init(struct csg_mesh_edges *edges, const struct csg_mesh *mesh);
void csg_mesh_edges_finish(struct csg_mesh_edges *edges);

/* The end of the run of edges at i that have the same ends; end: of their list. */
uint32_t csg_mesh_edges_run(const struct csg_mesh_edges *edges, uint32_t i, uint32_t end);

#endif
