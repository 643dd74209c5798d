/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_PRECISION_H
#define CSG_PACK_PRECISION_H

/*
 * Which objects float does not hold in this view, and why: what their geometry needs
 * (sharpness/sharpness.h) against what the shader's float keys resolve where they are. Those are
 * drawn in double. docs/numerics.md has the bounds.
 */

#include "pack/screen.h"
#include "sharpness/sharpness.h"

enum csg_reason {
    CSG_REASON_THICKNESS = CSG_FINE_THICKNESS,
    CSG_REASON_CURVATURE = CSG_FINE_CURVATURE,
    CSG_REASON_ANGLE = CSG_FINE_ANGLE,
    CSG_REASON_GAP = CSG_FINE_GAP,
    CSG_REASON_VIEW = CSG_NUM_FINE, /* the picture shows a part that small */
    CSG_REASON_DEPTH,               /* the eye is close to a surface that reaches far */
    CSG_REASON_STIFF,               /* rays nearly along a quadric, or the eye close to it */
    CSG_REASON_SHARED,              /* shares a surface with another object that needs it */
    CSG_REASON_ASKED,               /* --variant=double */
    CSG_NUM_REASONS
};

struct csg_precision {
    bool precise;
    bool zoomed; /* so little of the scene is in the picture that the depth buffer is too coarse */
    uint8_t reason;
    uint32_t leaf;   /* where it was found */
    double size;     /* of what is to be resolved; radians for CSG_REASON_ANGLE */
    double resolved; /* what float resolves there, in scene units; DEPTH, STIFF: error of a depth,
                      * relative */
};

/* object: its index; focus: what stands for it where it is unbounded. */
struct csg_precision csg_precision_of(const struct csg_screen *screen,
                                      const struct csgcast_scene *scene, size_t object,
                                      const struct csg_box *focus);

/* What an object needs, short of planes that meet nearly parallel: the largest error of a key, as a
 * length, that leaves it right. And whether float keys suffice for that between these depths. */
double csg_precision_need(const struct csg_sharpness *sharp);
bool csg_precision_suffices(const struct csg_screen *screen, const double range[2], double need);

/* Depths of the box along the view axis; [0] at least 0 in perspective. */
void csg_depth_range(const struct csg_screen *screen, const struct csg_box *box, double range[2]);

/* The largest error, relative, of depths that a quadric's crossings have in float over the
 * rectangle in pixels, from samples; depth: of the leaf, nearest and furthest. */
double csg_quadric_error(const struct csg_screen *screen, struct csg_pixel at,
                         const struct csg_rect *rect, const double depth[2],
                         const double texels[CSG_QUADRIC_TEXELS][4]);

/* Above this they count as CSG_REASON_STIFF. */
#define CSG_MAX_DEPTH_ERROR 1e-6

/* For people: "5e-06 thick, float resolves 2e-05 there". */
void csg_precision_explain(const struct csg_precision *precision, char *text, size_t size);

#endif
