/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_SCREEN_H
#define CSG_PACK_SCREEN_H

/*
 * Carriers as the screen sees them.
 *
 * Along the ray of pixel (x, y) let t be the distance along the view axis. csgcast measures it by
 * the depth key
 *     k = A - B / t   (perspective)        k = t - T   (orthographic),
 * which grows along the ray. In homogeneous coordinates the ray's point then is P(x, y) + k W with
 * W constant and P affine in x and y. So, computed in double once per frame,
 *     a plane's crossing    k = c0 + cu x + cv y,
 *     a quadric's crossings k = m(x, y) -+ sqrt(h(x, y)), m affine and h a conic,
 *     a surface normal      n = n0 + nu x + nv y + nk k,
 * with (x, y) counted from a pixel near the object. The shader evaluates these few terms in float;
 * the cancellation that ruins the textbook quadratic (eye far away, axis askew) happens in double.
 * This is Sigg et al. 2006, section 3 (rays parametrised by window depth), with the origin of
 * pixels and depth moved to where the object is. docs/numerics.md has the derivation and figures.
 */

#include "carrier/carrier.h"
#include "common/layout.glsl" /* from shaders/: what C and GLSL share */

/* Drivers run programs for whole blocks of pixels, and so for those beside what is drawn: llvmpipe
 * for 4 by 4, GPUs for 2 by 2. Tables by pixel hold these as well: what is read from nowhere may
 * send a loop round and round, which llvmpipe ends for all of the block (shaders/csg/turns.glsl).
 */
#define CSG_PIXEL_BLOCK 4

struct csg_screen {
    int width, height;
    bool orthographic;
    bool textbook;                                         /* keys are t: pack/textbook.h */
    struct csg_vec3 origin, origin_dx, origin_dy;          /* ray origin; steps per pixel */
    struct csg_vec3 direction, direction_dx, direction_dy; /* at pixel coordinates (0, 0) */
    struct csg_vec3 forward;
    double a, b;    /* perspective: k = a - b / t; orthographic: k = t - a, b = 1 */
    double scale;   /* of the homogeneous coordinates, so that they are near 1 */
    double k_far;   /* key at t = infinity; larger keys are behind the eye */
    double near;    /* t at which rays start, see csg_eye_near; orthographic: none */
    float depth[4]; /* see csg_screen_depth in shaders/common/screen.glsl */
};

/* The pixel around which an object's terms are written. GL's pixels: y upwards, centres at .5. */
struct csg_pixel {
    double x, y;
};

/* The ray through a pixel; what of it does not change with the pixel has steps of 0. */
static inline struct csg_vec3 csg_screen_origin(const struct csg_screen *screen,
                                                struct csg_pixel at)
{
    return csg_add(screen->origin,
                   csg_add(csg_scale(at.x, screen->origin_dx), csg_scale(at.y, screen->origin_dy)));
}

static inline struct csg_vec3 csg_screen_direction(const struct csg_screen *screen,
                                                   struct csg_pixel at)
{
    return csg_add(screen->direction, csg_add(csg_scale(at.x, screen->direction_dx),
                                              csg_scale(at.y, screen->direction_dy)));
}

/* focus: decides where keys are finest; bounded: nothing that will be drawn is outside of it. */
void csg_screen_init(struct csg_screen *screen, const struct csgcast_frustum *frustum, int width,
                     int height, const struct csg_box *focus, bool bounded);

/* Makes t itself the key, for the variant "textbook". focus and bounded as in csg_screen_init. */
void csg_screen_use_textbook(struct csg_screen *screen, const struct csg_box *focus, bool bounded);

/* Where rays start: what is nearer than t has happened. Perspective only. */
void csg_screen_set_near(struct csg_screen *screen, double t);

/* Whether rays start in a box, or may; in an empty one none does. */
bool csg_screen_eye_is_in(const struct csg_screen *screen, const struct csg_box *box);

/* Screen rectangle in pixels, clipped to the screen. */
struct csg_rect {
    double lo[2], hi[2];
};

static inline bool csg_rect_is_empty(const struct csg_rect *rect)
{
    return !(rect->lo[0] < rect->hi[0] && rect->lo[1] < rect->hi[1]);
}

/* In pixels; of one that is not empty. */
static inline double csg_rect_area(const struct csg_rect *rect)
{
    return (rect->hi[0] - rect->lo[0]) * (rect->hi[1] - rect->lo[1]);
}

/* The part of the screen that a mapped box can cover; all of it when the box crosses the eye
 * plane. */
struct csg_rect csg_screen_rect(const struct csg_screen *screen, const struct csg_map *frame,
                                const struct csg_box *box);

/* The key of a distance along the view axis. */
double csg_screen_key(const struct csg_screen *screen, double t);

/* Keys of planes are smaller than this, so that CSG_KEY_MAX + key is CSG_KEY_MAX in float. */
#define CSG_PLANE_KEY_MAX 1e20

/* A plane's texel: c0, cu, cv and 1 for an entry, -1 for an exit, into the side that the plane's
 * normal points away from (flipped: that it points to). */
void csg_screen_plane(const struct csg_screen *screen, struct csg_pixel at,
                      const struct csg_plane *plane, bool flipped, double texel[4]);

/*
 * A quadric's texels (see shaders/solids/quadric.glsl). convex and sheet as in csg_shape, center:
 * a point of the leaf, near which the terms are to be most accurate; radius: of the leaf.
 */
void csg_screen_quadric(const struct csg_screen *screen, struct csg_pixel at,
                        const struct csg_quadric *quadric, bool flipped, bool convex, int sheet,
                        struct csg_vec3 center, double radius,
                        double texels[CSG_QUADRIC_TEXELS][4]);

/* The quadric's f where rays cross a plane, texel of csg_screen_plane, but for a factor: a conic of
 * the pixel, counted from at (1, x, y, xx, xy, yy), negative inside. */
void csg_screen_section(const struct csg_screen *screen, struct csg_pixel at,
                        const struct csg_quadric *quadric, bool flipped, const double plane[4],
                        double conic[6]);

/* An affine term of the pixel that is near the keys of a quadric's surface where its leaf is, for
 * keys written relative to it; texels: of csg_screen_quadric. */
void csg_screen_base(const struct csg_screen *screen, const double texels[CSG_QUADRIC_TEXELS][4],
                     struct csg_vec3 center, double radius, float base[3]);

/* Terms n0 nu nv nk of the normal of a quadric's surface: gradient of f, not normalised. nk is for
 * keys relative to base. */
void csg_screen_normal(const struct csg_screen *screen, struct csg_pixel at,
                       const struct csg_quadric *quadric, const float base[3], float terms[4][3]);

/* The pixel that shows point, clamped to the screen. */
struct csg_pixel csg_screen_pixel(const struct csg_screen *screen, struct csg_vec3 point);

#endif
