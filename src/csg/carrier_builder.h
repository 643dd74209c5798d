/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_CARRIER_BUILDER_H
#define CSG_CSG_CARRIER_BUILDER_H

/* Carriers while they are found, leaf by leaf. For carrier.c and carrier_find.c. */

#include "csg/carrier.h"
#include "csg/carrier_index.h"
#include "csg/loners.h"
#include "csg/plane_table.h"
#include "csg/remote.h"
#include "mesh/surface.h"

/* Where a leaf is and how much its faces may be off. Of an unbounded leaf the finite part of the
 * scene is what matters; center is its own place. */
struct csg_leaf_extent {
    struct csg_vec3 center;
    double radius; /* infinite for an unbounded leaf */
    double reach;  /* the same, but finite */
    double rounding;
};

/* Leaves within a sixteenth of an octave in size count as equal: what follows goes through large
 * scenes in the order of their file then, and so of memory, most of the time. */
struct ranked_leaf {
    uint32_t size, leaf;
};

struct csg_carrier_builder {
    const struct csgcast_scene *scene;
    const struct csg_carriers_before *before; /* may be NULL */
    struct csg_carriers *carriers;
    CSG_ARRAY(double) plane_rounding; /* of the leaf each carrier came from */
    CSG_ARRAY(double) quadric_rounding;
    struct csg_carrier_index index;
    struct csg_plane_table planes; /* that were met */
    bool *wanted;               /* by leaf: it is in leaves */
    bool is_alone;              /* the only leaf: no face can coincide with another */
    struct csg_remote remote;   /* faces of surfaces that have no place in carriers->faces */
    struct csg_loners loners;   /* neither in the index nor in the table */
    double radius;              /* of the finite part of the scene */
    double largest_rounding;    /* of the leaves at hand */
    CSG_ARRAY(struct ranked_leaf) leaves; /* largest first */
};

/* All but the carriers. */
void csg_carrier_builder_finish(struct csg_carrier_builder *builder);

/* For the leaves that are wanted. false: out of memory. */
bool csg_carrier_start_index(struct csg_carrier_builder *builder);

/* The carrier of a plane: one that is there, or a new one. false: out of memory. */
bool csg_carrier_assign_plane(struct csg_carrier_builder *builder, const struct csg_plane *plane,
                              const struct csg_leaf_extent *extent, struct csg_face *face);

/* The faces with these extents, the largest first. NULL: out of memory. */
uint32_t *csg_carrier_rank_faces(const struct csg_surface_extent *extents, size_t num);
struct csg_leaf_extent csg_carrier_face_extent(const struct csg_surface_extent *extent,
                                               double rounding);

struct csg_leaf_extent csg_leaf_extent_of(const struct csg_carrier_builder *builder, uint32_t leaf);

/* How far a face of the leaf may be off one that has that rounding and coincides with it. */
double csg_carrier_tolerance(const struct csg_leaf_extent *extent, double other_rounding);

/* The carrier that the plane, or the leaf's quadric, lies on; false: there is none. */
bool csg_carrier_find_plane(const struct csg_carrier_builder *builder,
                            const struct csg_plane *plane, const struct csg_leaf_extent *extent,
                            struct csg_face *face);
bool csg_carrier_find_quadric(const struct csg_carrier_builder *builder, uint32_t leaf,
                              const struct csg_leaf_extent *extent, struct csg_face *face);

#endif
