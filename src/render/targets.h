/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_TARGETS_H
#define CSG_RENDER_TARGETS_H

/* The textures a frame is drawn into and read back from. */

#include "gl/context.h"

struct csg_targets {
    int width, height;                         /* of one strip */
    GLuint geometry_fbo, shade_fbo, bytes_fbo; /* 0: not asked for yet, as all textures */
    GLuint visible; /* RG32UI: what shaders/passes/geometry.frag.glsl writes */
    GLuint depth;
    GLuint color, geometry, leaf; /* RGBA32F; normal and distance RGBA32F; leaf index R32F */
    GLuint bytes;                 /* RGBA8: colour alone */
};

/* What a picture is drawn into; memory that nobody touches takes time as well. */
struct csg_targets_use {
    bool direct;         /* without a geometry pass */
    bool bytes;          /* colours as bytes; else as floats */
    bool geometry, leaf; /* as well */
};

/* (Re)allocates for strips of that size. What is there already stays. false, with a message, when
 * the driver refuses. */
bool csg_targets_resize(struct csg_targets *targets, struct csg_gl *gl, int width, int height,
                        const struct csg_targets_use *use);
void csg_targets_finish(struct csg_targets *targets, struct csg_gl *gl);

#endif
