/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_TEXTBOOK_H
#define CSG_PACK_TEXTBOOK_H

/*
 * Carriers as a textbook has them, for the variant "textbook" (shaders/solids/textbook.glsl):
 * coefficients in world space, rounded to float. The counterpart of pack/screen.h.
 */

#include "pack/screen.h"

/* The normal, out of the solid, and the offset. */
void csg_textbook_plane(const struct csg_plane *plane, bool flipped, double texel[4]);

/* p.Ap + 2 q.p + r, scaled so that the largest of A (where A is zero, of q) is 1 in size; negated
 * where flipped. */
void csg_textbook_quadric(const struct csg_quadric *quadric, bool flipped,
                          double texels[CSG_QUADRIC_TEXELS][4]);

/* q and the columns of A: the gradient at p is terms[0] + p.x terms[1] + p.y terms[2] + ... */
void csg_textbook_normal(const struct csg_quadric *quadric, float terms[4][3]);

/* The ray through the picture's middle and its steps per pixel, as uniforms. */
struct csg_textbook_rays {
    float origin[9], direction[9];
    float start;
};

struct csg_textbook_rays csg_textbook_rays(const struct csg_screen *screen, struct csg_pixel at);

#endif
