/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_CANVAS_H
#define CSG_CLI_CANVAS_H

/* A picture with pictures, bars and labels on it. */

#include <stdbool.h>

struct csg_color {
    float r, g, b;
};

struct csg_canvas {
    int width, height;
    float *rgba; /* row 0 on top; owned */
};

/* Filled with one colour. false: out of memory. */
bool csg_canvas_init(struct csg_canvas *canvas, int width, int height, struct csg_color color);
void csg_canvas_finish(struct csg_canvas *canvas);

/* What is outside of the canvas is left out. */
void csg_canvas_set(struct csg_canvas *canvas, int x, int y, struct csg_color color);
void csg_canvas_fill(struct csg_canvas *canvas, int x, int y, int width, int height,
                     struct csg_color color);

/* ASCII of 6 x 8 pixels a character; (x, y) is its top left corner. Other bytes are drawn as
 * question marks. */
void csg_canvas_text(struct csg_canvas *canvas, int x, int y, struct csg_color color,
                     const char *text);
#define CSG_CANVAS_CHARACTER 6

#endif
