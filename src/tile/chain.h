/* SPDX-License-Identifier: MIT */
#ifndef CSG_TILE_CHAIN_H
#define CSG_TILE_CHAIN_H

/* Whether a tile's records are a chain, record by record: see shaders/csg/chain.glsl. */

#include "csg/program.h"
#include "pack/frame.h"

struct csg_chain_finder {
    bool faceted;               /* there may be a program for many planes */
    struct csg_chain_need need; /* slots: of the records so far */
    uint64_t rank;              /* of the last one */
    bool broken;                /* they are none */
};

/* head: the record that was made of the step. */
void csg_chain_add(struct csg_chain_finder *finder, const struct csg_step *step, const float *head);

/* What they need, when all are there. */
struct csg_chain_need csg_chain_end(const struct csg_chain_finder *finder);

#endif
