/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_OWNERS_H
#define CSG_CROWD_OWNERS_H

/*
 * Who may show at a pixel of a relief (crowd/relief.h). Nearly everywhere that is one member, which
 * then owns the pixel: such pixels are drawn all at once, each with its owner's terms, however many
 * members there are (shaders/passes/owned.vert.glsl). Members that may show where others may too,
 * the rivals, are drawn there as instances.
 */

#include <stdatomic.h>

#include "crowd/cast.h"

#define CSG_NOBODY UINT32_MAX

struct csg_owners {
    int width, height;
    size_t stride;       /* of the rows of who and least, as of a relief's keys */
    uint32_t *who;       /* a member, CSG_NOBODY or CSG_SEVERAL */
    float *least;        /* nothing of these is nearer; infinite where there is nobody */
    atomic_bool *rivals; /* per member: it may show at some pixel where others may; the caller's */
    atomic_bool *owns;   /* per member: known after csg_owners_note */
};

/* false: out of memory. */
bool csg_owners_init(struct csg_owners *owners, int width, int height, size_t num_members,
                     atomic_bool *rivals);
void csg_owners_finish(struct csg_owners *owners);

/* Nobody shows in rows [begin, end): to be called for each before anything else. */
void csg_owners_clear(const struct csg_owners *owners, int begin, int end);

/* Notes at num pixels of a row from (x, y) on whether member who may show, and what it hides; keys
 * are the relief's there. Whether it may show. The rest is as csg_cast_draw has it. */
bool csg_owners_contend(const struct csg_owners *owners, const struct csg_cast *cast, uint32_t who,
                        int x, int y, float dx, float dy, int num, float *keys);

/* The pixels of those, as bits, at which several may show. */
unsigned csg_owners_contested(const struct csg_owners *owners, int x, int y, int num);

/* Pixels with an owner, and a rectangle around them, both ends included. */
struct csg_owned {
    size_t num;
    int lo[2], hi[2];
};

/* Notes who owns pixels in rows [begin, end), which are finished, and where owners are hidden by
 * what cannot own; keys as above. */
struct csg_owned csg_owners_note(const struct csg_owners *owners, int begin, int end,
                                 const float *keys);

#endif
