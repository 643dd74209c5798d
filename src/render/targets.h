/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_TARGETS_H
#define CSG_RENDER_TARGETS_H

/* The textures a frame is drawn into and read back from. */

#include "gl/context.h"

struct csg_targets {
    int width, height; /* of one band */
    GLuint geometry_fbo;
    GLuint shade_fbo; /* 0: not asked for yet, as bytes_fbo */
    GLuint bytes_fbo;
    GLuint visible;  /* RG32UI: what shaders/passes/geometry.frag.glsl writes */
    GLuint depth;
    GLuint color, geometry, leaf; /* RGBA32F; normal and distance RGBA32F; leaf index R32F */
    GLuint bytes;                 /* RGBA8: colour alone */
};

/* (Re)allocates for bands of that size, to be shaded as bytes or as floats. false, with a message,
 * when the driver refuses. */
bool csg_targets_resize(struct csg_targets *targets, struct csg_gl *gl, int width, int height,
                        bool bytes);
void csg_targets_finish(struct csg_targets *targets, struct csg_gl *gl);

#endif
