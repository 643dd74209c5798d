/* SPDX-License-Identifier: MIT */
#ifndef CSG_SHARPNESS_SHARPNESS_H
#define CSG_SHARPNESS_SHARPNESS_H

/*
 * How fine an object's geometry is, whatever the view: what numbers have to resolve. The frame
 * compares it with the rounding of float there and draws in double where that is too coarse
 * (pack/precision.h).
 */

#include <stdint.h>

#include "csg/object.h"

struct csg_before;
struct csg_surveyor;

enum csg_fineness {
    CSG_FINE_THICKNESS, /* of a solid: the least height of its box */
    CSG_FINE_CURVATURE, /* least radius of curvature of a quadric */
    CSG_FINE_ANGLE,     /* radians, between two planes that meet in the object, nearly parallel */
    CSG_FINE_GAP,       /* between two surfaces that nearly coincide */
    CSG_NUM_FINE
};

/* Lengths in scene units; infinite where there is nothing of the sort. */
struct csg_sharpness {
    double least[CSG_NUM_FINE];
    uint32_t leaf[CSG_NUM_FINE]; /* where it was found */
};

/* Two planes at a larger angle are never a matter of precision. */
#define CSG_FINE_MAX_ANGLE 1e-2

/* Smaller shares of the coordinates, and angles, are rounding: what decomposing a polygon leaves
 * over. */
#define CSG_FINE_NOISE 1e-11

/* Every surface of an object is compared with so many of its neighbours in an order in which those
 * like it are near: with all, in objects of that size. */
#define CSG_FINE_NEIGHBOURS 64

/* Of objects. Those of one solid are most of a large scene, and found soon: theirs is not kept. */
struct csg_sharpnesses {
    uint32_t *places; /* by object: its place in kept, or CSG_SHARPNESS_OF_ONE */
    struct csg_sharpness *kept;
    struct csg_surveyor *surveyor; /* that measures anew, or NULL */
};

#define CSG_SHARPNESS_OF_ONE UINT32_MAX

/* before: of an edit, or NULL: what has not changed since is taken from there, which makes no
 * difference. NULL: out of memory. */
struct csg_sharpnesses *csg_sharpness_create(const struct csgcast_scene *scene,
                                             const struct csg_before *before);
void csg_sharpness_destroy(struct csg_sharpnesses *sharpness);

/* That of scene->sharpness for an object. Out of memory: as if it were as fine as can be. */
struct csg_sharpness csg_sharpness_of(const struct csgcast_scene *scene, size_t object);

/* Measures these objects anew, whatever is kept; and exchanges that with what is kept of them.
 * false: out of memory. */
bool csg_sharpness_measure(const struct csgcast_scene *scene, const uint32_t *objects, size_t num,
                           struct csg_sharpness *out);
void csg_sharpness_swap(struct csg_sharpnesses *sharpness, const uint32_t *objects, size_t num,
                        struct csg_sharpness *other);

/* The value, where it is the least. */
void csg_sharpness_note(struct csg_sharpness *sharp, enum csg_fineness what, double value,
                        uint32_t leaf);

#endif
