/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_TURNS_H
#define CSG_RENDER_TURNS_H

/* How long loop programs can run over a draw's records, see shaders/csg/turns.glsl. */

#include "pack/frame.h"

struct csg_turns {
    double look;  /* turns of all loops in one look at the records, at most */
    double looks; /* a ray cannot stop more often than it has crossings */
};

/* features: enum csg_feature, that its program may have. */
struct csg_turns csg_turns_of(const struct csg_frame *frame, const struct csg_draw *draw,
                              int features);

/* Whether some pixel may run out of turns; turns: the draw's. */
bool csg_may_give_up(const struct csg_draw *draw, const struct csg_turns *turns);

#endif
