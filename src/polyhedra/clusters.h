/* SPDX-License-Identifier: MIT */
#ifndef CSG_POLYHEDRA_CLUSTERS_H
#define CSG_POLYHEDRA_CLUSTERS_H

/* Convex sets, each by its corners. */

#include "polyhedra/cell.h"
#include "polyhedra/hull.h"

/* Zero-initialise it. */
struct csg_clusters {
    struct csg_points corners;
    CSG_ARRAY(size_t) ends; /* of each set's corners */
};

void csg_clusters_finish(struct csg_clusters *clusters);

/* Adds the corners of a cell as a set, each once, without points on its edges. What is nearer than
 * near coincides. false: out of memory. */
bool csg_clusters_add_cell(struct csg_clusters *clusters, const struct csg_cell *cell, double near);

/* Adds the sum of two sets, each given by some of its points, the corners among them. false: out of
 * memory. */
bool csg_clusters_add_sum(struct csg_clusters *clusters, const struct csg_vec3 *a, size_t num_a,
                          const struct csg_vec3 *b, size_t num_b);

/* Adds the sets of another list. false: out of memory. */
bool csg_clusters_append(struct csg_clusters *clusters, const struct csg_clusters *other);

#endif
