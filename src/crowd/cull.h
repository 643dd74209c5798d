/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_CULL_H
#define CSG_CROWD_CULL_H

/*
 * Which members of a crowd can show in this view. Left out, exactly: what is outside of it, what
 * covers no pixel's centre, and what is hidden at each of them by nearer members.
 */

#include "common/array.h"
#include "crowd/crowd.h"
#include "pack/screen.h"

/* Tasks of the parallel passes take as many members. */
#define CSG_CROWD_BLOCK 2048

/* A member that may show. */
struct csg_candidate {
    uint32_t member;
    int16_t lo[2], hi[2]; /* the pixels that it can cover, both ends included; y upwards */
    float key;            /* nothing of it is nearer */
};

/* A run of members of one class, and what is left of it. */
struct csg_crowd_block {
    uint32_t class;
    uint32_t begin, end; /* members; its candidates start at begin */
    uint32_t num;        /* candidates */
};

struct csg_cull {
    const struct csgcast_scene *scene;
    const struct csg_crowd *crowd;
    const struct csg_screen *screen;
    struct csg_pixel at;
    bool all_in_float;                /* no member needs better keys in this view */
    CSG_ARRAY(struct csg_crowd_block) blocks;
    struct csg_candidate *candidates; /* one a member */
    uint8_t *demoted;                 /* per member: drawn as other objects are */
    float *keys;                      /* per pixel: what is farther is hidden */
    struct csg_candidate *occluders;  /* those that hide others, roughly the nearest first */
    size_t num_occluders;
};

/* false: out of memory. */
bool csg_cull_run(struct csg_cull *cull);
void csg_cull_finish(struct csg_cull *cull);

#endif
