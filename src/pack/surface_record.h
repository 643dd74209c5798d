/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_SURFACE_RECORD_H
#define CSG_PACK_SURFACE_RECORD_H

#include "pack/terms.h"

/*
 * Appends the record of a leaf that is a surface to the frame, for the pixels [lo, hi) of the
 * picture: layout in shaders/common/layout.glsl. false: out of memory.
 */
bool csg_surface_add_record(struct csg_terms *terms, const struct csg_step *step, const int lo[2],
                            const int hi[2]);

#endif
