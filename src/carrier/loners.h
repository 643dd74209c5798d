/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_LONERS_H
#define CSG_CARRIER_LONERS_H

/*
 * Loners: faces of large scenes that no other face comes near, so that nobody needs to look for
 * what they coincide with, nor to find them. In most scenes of a million solids nearly all are.
 */

#include "csg/scene.h"

/* All NULL: no face is known to be one. */
struct csg_loners {
    uint8_t *planes;   /* by face, in the order of csg_carriers.faces; NULL: none is */
    uint8_t *quadrics; /* by leaf */
};

struct csg_carrier_builder;

/*
 * Of the builder's leaves; its index is started, and nothing in it. A face is a loner where no
 * other one is in a cell that is looked at for it. The order of the faces does not matter. false:
 * out of memory.
 */
bool csg_loners_find(struct csg_loners *loners, const struct csg_carrier_builder *builder);
void csg_loners_finish(struct csg_loners *loners);

#endif
