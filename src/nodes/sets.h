/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_SETS_H
#define CSG_NODES_SETS_H

/* Solids as unions of convex sets and surfaces of triangles: what hull and minkowski work on. */

#include "nodes/parts.h"
#include "polyhedra/evaluate.h"

/* Zero-initialise it. */
struct csg_sets {
    struct csg_clusters convex;
    CSG_ARRAY(struct csg_shape) surfaces; /* owned */
    double rounding;                      /* of the worst of the solids */
    bool facetted, has_flat;              /* one of them was */
};

void csg_sets_finish(struct csg_sets *sets);

/* Adds those of the solids at [begin, end), for node. is_there: nothing was reported. false, with a
 * message, when memory is out. */
bool csg_sets_read(struct csg_walk *walk, uint32_t node, uint32_t begin, uint32_t end,
                   bool in_boolean, enum csg_part_wanted wanted, struct csg_sets *sets,
                   bool *is_there);

/* Moves the surfaces over that nothing cuts; nothing is left of them there. false: out of memory.
 */
bool csg_sets_take_surfaces(struct csg_sets *sets, struct csg_part *part);

/* Adds the sum S + C of a surface and of a convex set by its corners: (S + c) u (dS + C), c one of
 * them. A point of S + C that is not in S + c is reached from c on a way within C, on which it
 * leaves S. false: out of memory. */
bool csg_sets_add_sum(struct csg_sets *sets, const struct csg_shape *surface,
                      const struct csg_vec3 *corners, size_t num);

/* Adds the hull of points that come from sets; one without volume adds nothing. */
bool csg_sets_add_hull(struct csg_walk *walk, uint32_t node, const struct csg_sets *sets,
                       const struct csg_points *points, struct csg_part *part);

#endif
