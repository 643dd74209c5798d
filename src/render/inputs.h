/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_INPUTS_H
#define CSG_RENDER_INPUTS_H

/* What the programs of a picture read: its uniforms, and the attributes of a batch's instances. */

#include "render/picture.h"

/* Uses the program, with the screen, the light and the textures of the picture. */
void csg_inputs_set(const struct csg_picture *picture, GLuint program);

/* The same for a geometry program, once a round: many batches share one. paint: the layer; where
 * it repeats surfaces of those before it, it shall win. */
void csg_inputs_use(const struct csg_picture *picture, GLuint program, uint8_t paint);

/* Once the renderer's buffers and arrays are there. */
void csg_inputs_prepare(const struct csgcast_renderer *renderer);

/* Draws the batch's instances with the program in use. */
void csg_inputs_draw(const struct csg_picture *picture, const struct csg_batch *batch);

#endif
