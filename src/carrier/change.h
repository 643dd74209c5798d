/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_CHANGE_H
#define CSG_CARRIER_CHANGE_H

/* An edit of carriers on its way. For edit.c, exchange.c, concern.c and settle.c. */

#include "carrier/builder.h"
#include "carrier/edit.h"

/* A face that gets its carrier anew. */
struct csg_carrier_item {
    struct csg_rank rank; /* of a quadric: face 0 */
    bool was_first;       /* before the edit a carrier came from it, which has not changed */
};

/* A carrier whose faces may lie on a new one, which comes before it. */
struct csg_carrier_suspect {
    uint32_t carrier, created;
    uint32_t next; /* of the same carrier, as in suspected */
};

/* Of one kind of faces. */
struct csg_carrier_work {
    CSG_ARRAY(struct csg_carrier_item) items;
    CSG_ARRAY(uint32_t) affected; /* carriers whose faces are still to become items */
    CSG_ARRAY(uint32_t) created;  /* by the pass at hand */
    CSG_ARRAY(struct csg_carrier_suspect) suspects; /* of the pass at hand */
    uint32_t *suspected; /* by carrier, from 1: its first one in suspects; 0: there is none */
    uint32_t last;       /* of the carriers that were there the one of the last rank, or none */
    uint8_t *marks;      /* by carrier: it is affected */
    size_t num_marks;
};

/* A surface that has changed, or to which what has changed is, or was, near. */
struct csg_met_surface {
    uint32_t leaf;
    uint8_t *near;                   /* as in csg_remote, now */
    struct csg_placed_faces *placed; /* NULL: there are none, or the builder's */
};

struct csg_carrier_change {
    struct csg_carrier_builder *builder;
    const struct csgcast_scene *scene;
    struct csg_carriers *carriers;
    const struct csg_before *before;
    bool *wanted; /* by leaf, after the edit */
    bool is_same; /* leaves neither come nor go, and have as many faces */
    CSG_ARRAY(struct csg_met_surface) met;
    bool is_near_put; /* what is near now is the builder's */
    struct csg_carrier_work work[CSG_NUM_FACE_KINDS];
};

static inline const struct csg_rank *csg_rank_of(const struct csg_carrier_change *change,
                                                 enum csg_face_kind kind, uint32_t carrier)
{
    return &change->builder->lists[kind].ranks.data[carrier];
}

static inline struct csg_plane csg_plane_of(const struct csg_carrier_change *change,
                                            const struct csg_rank *rank)
{
    return csg_carrier_plane(change->builder, &change->scene->leaves[rank->leaf].shape, rank);
}

static inline struct csg_face *csg_face_of(const struct csg_carrier_change *change,
                                           enum csg_face_kind kind, const struct csg_rank *rank)
{
    const struct csg_carriers *carriers = change->carriers;
    if (kind == CSG_QUADRIC)
        return &carriers->quadric_faces[rank->leaf];
    return &carriers
                ->faces[carriers->face_begin[rank->leaf] + csg_carrier_face(change->builder, rank)];
}

/* How many ranks faces of a leaf may have that is there now; those of a surface that are all remote
 * have none. */
static inline uint32_t csg_num_ranks(const struct csg_carrier_builder *builder, uint32_t leaf)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    if (!shape->surface)
        return shape->num_planes;
    return builder->remote.near[leaf] ? (uint32_t)shape->surface->planes.num : 0;
}

/* Whether the leaf has changed, comes or goes. */
static inline bool csg_is_touched(const struct csg_carrier_change *change, uint32_t leaf)
{
    return change->before->changed[leaf] || change->wanted[leaf] != change->builder->wanted[leaf];
}

/* The leaf as it was. */
static inline const struct csg_shape *csg_shape_before(const struct csg_carrier_change *change,
                                                       uint32_t leaf)
{
    const uint32_t place = change->before->changed[leaf];
    return place ? change->before->shapes[place - 1] : &change->scene->leaves[leaf].shape;
}

/* Fills met. false: out of memory. */
bool csg_carrier_meet_surfaces(struct csg_carrier_change *change);

/* Whether the index has room for the faces of surfaces that have come near, and what was far from
 * all others still is. */
bool csg_carrier_has_room_for_met(const struct csg_carrier_change *change);

/* The builder gets what is near now, and then where the faces are now. */
void csg_carrier_put_near(struct csg_carrier_change *change);
void csg_carrier_put_placed(struct csg_carrier_change *change);

/* The carrier's faces are to be found anew. false: out of memory. */
bool csg_carrier_affect(struct csg_carrier_change *change, enum csg_face_kind kind,
                        uint32_t carrier);

/* Takes the leaves that are touched out and puts them in as they are now. */
bool csg_carrier_exchange(struct csg_carrier_change *change);

/* Before carriers are made: which of those that are there comes last. */
void csg_carrier_find_last(struct csg_carrier_change *change, enum csg_face_kind kind);

/* Carriers whose faces may lie on a new one are affected, or suspects. Then all faces of suspects
 * are asked, which may leave few of them. false: out of memory. */
bool csg_carrier_concern(struct csg_carrier_change *change, enum csg_face_kind kind,
                         uint32_t created);
bool csg_carrier_confirm(struct csg_carrier_change *change, enum csg_face_kind kind);

/* Gives the items and the faces of affected carriers their carriers. */
bool csg_carrier_settle(struct csg_carrier_change *change, enum csg_face_kind kind);

#endif
