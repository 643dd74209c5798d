/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_CHOOSER_H
#define CSG_RENDER_CHOOSER_H

/* Which program draws what: the cheapest right one, see docs/pipeline.md#variants. One per frame.
 */

#include "render/renderer.h"

/* What was chosen for a draw. */
struct csg_choice {
    GLuint program, rear; /* rear: of the far side, 0: it does not show */
    enum csg_resolver resolver;
    int features; /* enum csg_feature: what these programs may have loops for */
    bool point;   /* drawn as a point */
    bool placed;  /* it has its batch */
};

struct csg_chooser;

/* Flat inputs that programs may take for an object's texels. */
size_t csg_max_handed(struct csg_gl *gl);

/* NULL: out of memory. */
struct csg_chooser *csg_chooser_create(struct csgcast_renderer *renderer,
                                       const struct csg_request *request, bool direct);
void csg_chooser_destroy(struct csg_chooser *chooser);

/* Of scenes that are edited: compiles what an edit may ask for, in frames that are not the first
 * after one. false, with a message: that failed. */
bool csg_chooser_prepare(struct csg_chooser *chooser);

/* In the frame after an edit: whether there are programs for its crowds and cells. If not, params
 * become those of a frame in which that is drawn as other objects are, for which there are. */
bool csg_chooser_make_do(const struct csg_chooser *chooser, struct csg_frame_params *params);

/* false, with a message: a program does not compile. */
bool csg_chooser_choose(struct csg_chooser *chooser, const struct csg_draw *draw,
                        struct csg_choice *choice);

#endif
