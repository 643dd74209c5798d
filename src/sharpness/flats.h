/* SPDX-License-Identifier: MIT */
#ifndef CSG_SHARPNESS_FLATS_H
#define CSG_SHARPNESS_FLATS_H

/* The planes of an object, in an order in which nearly parallel ones are neighbours. */

#include "common/keys.h"
#include "sharpness/sharpness.h"

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
    struct csg_keys keys;           /* by place */
    CSG_ARRAY(struct csg_flat) sorted;
    CSG_ARRAY(double) other_places; /* of the sorted ones */
    CSG_ARRAY(double) sides[2]; /* heights of those, not turned and turned, of others infinity */
};

/* Of a leaf's face on that carrier. false: out of memory. */
bool csg_flats_add(struct csg_flats *flats, const struct csg_plane *plane, uint32_t carrier,
                   uint32_t leaf, bool turned);

/* Where the planes meet, or do not. */
struct csg_ball {
    struct csg_vec3 center;
    double radius;
};

/* Puts them into their order, with heights above the center. false: out of memory. */
bool csg_flats_sort(struct csg_flats *flats, struct csg_vec3 center);

/* Notes angles and gaps, over the ball, between those from begin to end and what follows them.
 * They are sorted, with heights above the ball's center. */
void csg_flats_note(const struct csg_flats *flats, const struct csgcast_scene *scene, size_t begin,
                    size_t end, const struct csg_ball *ball, struct csg_sharpness *sharp);

void csg_flats_finish(struct csg_flats *flats);

#endif
