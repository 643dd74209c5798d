/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_FLATS_H
#define CSG_CSG_FLATS_H

/* The planes of an object, in an order in which nearly parallel ones are neighbours. */

#include "csg/sharpness.h"

struct csg_flat {
    struct csg_vec3 normal; /* of n and -n always the same one */
    double height;          /* of the plane above the object's middle */
    double place;           /* nearly parallel ones have nearly the same, */
    double other_place;     /* ... and nearly this as well */
    uint32_t carrier, leaf;
    bool turned; /* the solid is on the other side */
};

/* Zero-initialise it. */
struct csg_flats {
    CSG_ARRAY(struct csg_flat) all; /* in the order of the file */
    CSG_ARRAY(struct csg_flat_key {
        uint64_t place; /* bits of it */
        uint32_t flat;
    })
    keys, room;
    CSG_ARRAY(struct csg_flat) sorted;
    CSG_ARRAY(double) other_places; /* of the sorted ones */
    CSG_ARRAY(double) sides[2]; /* heights of those, not turned and turned, of others infinity */
};

/* Of a leaf's face on that carrier. false: out of memory. */
bool csg_flats_add(struct csg_flats *flats, const struct csg_plane *plane, uint32_t carrier,
                   uint32_t leaf, bool turned);

/* Notes angles and gaps between the planes over a ball around the center. false: out of memory. */
bool csg_flats_note(struct csg_flats *flats, struct csg_vec3 center, double radius,
                    struct csg_sharpness *sharp);

void csg_flats_finish(struct csg_flats *flats);

#endif
