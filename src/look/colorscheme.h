/* SPDX-License-Identifier: MIT */
#ifndef CSG_LOOK_COLORSCHEME_H
#define CSG_LOOK_COLORSCHEME_H

/* OpenSCAD 2021.01's colour schemes (color-schemes/render/, ColorMap.cc). Components 0 to 1. */

#include "csg/scene.h"

struct csg_colorscheme {
    const char *name;
    float background[3];
    float face[3]; /* a solid without color() */
    float cut[3];  /* a face that a subtracted solid without color() has left */
};

/* NULL or a name in any case; NULL when there is no such scheme. */
const struct csg_colorscheme *csg_colorscheme_find(const char *name);

/*
 * The colour of a leaf's face before shading. subtracted: the leaf is. Its faces are then cuts, and
 * take minuend's colour where that is not NULL. r g b a; a component that color() leaves negative
 * takes the scheme's.
 */
void csg_face_color(const struct csg_colorscheme *scheme, const struct csg_leaf *leaf,
                    const struct csg_leaf *minuend, enum csg_layer layer, bool subtracted,
                    float rgba[4]);

/*
 * OpenSCAD's light (GLView.cc): two opposite directional lights in eye space, two-sided. The
 * returned factor multiplies the colour; normal in world space, camera axes as in csgcast_frustum.
 */
double csg_light_factor(const struct csgcast_frustum *frustum, struct csg_vec3 normal);

/* num components of a colour as bytes; outside 0 to 1, NaN included, the nearest thing to it. */
void csg_color_bytes(uint8_t *bytes, const float *components, size_t num);

/* Direction of the light in eye space (x right, y up, z to the viewer), and the ambient part. */
#define CSG_LIGHT_X (-0.57735026919)
#define CSG_LIGHT_Y 0.57735026919
#define CSG_LIGHT_Z 0.57735026919
#define CSG_LIGHT_AMBIENT 0.2

#endif
