/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_CULL_H
#define CSG_CROWD_CULL_H

/*
 * Which members of a crowd can show in this view. Left out, exactly: what is outside of it, what
 * covers no pixel's centre, and what is hidden at each of them by nearer members. Of the others the
 * pixels are known at which they may show.
 */

#include <stdatomic.h>

#include "common/array.h"
#include "crowd/member.h"
#include "crowd/relief.h"

/* Tasks of the parallel passes take as many members. */
#define CSG_CROWD_BLOCK 2048

/* A member that may show; in the end an opaque one. */
struct csg_candidate {
    uint32_t member;
    int16_t lo[2], hi[2]; /* the pixels where it may show, both ends included; y upwards */
    float key;            /* nothing of it is nearer */
    uint16_t class;
    bool by_rect; /* it is drawn there by itself */
    bool owns;    /* it is drawn where it owns pixels, see crowd/owners.h */
};

static inline struct csg_pixels csg_candidate_pixels(const struct csg_candidate *candidate)
{
    return (struct csg_pixels){{candidate->lo[0], candidate->lo[1]},
                               {candidate->hi[0], candidate->hi[1]}};
}

static inline size_t csg_candidate_num_pixels(const struct csg_candidate *candidate)
{
    const struct csg_pixels pixels = csg_candidate_pixels(candidate);
    return csg_count_pixels(&pixels);
}

/* A run of members of one class, and what is left of it. */
struct csg_crowd_block {
    uint32_t class;
    uint32_t begin, end;  /* members; its candidates start at begin */
    uint32_t num;         /* candidates */
    float lo_key, hi_key; /* of theirs; infinite where there are none */
};

/* Where the terms of a member are in csg_cull.terms: from CSG_TERMS_FIRST on, which is the place of
 * those of its class that were found first. */
enum { CSG_TERMS_UNKNOWN, CSG_TERMS_STIFF, CSG_TERMS_FIRST };

struct csg_cull {
    struct csg_crowd_view view;
    bool all_in_float; /* no member needs better keys in this view */
    CSG_ARRAY(struct csg_crowd_block) blocks;
    struct csg_candidate *candidates; /* one a member */
    uint8_t *demoted;                 /* per member: drawn as other objects are */
    bool has_relief;
    struct csg_relief relief; /* where has_relief: of the opaque members */
    uint32_t without;         /* classes, as in csg_frame_params, that are demoted */
    size_t max_owners;        /* pixels that a picture of owners may have; 0: there is none */
    struct csg_owners owners; /* the relief's, if it has any, */
    struct csg_owned owned;   /* ... and where they are */
    bool together;            /* so many translucent members that only their nearest sides show */
    atomic_bool *drawn; /* per member: some pixel may show it, as far as those before it tell; with
                           owners: some pixel that it cannot own */
    float *terms;       /* of csg_member_terms, of the members that had to be cast */
    uint32_t *places;   /* of theirs, per member */
    size_t terms_at[CSG_CROWD_MAX_CLASSES];       /* a class's */
    atomic_uint num_terms[CSG_CROWD_MAX_CLASSES]; /* members of a class that have a place */
};

/* A member's terms, found if they are not known yet: only one thread may ask for a member at a
 * time. NULL: stiff. */
const float *csg_cull_terms(struct csg_cull *cull, uint32_t class, uint32_t member);

/* false: out of memory. */
bool csg_cull_run(struct csg_cull *cull);
void csg_cull_finish(struct csg_cull *cull);

#endif
