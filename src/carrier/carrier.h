/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_CARRIER_H
#define CSG_CARRIER_CARRIER_H

/*
 * Carriers: the distinct planes and quadrics of a scene. Faces that coincide share one carrier,
 * so every program computes their crossings from the same numbers and gets the same bits; equal
 * crossings then are one event, and flush cuts, touching solids and equal solids come out as the
 * regularised Boolean has them (docs/coincidence.md).
 */

#include <stdint.h>

#include "csg/scene.h"

/* A leaf's face on a carrier: carrier index and whether the leaf's inside is the other side. */
struct csg_face {
    uint32_t carrier;
    bool flipped;  /* a plane's normal is the carrier's, negated; a quadric's inside is f >= 0 */
    bool is_other; /* its own plane is not the carrier's to the last bit */
};

struct csg_carriers {
    struct csg_plane *planes;
    size_t num_planes, num_quadrics;
    size_t planes_capacity;
    struct csg_box *quadric_boxes; /* see csg_carrier_quadric_box; NULL: those of the leaves */
    uint32_t *quadric_leaves;      /* whose quadric each is: csg_carrier_quadric */
    size_t quadric_leaves_capacity;
    size_t num_unused_planes, num_unused_quadrics; /* an edit has left them without faces */
    size_t num_shared;                             /* faces that found an earlier face's carrier */
    size_t num_own; /* planes of surfaces that nothing else can lie on: not in planes[] */

    uint32_t *face_begin;           /* num_leaves + 1: leaf's plane faces in faces[] */
    struct csg_face *faces;         /* of planes, in the order of the leaf's shape; of a surface
                                     * whose faces are all its own there are none */
    struct csg_face *quadric_faces; /* per leaf; carrier CSG_NO_CARRIER where it has none */
    int8_t *sheets;                 /* per leaf: shape.sheet, in the carrier's canonical space */
    bool *renewed; /* after an edit, by leaf: it or a carrier of its faces has changed; or NULL */
    struct csg_carrier_builder *kept; /* in scenes that are edited, for the next edit; or NULL */
};

/* Of a surface's face: it is its own, see csg_carrier_of_face. */
#define CSG_NO_CARRIER UINT32_MAX

/* Plane faces of the leaf. */
uint32_t csg_num_faces(const struct csgcast_scene *scene, uint32_t leaf);

/* The carrier of a plane face. Of surfaces most are the surface's own planes, which all copies
 * share; they are only made where they are asked for. inverse: of the leaf's shape.frame. */
struct csg_plane csg_carrier_of_face(const struct csgcast_scene *scene, uint32_t leaf,
                                     uint32_t face, const struct csg_map *inverse, bool *flipped);

/* The quadric of a carrier; the scene's leaves are those that its carriers were made from. */
static inline const struct csg_quadric *csg_carrier_quadric(const struct csgcast_scene *scene,
                                                            const struct csg_carriers *carriers,
                                                            uint32_t carrier)
{
    return &scene->leaves[carriers->quadric_leaves[carrier]].shape.quadric;
}

/* The box of what can be seen of it, world space. */
static inline const struct csg_box *csg_carrier_quadric_box(const struct csgcast_scene *scene,
                                                            const struct csg_carriers *carriers,
                                                            uint32_t carrier)
{
    return carriers->quadric_boxes ? &carriers->quadric_boxes[carrier]
                                   : &scene->leaves[carriers->quadric_leaves[carrier]].box;
}

/*
 * Two faces coincide when, over the later leaf's bounds, they are nowhere further apart than both
 * leaves' rounding together plus this share of the coordinates' size: noise of the double
 * arithmetic that placed them (about 1e-15 per operation), with three digits to spare.
 */
#define CSG_COINCIDENT_RELATIVE 1e-11

/* keeps: what csg_carriers_edit needs. The result does not depend on it. NULL: out of memory. */
struct csg_carriers *csg_carriers_create(const struct csgcast_scene *scene, bool keeps);
void csg_carriers_destroy(struct csg_carriers *carriers);

#endif
