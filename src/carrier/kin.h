/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_KIN_H
#define CSG_CARRIER_KIN_H

/* Whether edits concern kin, see crowd/kin.h. For follow.c. */

#include "carrier/carrier.h"
#include "csg/object.h"

/* Whether a leaf of these objects that has changed has a carrier in common with another object.
 * changed: by leaf, not 0. The carriers are kept ones. false: out of memory. */
bool csg_carrier_find_kin(const struct csgcast_scene *scene, const struct csg_carriers *carriers,
                          const uint32_t *changed, const uint32_t *objects, size_t num,
                          bool *found);

#endif
