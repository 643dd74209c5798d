/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_PICTURE_H
#define CSG_RENDER_PICTURE_H

#include "render/renderer.h"

/* A picture in the making: what its passes, its readback and its statistics share. */
struct csg_picture {
    struct csgcast_renderer *renderer;
    struct csg_gl *gl;
    const struct csg_request *request;
    struct csg_batches batches;
    GLuint shade;
    int first_row, num_rows; /* of the strip, counted from the bottom */
    bool want_geometry, want_leaf;
    bool bytes; /* colours go to the caller as they are drawn, and nothing else */
    /* Of all draws: lo x, lo y, hi x, hi y in clip space of the whole picture. Where these are
     * drawn directly it is not set. */
    float rect[4];
    uint32_t *visible; /* the strip's geometry buffer; NULL where no program can give up */
};

static inline bool csg_batch_is_opaque(const struct csg_batch *batch)
{
    return !batch->translucent && batch->paint == CSG_LAYER_MODEL;
}

/* Binds what a frame's programs read. */
void csg_picture_bind_textures(const struct csg_picture *picture);

/* Draws the strip into the targets. */
void csg_passes_draw_strip(const struct csg_picture *picture);

/* A round without objects, for what a driver makes when it first draws. */
void csg_passes_draw_nothing(const struct csg_picture *picture);

/* Copies the strip that has been drawn to the caller's buffers. pixels: room for four floats a
 * pixel of csg_picture_rows_at_once rows; NULL where only bytes are asked for. */
int csg_picture_rows_at_once(const struct csg_picture *picture);
void csg_picture_read_strip(const struct csg_picture *picture, float *pixels);

/* What the picture took, into the renderer's statistics. */
void csg_picture_count(const struct csg_picture *picture);

#endif
