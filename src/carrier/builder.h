/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_BUILDER_H
#define CSG_CARRIER_BUILDER_H

/*
 * Carriers while they are found, leaf by leaf. For this folder:
 *   survey.c   where a scene's faces are looked up, and how far those that coincide may differ,
 *   rank.c     in which order faces get their carriers,
 *   find.c     which carrier a face lies on,
 *   assign.c   gives it that one, or a new one; surface.c does so for surfaces of triangles,
 *   carrier.c  all of that; edit.c and what it includes, the same after an edit.
 */

#include "carrier/carrier.h"
#include "carrier/loners.h"
#include "carrier/plane_table.h"
#include "carrier/probe.h"
#include "carrier/remote.h"
#include "mesh/surface.h"

/* Where a leaf is and how much its faces may be off. Of an unbounded leaf the finite part of the
 * scene is what matters; center is its own place. */
struct csg_leaf_extent {
    struct csg_vec3 center;
    double radius; /* infinite for an unbounded leaf */
    double reach;  /* the same, but finite */
    double rounding;
};

/*
 * The order in which faces get their carriers: the largest leaf's first, of the earlier leaf, in
 * its own order. A face lies on the first carrier that it may lie on, and only one before itself.
 * Leaves within a sixteenth of an octave in size count as equal: what follows goes through large
 * scenes in the order of their file then, and so of memory, most of the time.
 */
struct csg_rank {
    uint32_t size, leaf, face;
};

static inline int csg_rank_compare(const struct csg_rank *a, const struct csg_rank *b)
{
    if (a->size != b->size)
        return a->size > b->size ? -1 : 1;
    if (a->leaf != b->leaf)
        return a->leaf < b->leaf ? -1 : 1;
    return a->face < b->face ? -1 : a->face > b->face;
}

/* Of faces and carriers. */
enum csg_face_kind { CSG_PLANE, CSG_QUADRIC, CSG_NUM_FACE_KINDS };

/* The faces of a surface in its place: where each is, and which of them has which rank. */
struct csg_placed_faces {
    struct csg_surface_extent *extents;
    uint32_t *order;        /* the largest first */
    struct csg_map inverse; /* of the place */
};

/* What is known of each carrier of one kind. */
struct csg_carrier_list {
    CSG_ARRAY(double) rounding; /* of the leaf that it came from */
    /* Where it keeps; otherwise carriers are in the order of their ranks. */
    CSG_ARRAY(struct csg_rank) ranks; /* of the face that it came from */
    CSG_ARRAY(uint32_t) uses;         /* faces on it */
    CSG_ARRAY(uint32_t) free;         /* carriers that edits have left without faces */
};

struct csg_carrier_builder {
    const struct csgcast_scene *scene;
    struct csg_carriers *carriers;
    bool keeps;    /* for edits to follow, see carrier/edit.h */
    bool has_room; /* the index has room for them, and no face is left out as a loner */
    struct csg_carrier_list lists[CSG_NUM_FACE_KINDS];
    struct csg_carrier_index index;
    struct csg_plane_table others; /* planes that were met and are no carrier's own */
    bool *wanted;                  /* by leaf: it is in leaves */
    bool is_alone;                 /* the only leaf: no face can coincide with another */
    struct csg_remote remote;      /* faces of surfaces that have no place in carriers->faces */
    /* By leaf: of surfaces that have faces which are not remote, in scenes that have surfaces. */
    struct csg_placed_faces **placed;
    struct csg_loners loners;          /* neither in the index nor in the table */
    struct csg_vec3 center;            /* of the finite part of the scene */
    double radius;                     /* the same; where it has room, with that */
    double largest_rounding;           /* of the leaves at hand */
    double most_rounding;              /* ... and where it has room, of those that may come */
    struct csg_carrier_reach reach;    /* of the index */
    CSG_ARRAY(struct csg_rank) leaves; /* in their order */
};

/* All but the carriers. */
void csg_carrier_builder_finish(struct csg_carrier_builder *builder);
void csg_carrier_builder_destroy(struct csg_carrier_builder *builder);

/* Room for the faces of all leaves; none has a carrier. false: out of memory. */
bool csg_carriers_allocate_faces(struct csg_carrier_builder *builder);

/* Marks the leaves that get carriers: those that objects use. A leaf can be in two layers. */
void csg_carrier_mark_wanted(const struct csgcast_scene *scene, bool *wanted);

/* Fills leaves, in the order of their ranks, and wanted. false: out of memory. */
bool csg_carrier_rank_leaves(struct csg_carrier_builder *builder);

/* For the leaves that are wanted: first their center, radius and roundings; then, with what is
 * remote of their surfaces, the index. false: out of memory. */
bool csg_carrier_outline(struct csg_carrier_builder *builder);
bool csg_carrier_start_index(struct csg_carrier_builder *builder);

/* Where edits follow, the index is made for a scene so many times larger, and rounded so much more
 * coarsely: most edits stay within that. */
#define CSG_CARRIER_ROOM 2.0

/* Whether the leaf is of those whose edits can be followed, and whether the index has room for
 * it. The faces of a surface are asked one by one, once it is known which of them are near. */
bool csg_carrier_can_follow(const struct csg_carrier_builder *builder, uint32_t leaf);
bool csg_carrier_has_room(const struct csg_carrier_builder *builder, uint32_t leaf);
bool csg_carrier_can_follow_faces(const struct csg_placed_faces *placed, const uint8_t *near,
                                  const struct csg_shape *shape);
bool csg_carrier_has_room_for_faces(const struct csg_carrier_builder *builder,
                                    const struct csg_placed_faces *placed, const uint8_t *near,
                                    const struct csg_shape *shape);

/* What can be seen of each quadric. false: out of memory. */
bool csg_carriers_fill_boxes(const struct csgcast_scene *scene, struct csg_carriers *carriers);

/* The carrier of a plane: one that is there, or a new one. rank: the face's; NULL where the builder
 * does not keep. alone: nothing can coincide with it. false: out of memory. */
bool csg_carrier_assign_plane(struct csg_carrier_builder *builder, const struct csg_plane *plane,
                              const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                              bool alone, struct csg_face *face);

/* The same for the leaf's quadric, the face in builder->carriers and its sheet. */
bool csg_carrier_assign_quadric(struct csg_carrier_builder *builder, uint32_t leaf,
                                const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                                bool alone);

/* The same for all faces of a leaf that is a surface, and of any leaf. */
bool csg_carrier_assign_surface(struct csg_carrier_builder *builder, const struct csg_rank *rank);
bool csg_carrier_assign_leaf(struct csg_carrier_builder *builder, const struct csg_rank *rank);

/* Whether the builder knows that nothing can coincide with a plane, by its place in faces[]. */
static inline bool csg_is_lone_plane(const struct csg_carrier_builder *builder, size_t face)
{
    return builder->is_alone || (builder->loners.planes && builder->loners.planes[face]);
}

/* Of a leaf's faces. */
struct csg_rank csg_carrier_rank(const struct csg_carrier_builder *builder, uint32_t leaf,
                                 uint32_t face);

/* The surface's. NULL: out of memory. */
struct csg_placed_faces *csg_placed_faces_create(const struct csg_shape *shape);
void csg_placed_faces_destroy(struct csg_placed_faces *placed);

/* Of a leaf, whose shape is given, the face of that rank: its number among the leaf's, its plane
 * and, of the leaf as it is now, how large it is. */
uint32_t csg_carrier_face(const struct csg_carrier_builder *builder, const struct csg_rank *rank);
struct csg_plane csg_carrier_plane(const struct csg_carrier_builder *builder,
                                   const struct csg_shape *shape, const struct csg_rank *rank);
struct csg_leaf_extent csg_carrier_extent(const struct csg_carrier_builder *builder,
                                          const struct csg_rank *rank);

/* Adds to the carriers' counts the faces of a surface that have none. */
void csg_carrier_count_own(const struct csg_carrier_builder *builder, uint32_t leaf);

/* The faces with these extents, the largest first. NULL: out of memory. */
uint32_t *csg_carrier_rank_faces(const struct csg_surface_extent *extents, size_t num);
struct csg_leaf_extent csg_carrier_face_extent(const struct csg_surface_extent *extent,
                                               double rounding);

struct csg_leaf_extent csg_leaf_extent_of(const struct csg_carrier_builder *builder, uint32_t leaf);

/* How far a face of the leaf may be off one that has that rounding and coincides with it. */
double csg_carrier_tolerance(const struct csg_leaf_extent *extent, double other_rounding);

/* How far a plane that has that rounding, and coincides with a face of that extent, may differ from
 * it. */
struct csg_carrier_spread csg_carrier_spread_of(const struct csg_carrier_builder *builder,
                                                const struct csg_leaf_extent *extent,
                                                double other_rounding);

/* The carrier that a face on the very same plane got; false: there was none. */
bool csg_carrier_find_met(const struct csg_carrier_builder *builder, const struct csg_plane *plane,
                          struct csg_face *face);

/* Whether a face with that plane may lie on a carrier of planes. */
bool csg_carrier_may_take(const struct csg_carrier_builder *builder, uint32_t carrier,
                          const struct csg_plane *plane, const struct csg_leaf_extent *extent);

/* The carrier that the plane, or the leaf's quadric, lies on: of all that are within the tolerance
 * the first, which does not depend on how they are looked for; false: there is none. */
bool csg_carrier_find_plane(const struct csg_carrier_builder *builder,
                            const struct csg_plane *plane, const struct csg_leaf_extent *extent,
                            const struct csg_rank *rank, struct csg_face *face);
bool csg_carrier_find_quadric(const struct csg_carrier_builder *builder, uint32_t leaf,
                              const struct csg_leaf_extent *extent, const struct csg_rank *rank,
                              struct csg_face *face);

#endif
