/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_CARRIER_CHANGE_H
#define CSG_CSG_CARRIER_CHANGE_H

/* An edit of carriers on its way. For carrier_edit.c, carrier_exchange.c and carrier_settle.c. */

#include "csg/carrier_builder.h"
#include "csg/carrier_edit.h"

/* A face that gets its carrier anew. */
struct csg_carrier_item {
    struct csg_rank rank; /* of a quadric: face 0 */
    bool was_first;       /* before the edit a carrier came from it, which has not changed */
};

/* Of one kind of faces. */
struct csg_carrier_work {
    CSG_ARRAY(struct csg_carrier_item) items;
    CSG_ARRAY(uint32_t) affected; /* carriers whose faces are still to become items */
    CSG_ARRAY(uint32_t) created;  /* by the pass at hand */
    uint8_t *marks;               /* by carrier: it is affected */
    size_t num_marks;
};

struct csg_carrier_change {
    struct csg_carrier_builder *builder;
    const struct csgcast_scene *scene;
    struct csg_carriers *carriers;
    const struct csg_before *before;
    bool *wanted; /* by leaf, after the edit */
    struct csg_carrier_work work[CSG_NUM_FACE_KINDS];
};

static inline const struct csg_rank *csg_rank_of(const struct csg_carrier_change *change,
                                                 enum csg_face_kind kind, uint32_t carrier)
{
    return &change->builder->lists[kind].ranks.data[carrier];
}

static inline const struct csg_plane *csg_plane_of(const struct csg_carrier_change *change,
                                                   const struct csg_rank *rank)
{
    return &change->scene->leaves[rank->leaf].shape.planes[rank->face];
}

/* Whether the leaf has changed, comes or goes. */
static inline bool csg_is_touched(const struct csg_carrier_change *change, uint32_t leaf)
{
    return change->before->changed[leaf] || change->wanted[leaf] != change->builder->wanted[leaf];
}

/* The carrier's faces are to be found anew. false: out of memory. */
bool csg_carrier_affect(struct csg_carrier_change *change, enum csg_face_kind kind,
                        uint32_t carrier);

/* Takes the leaves that are touched out and puts them in as they are now. */
bool csg_carrier_exchange(struct csg_carrier_change *change);

/* Gives the items and the faces of affected carriers their carriers. */
bool csg_carrier_settle(struct csg_carrier_change *change, enum csg_face_kind kind);

#endif
