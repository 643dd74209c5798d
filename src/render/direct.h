/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_DIRECT_H
#define CSG_RENDER_DIRECT_H

/*
 * Whether a frame can do without the shading pass: its geometry programs then write colours. That
 * takes bytes, nothing that is blended, and about one fragment a pixel.
 */

#include "render/renderer.h"

bool csg_draws_directly(struct csgcast_renderer *renderer, const struct csg_request *request);

/* Whether no two draws can cover the same pixel: tiles of one object, or a single draw. */
bool csg_is_disjoint(const struct csg_frame *frame);

/* The rectangle around all draws: lo x, lo y, hi x, hi y in clip space; empty without any. */
void csg_bound_draws(const struct csg_frame *frame, float rect[4]);

/* Of one object's, which is none of a crowd; CSG_ANY_OBJECT: of all but crowds. */
#define CSG_ANY_OBJECT (UINT32_MAX - 1)
void csg_bound_object(const struct csg_frame *frame, uint32_t object, float rect[4]);

#endif
