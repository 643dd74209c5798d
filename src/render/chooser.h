/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_CHOOSER_H
#define CSG_RENDER_CHOOSER_H

/* Which program draws what: the cheapest right one, see docs/pipeline.md#variants. One per frame.
 */

#include "render/renderer.h"

/* A draw with what was chosen for it. */
struct csg_choice {
    struct csg_draw draw;
    GLuint program, rear; /* rear: of the far side, 0: it does not show */
    enum csg_resolver resolver;
    bool point;  /* drawn as a point */
    bool placed; /* it has its batch */
};

struct csg_chooser;

/* NULL: out of memory. */
struct csg_chooser *csg_chooser_create(struct csgcast_renderer *renderer,
                                       const struct csg_request *request, bool direct);
void csg_chooser_destroy(struct csg_chooser *chooser);

/* Of scenes that are edited: compiles what an edit may ask for. false, with a message: that failed.
 */
bool csg_chooser_prepare(struct csg_chooser *chooser);

/* The same for objects in a crowd, after the frame's draws have their programs. */
bool csg_chooser_prepare_spared(struct csg_chooser *chooser);

/* false, with a message: a program does not compile. */
bool csg_chooser_choose(struct csg_chooser *chooser, const struct csg_draw *draw,
                        struct csg_choice *choice);

#endif
